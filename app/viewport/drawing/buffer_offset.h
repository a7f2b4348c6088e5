// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::app {

/// An offset in a buffer as OpenGL takes it, as a pointer.
inline const void* bufferOffset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): OpenGL requires it.
}

}  // namespace hapticell::app
