// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::app {

/// Bytes from a buffer's beginning as OpenGL takes them, where a pointer was once asked for.
inline const void* bufferOffset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): OpenGL's interface wants it.
}

}  // namespace hapticell::app
