// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/document_lock.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "geometry/system/atomic_file.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

std::string hostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string userName() {
  const passwd* const entry = ::getpwuid(::geteuid());
  return entry ? entry->pw_name : std::to_string(::geteuid());
}

std::string localTime() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  ::localtime_r(&now, &parts);
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
  return text.data();
}

/// When a process of this machine began, in ticks; 0: not found.
std::uint64_t startOf(std::int64_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto name_end = text.rfind(')');  // Its name may hold anything.
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(text.substr(name_end + 1));
  constexpr int kFieldsBefore = 19;  // From the state (3) to starttime (22).
  std::string skipped;
  for (int i = 0; i < kFieldsBefore; ++i) fields >> skipped;
  std::uint64_t start = 0;
  fields >> start;
  return start;
}

std::optional<DocumentOwner> readOwner(int file) {
  constexpr std::size_t kMost = 4096;
  std::string text(kMost, '\0');
  const ssize_t size = ::pread(file, text.data(), text.size(), 0);
  if (size <= 0) return std::nullopt;
  text.resize(static_cast<std::size_t>(size));
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  DocumentOwner owner;
  const auto take = [&json](const char* key, auto& value) {
    const auto found = json.find(key);
    using Value = std::remove_reference_t<decltype(value)>;
    if (found == json.end() || (std::is_same_v<Value, std::string> ? !found->is_string() : !found->is_number_integer()))
      return;
    value = found->template get<Value>();
  };
  take("user", owner.user);
  take("host", owner.host);
  take("since", owner.since);
  take("process", owner.process);
  take("process_start", owner.process_start);
  return owner;
}

void writeOwner(int file) {
  const std::int64_t process = ::getpid();
  const nlohmann::ordered_json json{{"program", "HaptiCell"},
                                    {"user", userName()},
                                    {"host", hostName()},
                                    {"process", process},
                                    {"process_start", startOf(process)},
                                    {"since", localTime()}};
  const std::string text = json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  // Whole or not does not matter: what is no owner's name counts for nothing once its lock is gone.
  if (::ftruncate(file, 0) == 0) (void)!::pwrite(file, text.data(), text.size(), 0);
}

bool isStillCalled(int file, const fs::path& name) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::lstat(name.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

/// Removes what programs of this machine that died left in a folder. Of other machines and programs nothing is touched.
void removeDeadLocks(const fs::path& folder) {
  std::error_code fault;
  std::vector<fs::path> found;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(".") && name.ends_with(".lock")) found.push_back(at->path());
  }
  for (const fs::path& name : found) {
    const int file = ::open(name.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) continue;
    const bool is_free = ::flock(file, LOCK_EX | LOCK_NB) == 0 && isStillCalled(file, name);
    const auto owner = is_free ? readOwner(file) : std::nullopt;
    if (owner && owner->host == hostName() && owner->process_start != 0) ::unlink(name.c_str());
    ::close(file);
  }
}

/// Text of others, for one line of a message.
std::string plain(const std::string& text) {
  constexpr std::size_t kMost = 64;
  std::string kept = text.substr(0, kMost);
  for (char& c : kept)
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
  return kept;
}

}  // namespace

Text DocumentOwner::words() const {
  Text text = user.empty() ? Text("an unknown user") : Text(plain(user));
  if (!host.empty()) text = Text("%1 on %2", text, plain(host));
  if (!since.empty()) text = Text("%1 since %2", text, plain(since));
  if (process != 0) text = Text("%1 (process %2)", text, process);
  return text;
}

fs::path lockOf(const fs::path& document) {
  const auto place = placeOfFile(document);
  const fs::path file = place ? *place : document;
  return file.parent_path() / ("." + file.filename().string() + ".lock");
}

DocumentLock DocumentLock::take(const fs::path& document) {
  DocumentLock taken;
  taken.path_ = fs::absolute(lockOf(document));
  removeDeadLocks(taken.path_.parent_path());
  taken.lock(false);
  return taken;
}

Expected<DocumentLock> DocumentLock::takeForWriting(const fs::path& document) {
  DocumentLock taken = take(document);
  if (!taken.owner()) return taken;
  return makeError({.file = document.string(),
                    .found = Text("the file is already open in HaptiCell: %1", taken.owner()->words()),
                    .expected = "a file that nobody else has open",
                    .fix = "Close it there, or choose another name."});
}

void DocumentLock::lock(bool over_other_machines) {
  owner_.reset();
  // Tries when a lock is removed at the same moment. Half: enough; twice: time, where another program removes it all
  // the time.
  constexpr int kMostTries = 20;
  for (int tries = 0; tries < kMostTries && file_ < 0; ++tries) {
    const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644);
    if (file < 0) {
      // Another user's lock: it can be read, and asked.
      const int readable = errno == EACCES ? ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK) : -1;
      if (readable < 0) return;
      if (::flock(readable, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        owner_ = readOwner(readable).value_or(DocumentOwner());
      ::close(readable);
      return;
    }
    const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    const bool is_taken = !locked && errno == EWOULDBLOCK;
    if (!is_taken && !isStillCalled(file, path_)) {  // Its owner has just gone.
      ::close(file);
      continue;
    }
    const auto owner = readOwner(file);
    const bool lives_here = owner && owner->host == hostName() && owner->process_start != 0 &&
                            startOf(owner->process) == owner->process_start;
    const bool may_live_there = owner && !owner->host.empty() && owner->host != hostName() && !over_other_machines;
    // Where a disk knows no locks, the owner's process tells.
    if (is_taken || may_live_there || (!locked && lives_here)) {
      owner_ = owner.value_or(DocumentOwner());
      ::close(file);
      return;
    }
    writeOwner(file);
    file_ = file;
  }
}

bool DocumentLock::tryAgain() {
  if (!isHeld() && !path_.empty()) lock(false);
  return !owner_;
}

void DocumentLock::takeOver() {
  if (!isHeld() && !path_.empty()) lock(true);
}

void DocumentLock::release() {
  if (file_ < 0) return;
  if (isStillCalled(file_, path_)) ::unlink(path_.c_str());
  ::close(std::exchange(file_, -1));
}

DocumentLock::DocumentLock(DocumentLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), owner_(std::move(other.owner_)) {}

DocumentLock& DocumentLock::operator=(DocumentLock&& other) noexcept {
  if (this == &other) return *this;
  release();
  path_ = std::move(other.path_);
  file_ = std::exchange(other.file_, -1);
  owner_ = std::move(other.owner_);
  return *this;
}

DocumentLock::~DocumentLock() {
  release();
}

}  // namespace hapticell::workcell
