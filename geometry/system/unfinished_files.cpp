// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/unfinished_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/system/atomic_file.h"

namespace hapticell {

namespace fs = std::filesystem;

namespace {

/// ".hapticell-", six letters or digits, and an extension or none.
bool isUnfinishedName(std::string_view name) {
  constexpr std::string_view kBegin = ".hapticell-";
  constexpr std::size_t kDrawn = 6;
  if (!name.starts_with(kBegin)) return false;
  name.remove_prefix(kBegin.size());
  if (name.size() < kDrawn || (name.size() > kDrawn && name[kDrawn] != '.')) return false;
  return std::all_of(name.begin(), name.begin() + kDrawn, [](unsigned char c) { return std::isalnum(c) != 0; });
}

bool isStillCalled(const struct stat& open, const fs::path& name) {
  struct stat named {};
  return ::lstat(name.c_str(), &named) == 0 && named.st_ino == open.st_ino && named.st_dev == open.st_dev;
}

void removeIfDead(const fs::path& name) {
  const int file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return;
  struct stat facts {};
  const uid_t user = ::geteuid();
  const bool is_file = ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode);
  const bool is_ours = (is_file || S_ISDIR(facts.st_mode)) && (facts.st_uid == user || (is_file && user == 0));
  // Looked at again under the lock: it may have got its place meanwhile.
  if (is_ours && ::flock(file, LOCK_EX | LOCK_NB) == 0 && isStillCalled(facts, name)) {
    std::error_code ignored;
    is_file ? void(::unlink(name.c_str())) : void(fs::remove_all(name, ignored));
  }
  ::close(file);
}

}  // namespace

void removeUnfinished(const fs::path& folder) {
  std::error_code fault;
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  std::vector<fs::path> found;
  for (fs::directory_iterator at(place, fault), end; !fault && at != end; at.increment(fault)) {
    if (isUnfinishedName(at->path().filename().native())) found.push_back(at->path());
  }
  for (const fs::path& name : found) removeIfDead(name);
}

namespace unfinished {

bool take(int file, const fs::path& name) {
  const bool taken = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  if (!taken && errno == EWOULDBLOCK) return false;
  struct stat facts {};
  return ::fstat(file, &facts) == 0 && isStillCalled(facts, name);  // A disk without locks is never tidied.
}

void tidyOnce(const fs::path& folder) {
  using Clock = std::chrono::steady_clock;
  // s between two looks for what was left behind: none for each of many files. Half, twice: looks in a folder twice or
  // half as often.
  constexpr std::chrono::seconds kPause{10};
  static std::mutex mutex;
  static std::map<fs::path, Clock::time_point> tidied;
  static pid_t process = 0;
  {
    const std::scoped_lock lock(mutex);
    const auto now = Clock::now();
    if (std::exchange(process, ::getpid()) != ::getpid()) tidied.clear();  // A forked process is a start of its own.
    std::erase_if(tidied, [&](const auto& each) { return now - each.second > kPause; });
    if (!tidied.try_emplace(folder, now).second) return;
  }
  removeUnfinished(folder);
}

int flushFolder(const fs::path& folder) {
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return errno == EACCES ? 0 : errno;  // One may write into a folder that one may not read.
  const int fault = ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
  ::close(file);
  return fault;
}

mode_t userMask() {
  // Not umask(), which changes it for the other threads.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view kName = "Umask:";
    if (line.starts_with(kName)) return static_cast<mode_t>(std::strtoul(line.c_str() + kName.size(), nullptr, 8));
  }
  constexpr mode_t kUsual = 022;
  return kUsual;
}

}  // namespace unfinished

}  // namespace hapticell
