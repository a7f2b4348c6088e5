// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

Blocks blocksOf(const haptic::SymmetricMatrix6& packed) {
  Blocks blocks;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const auto low = static_cast<std::size_t>(row < column ? row : column);
      const auto high = static_cast<std::size_t>(row < column ? column : row);
      // GLM is column-major: matrix[column][row].
      blocks.linear[column][row] = packed[packedIndex(low, high)];
      blocks.angular[column][row] = packed[packedIndex(low + 3, high + 3)];
      blocks.mixed[column][row] =
          packed[packedIndex(static_cast<std::size_t>(row), static_cast<std::size_t>(column) + 3)];
    }
  }
  return blocks;
}

haptic::SymmetricMatrix6 symmetricOf(const Blocks& blocks) {
  haptic::SymmetricMatrix6 packed{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
      if (row <= column) {
        packed[packedIndex(r, c)] = blocks.linear[column][row];
        packed[packedIndex(r + 3, c + 3)] = blocks.angular[column][row];
      }
      packed[packedIndex(r, c + 3)] = blocks.mixed[column][row];
    }
  }
  return packed;
}

}  // namespace hapticell::manipulation
