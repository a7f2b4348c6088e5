// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell {

// The only way in which this program writes files. The content goes to a temporary file in the target's folder, is
// flushed to the disk and moved into place; then the folder is flushed too. After a full disk, an error, a kill or a
// power cut the file has either its old or its new content, never a part. If a killed program left a temporary file,
// the next program that writes into that folder removes it.

/// A file that is being written. It gets its final name only when it is complete. One thread at a time.
class AtomicFile {
 public:
  struct Options {
    /// The file's rights, if they must not depend on a replaced file (files for this user alone). Unset: owner, group
    /// and rights of the replaced file, or the user's usual ones.
    std::optional<mode_t> mode = {};
    /// False for files that can be made again (caches): they are not flushed to the disk, which saves time.
    bool durable = true;
  };

  /// Begins a file for `path`; a symbolic link is followed. Errors: `path` is a folder, a pipe or a device; it is a
  /// file that may not be written; no file can be made in its folder.
  static Expected<AtomicFile> begin(const std::filesystem::path& path, const Options& options);
  static Expected<AtomicFile> begin(const std::filesystem::path& path) { return begin(path, Options{}); }
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  /// Removes the temporary file, unless commit() succeeded.
  ~AtomicFile();

  /// The temporary name, absolute, with the extension of `path`: for libraries that write by name. They may fill the
  /// file but must not replace it.
  const std::filesystem::path& aside() const { return aside_; }
  /// Open for writing, at the end of what write() wrote.
  int descriptor() const { return file_; }
  Expected<void> write(std::string_view content);
  /// Flushes the file, gives it the owner, group, rights and attributes of the file that it replaces, and moves it into
  /// place. If this user may not set that owner, the user stays the owner. If the user may not set that group, the
  /// group gets no more rights than all others. On error the temporary file is removed and the old file is unchanged.
  Expected<void> commit();
  /// Commits several files: all are flushed before the first is moved, and each folder is flushed once. If an error
  /// occurs before the first move, all old files are unchanged. The files are moved in order.
  static Expected<void> commitAll(std::span<AtomicFile> files);

 private:
  AtomicFile() = default;
  Error failure(int fault) const;
  int flush();
  int move();

  std::filesystem::path asked_, target_, aside_;
  Options options_;
  int file_ = -1;
};

/// Checks a file before it is moved into place. If it returns an error, the file is not moved.
using FileCheck = std::function<Expected<void>(const std::filesystem::path& written)>;

/// Writes a complete file through AtomicFile. If the path is not a regular file (a pipe, a device), it writes directly.
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                   const AtomicFile::Options& options = {});

/// As writeFileAtomically(), but `check` first reads the complete file under its temporary name, which has the same
/// extension. If `check` returns an error, the new file is removed and the old one is unchanged.
Expected<void> writeFileChecked(const std::filesystem::path& path, std::string_view content, const FileCheck& check);

struct FileToWrite {
  std::filesystem::path path;
  std::string content;
};
/// Writes several files that belong together by AtomicFile::commitAll(); give the file that names the others last. If
/// there are more than 200 files, the earlier ones are in place before the last 200 are begun.
Expected<void> writeFilesAtomically(const std::vector<FileToWrite>& files);

/// The path that a file of that name is moved to: the name itself, or the target of a symbolic link, which need not
/// exist. Errors: the path is a folder, a pipe or a device, which a file must not replace; links form a circle.
Expected<std::filesystem::path> placeOfFile(const std::filesystem::path& path);

/// Removes unfinished files and folders of AtomicFile and ScratchFolder in this folder (not below it), if they belong
/// to this user and their program has ended. Those of running programs are locked and stay.
void removeUnfinished(const std::filesystem::path& folder);

}  // namespace hapticell
