// SPDX-License-Identifier: Apache-2.0
#include "workcell/file_content.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

/// Writes everything and flushes it; the errno of what failed, else 0.
int writeAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;  // EINVAL: a pipe or a device, which has no disk.
}

/// A pipe, a terminal, /dev/null: nothing may be moved into its place.
Expected<void> writeInto(const fs::path& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  int fault = file < 0 ? errno : writeAll(file, content);
  if (file >= 0 && ::close(file) != 0 && fault == 0) fault = errno;
  if (fault == 0) return {};
  return makeError({path.string(), "", std::strerror(fault), "something that takes what is written", ""});
}

}  // namespace

Expected<std::string> readFileContent(const fs::path& path) {
  constexpr std::uintmax_t kLargest = 4'000'000'000;
  std::error_code fault;
  const fs::file_status status = fs::status(path, fault);
  if (!fs::exists(status)) return makeError({path.string(), "", "there is no such file", "", ""});
  if (!fs::is_regular_file(status)) {
    return makeError({path.string(), "", fs::is_directory(status) ? "a folder" : "not a regular file", "a file", ""});
  }
  const std::uintmax_t size = fs::file_size(path, fault);
  if (fault || size > kLargest) {
    return makeError(
        {path.string(), "", fault ? fault.message() : std::to_string(size) + " bytes", "at most 4 GB", ""});
  }
  std::ifstream file(path, std::ios::binary);
  std::string content(size, '\0');
  file.read(content.data(), static_cast<std::streamsize>(size));
  if (!file || file.gcount() != static_cast<std::streamsize>(size)) {
    return makeError({path.string(), "", "the file could not be read", "", "Check that you may read it."});
  }
  return content;
}

Expected<fs::path> placeOfFile(const fs::path& path) {
  std::error_code ignored;
  fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  const fs::file_status status = fs::status(target, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status)) return target;
  return makeError(
      {path.string(), "", fs::is_directory(status) ? "a folder" : "no regular file", "the name of a file", ""});
}

Expected<void> writeFileAtomically(const fs::path& path, std::string_view content) {
  return writeFileChecked(path, content, {});
}

Expected<void> writeFileChecked(const fs::path& path, std::string_view content, const FileCheck& check) {
  std::error_code ignored;
  const auto place = placeOfFile(path);
  if (!place) {
    if (fs::is_directory(path, ignored)) return makeError(place.error());
    // Nothing can be taken back from a pipe: a file of the same content is looked at before.
    if (check) {
      std::string folder = (fs::temp_directory_path(ignored) / "hapticell-trial-XXXXXX").string();
      if (!::mkdtemp(folder.data()))
        return makeError({folder, "", std::strerror(errno), "a folder for temporary files that may be written", ""});
      auto kept = writeFileChecked(fs::path(folder) / ("trial" + path.extension().string()), content, check);
      fs::remove_all(folder, ignored);
      if (!kept) return kept;
    }
    return writeInto(path, content);
  }
  const fs::path& target = *place;
  // Hidden, and of the same extension, by which readers know what it is.
  const std::string extension = target.extension().string();
  std::string aside = (target.parent_path() / ("." + target.stem().string() + ".XXXXXX" + extension)).string();
  const int file = ::mkstemps(aside.data(), static_cast<int>(extension.size()));
  if (file < 0) {
    return makeError({path.string(), "", std::strerror(errno), "a folder that exists and may be written", ""});
  }
  struct stat old {};
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(file, ::stat(target.c_str(), &old) == 0 ? old.st_mode & 07777 : 0666 & ~mask);
  int fault = writeAll(file, content);
  if (::close(file) != 0 && fault == 0) fault = errno;
  if (fault == 0 && check) {
    if (auto kept = check(aside); !kept) {
      ::unlink(aside.c_str());
      return kept;
    }
  }
  if (fault == 0 && ::rename(aside.c_str(), target.c_str()) != 0) fault = errno;
  if (fault != 0) {
    ::unlink(aside.c_str());
    return makeError({path.string(), "", std::strerror(fault), "room and permission to write the file", ""});
  }
  return {};
}

}  // namespace hapticell::workcell
