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

// The one way in which this program writes files: under a name that the system makes, in the folder of the file that is
// meant; flushed to the disk; then moved into place, and the folder flushed too. Whatever happens (a full disk, an
// error, a kill, a power cut), the old content stands or the new one, never a part. What a killed program left is
// removed by the next one that writes into that folder.

/// A file that is being written and has its name only when it is whole. One thread at a time.
class AtomicFile {
 public:
  struct Options {
    /// The rights of a file that is for this user alone, whoever owned what stood there before. None: owner, group and
    /// rights of the file that is replaced, else the user's usual ones.
    std::optional<mode_t> mode = {};
    /// False for what can be made again (caches): it is not flushed to the disk, which takes time.
    bool durable = true;
  };

  /// Begins a file that is to stand at `path`; a symbolic link means what it leads to. Errors: a folder, a pipe or a
  /// device stands there; a file that may not be written stands there; no file can be made in its folder.
  static Expected<AtomicFile> begin(const std::filesystem::path& path, const Options& options);
  static Expected<AtomicFile> begin(const std::filesystem::path& path) { return begin(path, Options{}); }
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  /// Removes what was written, unless commit() succeeded.
  ~AtomicFile();

  /// The name until then, absolute, with the extension of `path`: for libraries that write by name. They must not
  /// replace the file, only fill it.
  const std::filesystem::path& aside() const { return aside_; }
  /// Open for writing, at the end of what write() wrote.
  int descriptor() const { return file_; }
  Expected<void> write(std::string_view content);
  /// Flushes the file, gives it owner, group, rights and attributes of the file that it replaces, and moves it into
  /// place. An owner that this user may not give stays the user; a group that he may not give gets no rights beyond
  /// those of all others. On error nothing is left and the old file stands.
  Expected<void> commit();
  /// The same for several: all are flushed before the first is moved, and each folder is flushed once. A fault until
  /// then leaves all old files. The last one is moved last.
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

/// What looks at a file before it takes its place; its error keeps the file from it.
using FileCheck = std::function<Expected<void>(const std::filesystem::path& written)>;

/// Writes a whole file as AtomicFile does. Into what is no regular file (a pipe, a device) it writes as it is.
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                   const AtomicFile::Options& options = {});

/// As writeFileAtomically(), but `check` reads the whole file first, under another name with the same extension. Where
/// it finds a fault nothing is left of the file, and what stood there before stands there still.
Expected<void> writeFileChecked(const std::filesystem::path& path, std::string_view content, const FileCheck& check);

struct FileToWrite {
  std::filesystem::path path;
  std::string content;
};
/// Several files that belong together, the one that names the others last: AtomicFile::commitAll(). Beyond 200 files
/// those before are in place when the last 200 are begun.
Expected<void> writeFilesAtomically(const std::vector<FileToWrite>& files);

/// Where a file of that name is to be moved: the name itself, or what a symbolic link means, also where nothing stands
/// there yet. Error: a folder, a pipe or a device stands there, which a file must not take the place of; links in a
/// circle.
Expected<std::filesystem::path> placeOfFile(const std::filesystem::path& path);

/// Removes the unfinished files and folders of AtomicFile and ScratchFolder in this folder (not below it) whose
/// programs are dead, by this user. Those of living programs are locked, and stay.
void removeUnfinished(const std::filesystem::path& folder);

}  // namespace hapticell
