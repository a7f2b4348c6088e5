// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::collision {

/// A triangle of a mesh A and one of a mesh B, by their indices.
struct TriangleIndices {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool operator==(const TriangleIndices&) const = default;
};

}  // namespace hapticell::collision
