// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

namespace hapticell::app {

/// Which motions of the hand are passed on: moving along and turning about the three axes.
struct FreeAxes {
  std::array<bool, 3> moves{true, true, true};
  std::array<bool, 3> turns{true, true, true};
  bool operator==(const FreeAxes&) const = default;
  bool translates() const { return moves[0] || moves[1] || moves[2]; }
  bool rotates() const { return turns[0] || turns[1] || turns[2]; }
};

/// After key X, Y or Z (`axis` 0, 1, 2): first only moving along it, then only turning about it, then all again.
FreeAxes afterKey(const FreeAxes& now, std::size_t axis);

/// "X Y Z A B C", "X", "C"; "none" for none.
std::string freeAxesText(const FreeAxes& axes);

}  // namespace hapticell::app
