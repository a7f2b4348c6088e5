// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <set>
#include <utility>

#include "geometry/system/scratch_folder.h"
#include "geometry/system/unfinished_files.h"

namespace hapticell {

namespace fs = std::filesystem;

namespace {

constexpr mode_t kRights = 07777;

int writeAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// EINVAL: a pipe or a device, which has no disk.
int flushFile(int file) {
  return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
}

/// A pipe, a terminal, /dev/null: nothing may be moved into its place.
Expected<void> writeInto(const fs::path& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  int fault = file < 0 ? errno : writeAll(file, content);
  if (file >= 0 && fault == 0) fault = flushFile(file);
  if (file >= 0 && ::close(file) != 0 && fault == 0) fault = errno;
  if (fault == 0) return {};
  return makeError(
      {.file = path.string(), .found = systemText(fault), .expected = "a file or program that accepts all data"});
}

/// What writeInto() takes.
bool isPipe(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Access lists and what users attached to the old file. What the disk does not know is left out.
void copyAttributes(const fs::path& from, int to) {
  const ssize_t size = ::listxattr(from.c_str(), nullptr, 0);
  if (size <= 0) return;
  std::string names(static_cast<std::size_t>(size), '\0');
  const ssize_t got = ::listxattr(from.c_str(), names.data(), names.size());
  for (std::size_t at = 0; got > 0 && at < static_cast<std::size_t>(got);) {
    const std::string name = names.c_str() + at;
    at += name.size() + 1;
    if (!name.starts_with("user.") && name != "system.posix_acl_access") continue;
    const ssize_t length = ::getxattr(from.c_str(), name.c_str(), nullptr, 0);
    if (length < 0) continue;
    std::string value(static_cast<std::size_t>(length), '\0');
    if (::getxattr(from.c_str(), name.c_str(), value.data(), value.size()) == length)
      (void)::fsetxattr(to, name.c_str(), value.data(), value.size(), 0);
  }
}

/// Owner, group, rights and attributes of what is replaced; 0 or errno.
int keepFacts(const fs::path& target, int file, const std::optional<mode_t>& wanted) {
  struct stat old {
  }, made{};
  const bool replaces = !wanted && ::stat(target.c_str(), &old) == 0;
  if (!replaces) return ::fchmod(file, wanted.value_or(0666 & ~unfinished::userMask())) == 0 ? 0 : errno;
  if (::fstat(file, &made) != 0) return errno;
  mode_t rights = old.st_mode & kRights;
  const bool differs = old.st_uid != made.st_uid || old.st_gid != made.st_gid;
  if (differs && ::fchown(file, old.st_uid, old.st_gid) != 0) {
    rights &= ~static_cast<mode_t>(S_ISUID | S_ISGID);
    const bool group_kept = old.st_gid == made.st_gid || ::fchown(file, static_cast<uid_t>(-1), old.st_gid) == 0;
    if (!group_kept) rights = (rights & ~static_cast<mode_t>(S_IRWXG)) | (rights & (rights & S_IRWXO) << 3);
  }
  if (::fchmod(file, rights) != 0) return errno;
  copyAttributes(target, file);
  return 0;
}

Text helpFor(int fault) {
  if (fault == ENOSPC || fault == EDQUOT || fault == EFBIG) return Text("Free disk space, or write to another disk.");
  return {};
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

Expected<fs::path> placeOfFile(const fs::path& path) {
  // Links followed, as Linux itself does (40, then ELOOP). Half, twice: no effect but on circles.
  constexpr int kMostLinks = 40;
  std::error_code fault;
  fs::path target = path;
  for (int links = 0; fs::is_symlink(target, fault); ++links) {
    if (links == kMostLinks)
      return makeError(
          {.file = path.string(), .found = "symbolic links that refer to each other", .expected = "a file name"});
    const fs::path named = fs::read_symlink(target, fault);
    if (fault) break;
    target = named.is_absolute() ? named : target.parent_path() / named;
  }
  const fs::file_status status = fs::status(target, fault);
  if (!fs::exists(status) || fs::is_regular_file(status)) return target;
  return makeError({.file = path.string(),
                    .found = fs::is_directory(status) ? Text("a folder") : Text("not a regular file"),
                    .expected = "a file name"});
}

Expected<AtomicFile> AtomicFile::begin(const fs::path& path, const Options& options) {
  const auto place = placeOfFile(path);
  HAPTICELL_TRY(place);
  AtomicFile made;
  made.asked_ = path;
  made.options_ = options;
  std::error_code fault;
  made.target_ = fs::absolute(*place, fault);
  if (fault) return makeError({.file = path.string(), .found = fault.message(), .expected = "an existing folder"});
  if (::faccessat(AT_FDCWD, made.target_.c_str(), W_OK, AT_EACCESS) != 0 && errno == EACCES &&
      fs::exists(made.target_, fault)) {
    return makeError({.file = path.string(),
                      .found = "the file is write-protected",
                      .expected = "a file that you can write",
                      .fix = "Remove the write protection, or choose another name."});
  }
  const fs::path folder = folderOf(made.target_);
  unfinished::tidyOnce(folder);
  constexpr std::size_t kLongestExtension = 60;
  std::string extension = path.extension().string();
  if (extension.size() > kLongestExtension) extension.clear();
  // Names tried, six random letters each: a second try is rare. Half, twice: no effect.
  constexpr int kMostTries = 100;
  for (int tries = 0; tries < kMostTries; ++tries) {
    std::string name = (folder / unfinished::kPattern).string() + extension;
    made.file_ = ::mkostemps(name.data(), static_cast<int>(extension.size()), O_CLOEXEC);
    if (made.file_ < 0) break;
    made.aside_ = name;
    if (unfinished::take(made.file_, made.aside_)) return made;
    ::close(std::exchange(made.file_, -1));
  }
  return makeError({.file = path.string(),
                    .found = systemText(errno),
                    .expected = "a folder that exists and is writable",
                    .fix = helpFor(errno)});
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : asked_(std::move(other.asked_)),
      target_(std::move(other.target_)),
      aside_(std::move(other.aside_)),
      options_(other.options_),
      file_(std::exchange(other.file_, -1)) {}

AtomicFile::~AtomicFile() {
  if (file_ < 0) return;
  ::unlink(aside_.c_str());
  ::close(file_);  // And with it the lock, when there is nothing left to find.
}

Error AtomicFile::failure(int fault) const {
  return {.file = asked_.string(),
          .found = systemText(fault),
          .expected = "free space and permission to write the file",
          .fix = helpFor(fault)};
}

Expected<void> AtomicFile::write(std::string_view content) {
  const int fault = writeAll(file_, content);
  return fault == 0 ? Expected<void>() : makeError(failure(fault));
}

int AtomicFile::flush() {
  if (const int fault = keepFacts(target_, file_, options_.mode); fault != 0) return fault;
  return options_.durable ? flushFile(file_) : 0;
}

int AtomicFile::move() {
  return ::rename(aside_.c_str(), target_.c_str()) == 0 ? 0 : errno;
}

Expected<void> AtomicFile::commit() {
  return commitAll({this, 1});
}

Expected<void> AtomicFile::commitAll(std::span<AtomicFile> files) {
  for (AtomicFile& each : files) {
    if (const int fault = each.flush(); fault != 0) return makeError(each.failure(fault));
  }
  std::set<fs::path> folders;
  for (AtomicFile& each : files) {
    if (const int fault = each.move(); fault != 0) return makeError(each.failure(fault));
    if (each.options_.durable) folders.insert(folderOf(each.target_));
    if (::close(std::exchange(each.file_, -1)) != 0 && errno != EINTR) return makeError(each.failure(errno));
  }
  for (const fs::path& folder : folders) {
    if (const int fault = unfinished::flushFolder(folder); fault != 0)
      return makeError(
          {.file = folder.string(), .found = systemText(fault), .expected = "a disk that stores all data"});
  }
  return {};
}

Expected<void> writeFileAtomically(const fs::path& path, std::string_view content, const AtomicFile::Options& options) {
  if (isPipe(path)) return writeInto(path, content);
  auto file = AtomicFile::begin(path, options);
  HAPTICELL_TRY(file);
  if (auto written = file->write(content); !written) return written;
  return file->commit();
}

Expected<void> writeFileChecked(const fs::path& path, std::string_view content, const FileCheck& check) {
  if (isPipe(path)) {
    // Nothing can be taken back from a pipe: a file of the same content is looked at before.
    const auto folder = ScratchFolder::make();
    HAPTICELL_TRY(folder);
    auto kept = writeFileChecked(folder->path() / ("trial" + path.extension().string()), content, check);
    if (!kept) return kept;
    return writeInto(path, content);
  }
  auto file = AtomicFile::begin(path);
  HAPTICELL_TRY(file);
  if (auto written = file->write(content); !written) return written;
  if (auto kept = check(file->aside()); !kept) return kept;
  return file->commit();
}

Expected<void> writeFilesAtomically(const std::vector<FileToWrite>& files) {
  // Files open at once, well under the usual limit of 1024 of a process. Half: large packs are written in more parts;
  // twice: little is left for the rest.
  constexpr std::size_t kMostOpen = 200;
  if (files.size() > kMostOpen) {
    const auto rest = static_cast<std::ptrdiff_t>(files.size() - kMostOpen);
    auto first = writeFilesAtomically({files.begin(), files.begin() + rest});
    return first ? writeFilesAtomically({files.begin() + rest, files.end()}) : first;
  }
  std::vector<AtomicFile> begun;
  begun.reserve(files.size());
  for (const FileToWrite& each : files) {
    if (isPipe(each.path)) continue;
    auto file = AtomicFile::begin(each.path);
    HAPTICELL_TRY(file);
    if (auto written = file->write(each.content); !written) return written;
    begun.push_back(std::move(*file));
  }
  if (auto done = AtomicFile::commitAll(begun); !done) return done;
  for (const FileToWrite& each : files) {
    if (!isPipe(each.path)) continue;
    if (auto written = writeInto(each.path, each.content); !written) return written;
  }
  return {};
}

}  // namespace hapticell
