// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "geometry/system/error.h"
#include "geometry/system/regular_file.h"

namespace hapticell::geometry {

/// The bytes of a large file. As readRegularFile(), but on all cores and into memory that nothing has filled before, a
/// third of the time.
class FileBytes {
 public:
  /// Errors as readRegularFile().
  static Expected<FileBytes> read(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);

  /// Valid while this object is.
  std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

}  // namespace hapticell::geometry
