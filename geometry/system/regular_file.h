// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// What a reader takes at most where it says nothing else.
inline constexpr std::uintmax_t kLargestFile = 4'000'000'000;

/// Nothing where `path` is a regular file, or a link to one, of at most `most_bytes`. Error: it is missing, a folder, a
/// pipe, a socket, a device, or larger. Nothing is opened, so nothing can wait for a writer or be set going. For files
/// that a library opens by itself: asked right before.
Expected<void> checkRegularFile(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);

/// The bytes of such a file; besides the errors above, one that may not be read or that got shorter meanwhile.
Expected<std::string> readRegularFile(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);

/// Its first bytes, at most `most`; empty where it is no regular file or cannot be read.
std::string headOfFile(const std::filesystem::path& path, std::size_t most);

/// Such a file as a stream, for readers that go through it line by line. It ends where the file ended when it was
/// opened: what grows, or has no end, is not followed. It cannot be moved about in.
class RegularFileStream final : public std::istream {
 public:
  explicit RegularFileStream(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);
  ~RegularFileStream() override;

  /// Why nothing can be read (the stream is false from the beginning); an empty one where all is well.
  const Error& error() const { return error_; }

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  Error error_;
};

}  // namespace hapticell::geometry
