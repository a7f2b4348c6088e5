// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"

namespace hapticell {

/// A new folder for temporary files, or for files that are moved into place together. The destructor removes it; after
/// a kill the next program that works in its parent folder removes it (removeUnfinished()).
class ScratchFolder {
 public:
  /// Makes the folder in `parent`; empty: the system's folder for temporary files. Error: no folder can be made there.
  static Expected<ScratchFolder> make(const std::filesystem::path& parent = {});
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();
  /// Absolute.
  const std::filesystem::path& path() const { return path_; }
  /// Flushes the content to the disk and renames the folder to `place`, on the same disk; `place` must not exist or be
  /// an empty folder. On error the folder is unchanged. It gets the rights of the replaced empty folder or this user's
  /// usual ones, unless `is_private`: then only this user may use it.
  Expected<void> moveTo(const std::filesystem::path& place, bool is_private = false);
  /// For an empty folder that cannot be replaced (a disk's root, or in a folder that this user may not write): flushes
  /// the content and moves it there file by file, `last` last.
  Expected<void> moveContentTo(const std::filesystem::path& folder, const std::filesystem::path& last);

 private:
  ScratchFolder() = default;
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace hapticell
