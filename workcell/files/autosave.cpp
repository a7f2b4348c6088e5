// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "config/user_folders.h"
#include "geometry/system/scratch_folder.h"
#include "workcell/files/content_name.h"
#include "workcell/format/document_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

fs::path stateFolder() {
  const auto folder = config::userStateFolder();
  return folder ? *folder : fs::path();
}

fs::path lockIn(const fs::path& run) {
  return run / "lock";
}
/// Says what the copy is a copy of.
fs::path factsIn(const fs::path& run) {
  return run / "copy.json";
}

std::string factsText(const CopyFacts& facts) {
  const nlohmann::ordered_json json{{"document", facts.document.string()},
                                    {"base", facts.base},
                                    {"as_saved", facts.as_saved},
                                    {"counter", facts.counter}};
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// One more than any copy has that is there.
std::uint64_t nextCounter(const fs::path& run) {
  std::uint64_t most = copyFactsIn(run).counter;
  if (most != 0) return most + 1;
  std::error_code fault;
  for (fs::directory_iterator at(run.parent_path(), fault), end; !fault && at != end; at.increment(fault))
    most = std::max(most, copyFactsIn(at->path()).counter);
  return most + 1;
}

/// The lock's descriptor, to be closed; -1: another has it.
int takeLock(const fs::path& file, int flags) {
  const int lock = ::open(file.c_str(), O_RDWR | O_CLOEXEC | flags, 0600);
  if (lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  if (lock >= 0) ::close(lock);
  return -1;
}

bool isOver(const fs::path& run) {
  const int lock = takeLock(lockIn(run), 0);
  if (lock >= 0) ::close(lock);
  return lock >= 0;
}

/// What the run left; nothing where it left nothing that is of use.
std::optional<LeftWork> leftBy(const fs::path& run) {
  std::error_code fault;
  LeftWork left;
  left.run = run;
  if (fs::is_regular_file(copyIn(run), fault)) {
    left.copy = copyIn(run);
    left.time = fs::last_write_time(left.copy, fault);
    const CopyFacts facts = copyFactsIn(run);
    left.document = facts.document;
    left.counter = facts.counter;
    const std::string now = facts.document.empty() ? std::string() : contentNameOf(facts.document);
    if (!now.empty() && now == facts.as_saved) left.copy.clear();
    left.document_changed = changedOnDisk(facts.document, facts.base);
  }
  if (fs::is_regular_file(pictureIn(run), fault)) left.picture = pictureIn(run);
  if (const auto note = readFileContent(crashNoteIn(run))) {
    left.crash = note->substr(0, note->find('\n'));
    if (left.copy.empty()) left.time = fs::last_write_time(crashNoteIn(run), fault);
  }
  if (left.copy.empty() && left.crash.empty()) return std::nullopt;
  return left;
}

}  // namespace

fs::path runsFolder() {
  return stateFolder() / "runs";
}
fs::path copyIn(const fs::path& run) {
  return run / "copy.hcell";
}
fs::path pictureIn(const fs::path& run) {
  return run / "picture.jpg";
}
fs::path crashNoteIn(const fs::path& run) {
  return run / "crash.txt";
}

RunFolder::~RunFolder() {
  if (lock_ < 0) return;
  std::error_code ignored;
  if (!fs::exists(copyIn(path_), ignored)) discardLeftWork(path_);
  ::close(lock_);
}

Expected<fs::path> RunFolder::path() {
  if (lock_ >= 0) return path_;
  HAPTICELL_TRY(config::userStateFolder());
  const fs::path folder = runsFolder();
  std::error_code fault;
  HAPTICELL_TRY(config::makeOwnFolder(folder));
  // Others look at it once it has its name: by then it is locked.
  auto aside = ScratchFolder::make(folder);
  HAPTICELL_TRY(aside);
  lock_ = takeLock(lockIn(aside->path()), O_CREAT);
  if (lock_ < 0)
    return makeError({.file = folder.string(),
                      .found = "files in this folder cannot be locked",
                      .expected = "a folder on a local disk"});
  const std::string drawn = aside->path().filename().string();
  path_ = folder / ("run" + drawn.substr(drawn.rfind('-')));
  auto moved = aside->moveTo(path_, true);
  if (moved) return path_;
  ::close(std::exchange(lock_, -1));
  return makeError(moved.error());
}

void RunFolder::discardCopy() {
  if (lock_ < 0) return;
  std::error_code ignored;
  for (const fs::path& file : {copyIn(path_), pictureIn(path_), factsIn(path_)}) fs::remove(file, ignored);
}

Expected<void> RunFolder::adopt(const fs::path& left) {
  const auto own = path();
  HAPTICELL_TRY(own);
  discardCopy();
  std::error_code fault, ignored;
  // Both stand equally deep: what the copy names relative to its folder is still found.
  if (fs::exists(factsIn(left), ignored)) fs::rename(factsIn(left), factsIn(*own), fault);
  if (!fault) fs::rename(copyIn(left), copyIn(*own), fault);
  if (fault)
    return makeError(
        {.file = left.string(), .found = fault.message(), .expected = "a recovery copy that can be moved"});
  fs::rename(pictureIn(left), pictureIn(*own), ignored);
  discardLeftWork(left);
  return {};
}

Expected<void> autosave(const DocumentState& state, const fs::path& document, const fs::path& run,
                        const std::string& base) {
  CopyFacts facts;
  facts.base = base;
  facts.counter = nextCounter(run);
  if (!document.empty()) {
    facts.document = fs::absolute(document);
    facts.as_saved = contentName(documentText(state, facts.document.parent_path()));
  }
  // The copy last: newer facts beside an older copy do no harm, the other way round it might be taken for saved.
  return writeFilesAtomically({{factsIn(run), factsText(facts)}, {copyIn(run), documentText(state, run)}});
}

CopyFacts copyFactsIn(const fs::path& run) {
  CopyFacts facts;
  const auto text = readFileContent(factsIn(run));
  if (!text) facts.document = readFileContent(run / "document").value_or("");  // As earlier programs wrote it.
  const auto json = text ? nlohmann::json::parse(*text, nullptr, false) : nlohmann::json();
  const auto take = [&json](const char* key, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    const auto found = json.is_object() ? json.find(key) : json.end();
    if (found == json.end()) return;
    if (std::is_same_v<Value, std::string> ? found->is_string() : found->is_number_unsigned())
      value = found->template get<Value>();
  };
  std::string document;
  take("document", document);
  take("base", facts.base);
  take("as_saved", facts.as_saved);
  take("counter", facts.counter);
  if (!document.empty()) facts.document = document;
  return facts;
}

std::vector<LeftWork> findLeftWork() {
  std::vector<LeftWork> found;
  std::error_code fault;
  // What others may have put there is no work of this user.
  if (stateFolder().empty() || !config::checkUserFile(runsFolder())) return found;
  removeUnfinished(runsFolder());
  for (fs::directory_iterator at(runsFolder(), fault), end; !fault && at != end; at.increment(fault)) {
    const fs::path run = fs::absolute(at->path());
    if (run.filename().string().starts_with(".") || !isOver(run)) continue;
    if (auto left = leftBy(run))
      found.push_back(std::move(*left));
    else
      discardLeftWork(run);
  }
  std::sort(found.begin(), found.end(), [](const LeftWork& a, const LeftWork& b) {
    return a.counter != b.counter ? a.counter > b.counter : a.time > b.time;
  });
  return found;
}

void discardLeftWork(const fs::path& run) {
  std::error_code ignored;
  fs::remove_all(run, ignored);
}

}  // namespace hapticell::workcell
