// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"

namespace hapticell {

/// A fresh folder for files that are needed for a while, or that get their place together. It goes with this object;
/// after a kill the next program that works in its parent removes it (removeUnfinished()).
class ScratchFolder {
 public:
  /// Made in `parent`; empty: the system's folder for temporary files. Error: no folder can be made there.
  static Expected<ScratchFolder> make(const std::filesystem::path& parent = {});
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();
  /// Absolute.
  const std::filesystem::path& path() const { return path_; }
  /// Flushes all that is in it to the disk and gives it that name, which must be free or that of an empty folder, on
  /// the same disk. On error it stays what it is. Others may use it as this user's folders are usually used, or as the
  /// empty one; unless it stays `is_private`.
  Expected<void> moveTo(const std::filesystem::path& place, bool is_private = false);
  /// For an empty folder that cannot be replaced (a disk's own, or in one that this user may not write): flushes all
  /// and moves what is in it there, one after the other, `last` last.
  Expected<void> moveContentTo(const std::filesystem::path& folder, const std::filesystem::path& last);

 private:
  ScratchFolder() = default;
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace hapticell
