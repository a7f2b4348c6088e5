// SPDX-License-Identifier: Apache-2.0
// Included once by each of violated_rows*.cpp, which are compiled for different instruction sets. No library, and no
// function of a header: the linker might use a copy that was compiled for a new processor everywhere.
#include <cstddef>

#include "haptic/rendering/lanes.h"

namespace hapticell::haptic {
namespace {

bool worstRowOf(const RowArrays& rows, const double* barred, const double* d, double tolerance, std::size_t& row) {
  alignas(64) double left[RowArrays::kMost];
  Lanes least = -tolerance + Lanes{};
  for (std::size_t first = 0; first < rows.count; first += kLanes) {
    Lanes value = load(&rows.normal[0][first]) * d[0];
    for (std::size_t i = 1; i < 6; ++i) value += load(&rows.normal[i][first]) * d[i];
    value += load(&rows.slack[first]);
    const Lanes off = value < 0.0 ? value : -value;
    value = load(&rows.both_ways[first]) > 0.0 ? off : value;
    value += load(&barred[first]);
    store(&left[first], value);
    least = value < least ? value : least;
  }
  double worst = -tolerance;
  for (std::size_t i = 0; i < kLanes; ++i) worst = least[i] < worst ? least[i] : worst;
  if (!(worst < -tolerance)) return false;
  for (row = 0; left[row] != worst;) ++row;
  return true;
}

}  // namespace
}  // namespace hapticell::haptic
