// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"
#include "haptic/rendering/constraint_set.h"

namespace hapticell::manipulation {

/// A symmetric 6x6 matrix by its blocks: [linear, mixed; mixed', angular]. `mixed` has linear rows, angular columns.
struct Blocks {
  dmat3 linear{0.0};
  dmat3 mixed{0.0};
  dmat3 angular{0.0};
};

/// Index of entry (i, j), i <= j < 6, in a packed upper triangle.
constexpr std::size_t packedIndex(std::size_t i, std::size_t j) {
  return i * 6 - i * (i + 1) / 2 + j;
}

Blocks blocksOf(const haptic::SymmetricMatrix6& packed);
haptic::SymmetricMatrix6 symmetricOf(const Blocks& blocks);

}  // namespace hapticell::manipulation
