// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// Default size limit of a reader, bytes: binary STL of 80 million triangles. Half: large scans are refused; twice:
/// memory of most machines.
inline constexpr std::uintmax_t kLargestFile = 4'000'000'000;

/// Succeeds if `path` is a regular file, or a link to one, of at most `most_bytes`. Error: it is missing, a folder, a
/// pipe, a socket, a device, or larger. It opens nothing, so it cannot wait for a writer or start a device. For files
/// that a library opens by itself: call it directly before.
Expected<void> checkRegularFile(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);

/// Reads a regular file. Errors: as above, and a file that may not be read or that became shorter while it was read.
Expected<std::string> readRegularFile(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);

/// The first bytes of a file, at most `most`; empty if it is not a regular file or cannot be read.
std::string headOfFile(const std::filesystem::path& path, std::size_t most);

/// A regular file as a stream, for readers that read line by line. The stream ends where the file ended when it was
/// opened, even if the file grows. It does not support seeking.
class RegularFileStream final : public std::istream {
 public:
  explicit RegularFileStream(const std::filesystem::path& path, std::uintmax_t most_bytes = kLargestFile);
  ~RegularFileStream() override;

  /// Why nothing can be read (the stream is false from the beginning); an empty error if the file is readable.
  const Error& error() const { return error_; }

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  Error error_;
};

}  // namespace hapticell::geometry
