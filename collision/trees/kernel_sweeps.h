// SPDX-License-Identifier: Apache-2.0
// Part of proximity_kernels_body.h, see there: boxes that move against each other.
#pragma once

#include "collision/trees/kernel_vectors.h"
#include "collision/trees/proximity_kernels.h"

namespace hapticell::collision {
namespace {

/// The gap perpendicular to a sweep: in that direction the sweep adds nothing.
template <typename V>
HAPTICELL_INLINE V besideSweep(const Vector<V>* axes, const V* halves, const Vector<V>& apart, const QueryBox& query,
                               const Vector<V>& sweep, V doubt) {
  const V square = dot(sweep, sweep);
  const V along = square > V{} ? dot(apart, sweep) / square : V{};
  const Vector<V> beside = apart - along * sweep;
  V reach = doubt * sumOfMagnitudes(beside);
  reach += magnitude(dot(beside, sweep));  // It is square to the sweep only up to rounding.
  for (int k = 0; k < 3; ++k) reach += halves[k] * magnitude(dot(axes[k], beside));
  for (int i = 0; i < 3; ++i) {
    const float* q = query.axis[i];
    reach += query.half[i] * magnitude(beside.x * q[0] + beside.y * q[1] + beside.z * q[2]);
  }
  const V length_squared = dot(beside, beside);
  const V open = larger(magnitude(dot(beside, apart)) - reach, V{});
  return length_squared > V{} ? open * open / length_squared : V{};
}

/// What a child sees the query box move by, and how near it counts.
template <typename V>
struct ChildSweep {
  Vector<V> sweep{};
  V limit_squared{};
  V rounding{};  ///< Magnitudes that its rounding goes with.
};

template <typename V>
HAPTICELL_INLINE ChildSweep<V> childSweep(const Vector<V>& middle, const Vector<V>& half, const BoxSweep& of) {
  const Vector<V> turn{all<V>(of.turn[0]), all<V>(of.turn[1]), all<V>(of.turn[2])};
  const Vector<V> turned = cross(turn, middle);
  ChildSweep<V> child;
  child.sweep = {turned.x + of.at[0], turned.y + of.at[1], turned.z + of.at[2]};
  child.rounding =
      (absolute(of.at[0]) + absolute(of.at[1]) + absolute(of.at[2])) + 2.0f * of.turn_size * sumOfMagnitudes(middle);
  const V limit = of.margin + of.turn_size * squareRoot(dot(half, half));
  child.limit_squared = 1.000001f * limit * limit;
  return child;
}

}  // namespace
}  // namespace hapticell::collision
