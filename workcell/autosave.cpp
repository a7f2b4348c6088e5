// SPDX-License-Identifier: Apache-2.0
#include "workcell/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "workcell/document_io.h"
#include "workcell/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

fs::path stateFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state) return fs::path(state) / "hapticell";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".local/state/hapticell";
  return fs::temp_directory_path() / "hapticell";
}

fs::path lockIn(const fs::path& run) {
  return run / "lock";
}
/// Names the document that the copy belongs to.
fs::path nameIn(const fs::path& run) {
  return run / "document";
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
    if (const auto name = readFileContent(nameIn(run))) left.document = *name;
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
  const fs::path folder = fs::absolute(runsFolder());
  std::error_code fault;
  fs::create_directories(folder, fault);
  // Others look at it once it has its name: by then it is locked.
  std::string aside = (folder / ".run-XXXXXX").string();
  if (!::mkdtemp(aside.data()))
    return makeError({folder.string(), "", std::strerror(errno), "a folder that may be written", ""});
  lock_ = takeLock(lockIn(aside), O_CREAT);
  path_ = folder / fs::path(aside).filename().string().substr(1);
  if (lock_ >= 0) fs::rename(aside, path_, fault);
  if (lock_ >= 0 && !fault) return path_;
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  fs::remove_all(aside, fault);
  return makeError({folder.string(), "", "no file can be locked there", "a folder on a local disk", ""});
}

void RunFolder::discardCopy() {
  if (lock_ < 0) return;
  std::error_code ignored;
  for (const fs::path& file : {copyIn(path_), pictureIn(path_), nameIn(path_)}) fs::remove(file, ignored);
}

Expected<void> RunFolder::adopt(const fs::path& left) {
  const auto own = path();
  if (!own) return makeError(own.error());
  discardCopy();
  std::error_code fault, ignored;
  // Both stand equally deep: what the copy names relative to its folder is still found.
  if (fs::exists(nameIn(left), ignored)) fs::rename(nameIn(left), nameIn(*own), fault);
  if (!fault) fs::rename(copyIn(left), copyIn(*own), fault);
  if (fault) return makeError({left.string(), "", fault.message(), "a copy that can be moved", ""});
  fs::rename(pictureIn(left), pictureIn(*own), ignored);
  discardLeftWork(left);
  return {};
}

Expected<void> autosave(const DocumentState& state, const fs::path& document, const fs::path& run) {
  std::error_code fault;
  if (document.empty()) {
    fs::remove(nameIn(run), fault);
  } else if (auto named = writeFileAtomically(nameIn(run), fs::absolute(document).string()); !named) {
    return named;
  }
  return writeFileAtomically(copyIn(run), documentText(state, run));
}

std::vector<LeftWork> findLeftWork() {
  std::vector<LeftWork> found;
  std::error_code fault;
  for (fs::directory_iterator at(runsFolder(), fault), end; !fault && at != end; at.increment(fault)) {
    const fs::path run = fs::absolute(at->path());
    if (run.filename().string().starts_with(".") || !isOver(run)) continue;
    if (auto left = leftBy(run))
      found.push_back(std::move(*left));
    else
      discardLeftWork(run);
  }
  std::sort(found.begin(), found.end(), [](const LeftWork& a, const LeftWork& b) { return a.time > b.time; });
  return found;
}

void discardLeftWork(const fs::path& run) {
  std::error_code ignored;
  fs::remove_all(run, ignored);
}

}  // namespace hapticell::workcell
