// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// A regular file that was opened for reading; whoever has it closes it.
struct OpenFile {
  int descriptor = -1;
  std::uintmax_t size = 0;  ///< Bytes, when it was opened.
};

/// Looked at before it is opened, for opening alone may set a device going; and again after, for it may have been
/// exchanged in between. Never waits: a pipe would wait for somebody who writes. Errors as checkRegularFile().
Expected<OpenFile> openRegularFile(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// What is said where a file ended too early.
Error endedEarly(const std::filesystem::path& path);

}  // namespace hapticell::geometry
