// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/scratch_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "geometry/system/unfinished_files.h"

namespace hapticell {

namespace fs = std::filesystem;

namespace {

/// Every file and folder below; 0 or errno.
int flushBelow(const fs::path& folder) {
  std::error_code fault;
  for (fs::recursive_directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    if (!at->is_regular_file(fault) && !at->is_directory(fault)) continue;
    const int file = ::open(at->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return errno;
    const int flushed = ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
    ::close(file);
    if (flushed != 0) return flushed;
  }
  return fault ? fault.value() : unfinished::flushFolder(folder);
}

}  // namespace

Expected<ScratchFolder> ScratchFolder::make(const fs::path& parent) {
  std::error_code fault;
  const fs::path folder = parent.empty() ? fs::temp_directory_path(fault) : fs::absolute(parent, fault);
  if (fault)
    return makeError({.file = parent.string(), .found = fault.message(), .expected = "a folder for temporary files"});
  unfinished::tidyOnce(folder);
  ScratchFolder made;
  // Names tried where a tidying process takes the folder first: a second try is rare. Half, twice: no effect.
  constexpr int kMostTries = 100;
  for (int tries = 0; tries < kMostTries; ++tries) {
    std::string name = (folder / unfinished::kPattern).string();
    if (::mkdtemp(name.data()) == nullptr) break;
    made.lock_ = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (made.lock_ < 0) continue;  // A tidying program was quicker.
    made.path_ = name;
    if (unfinished::take(made.lock_, made.path_)) return made;
    ::close(std::exchange(made.lock_, -1));
  }
  return makeError(
      {.file = folder.string(), .found = systemText(errno), .expected = "a folder that exists and is writable"});
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

ScratchFolder::~ScratchFolder() {
  if (lock_ < 0) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  ::close(lock_);
}

Expected<void> ScratchFolder::moveContentTo(const fs::path& folder, const fs::path& last) {
  int fault = flushBelow(path_);
  std::error_code problem;
  std::vector<fs::path> names;
  for (fs::directory_iterator at(path_, problem), end; !problem && at != end; at.increment(problem))
    if (at->path().filename() != last) names.push_back(at->path().filename());
  names.push_back(last);
  for (const fs::path& name : names)
    if (fault == 0 && ::rename((path_ / name).c_str(), (folder / name).c_str()) != 0) fault = errno;
  if (fault == 0) fault = unfinished::flushFolder(folder);
  if (fault == 0) return {};
  return makeError(
      {.file = folder.string(), .found = systemText(fault), .expected = "free space and permission to write"});
}

Expected<void> ScratchFolder::moveTo(const fs::path& place, bool is_private) {
  struct stat old {};
  mode_t rights = 0700;
  if (!is_private) {
    const bool stands = ::stat(place.c_str(), &old) == 0;
    rights = stands ? old.st_mode & 07777 : 0777 & ~unfinished::userMask();
  }
  int fault = ::fchmod(lock_, rights) == 0 ? flushBelow(path_) : errno;
  if (fault == 0 && ::rename(path_.c_str(), place.c_str()) != 0) fault = errno;
  if (fault == 0) {
    ::close(std::exchange(lock_, -1));
    fault = unfinished::flushFolder(place.has_parent_path() ? place.parent_path() : fs::path("."));
  }
  if (fault == 0) return {};
  return makeError({.file = place.string(),
                    .found = systemText(fault),
                    .expected = "free space, and the name of a new or empty folder"});
}

}  // namespace hapticell
