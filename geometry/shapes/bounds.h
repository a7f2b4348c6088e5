// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "geometry/shapes/pose.h"

namespace hapticell::geometry {

/// An axis-aligned box. Empty (min above max) until a point is added.
struct Bounds {
  dvec3 min{std::numeric_limits<double>::infinity()};
  dvec3 max{-std::numeric_limits<double>::infinity()};

  bool isEmpty() const { return min.x > max.x; }
  void add(const dvec3& point);
  void add(const Bounds& other);
  dvec3 center() const { return 0.5 * (min + max); }
  dvec3 size() const { return isEmpty() ? dvec3(0.0) : max - min; }
  /// Half the diagonal, metres; 0 when empty.
  double radius() const { return 0.5 * glm::length(size()); }
};

/// The box of points.
Bounds boundsOf(std::span<const dvec3> points);

/// The box, in A, of the box of B's points: never smaller than theirs, in general larger.
Bounds transformed(const Pose& X_AB, const Bounds& bounds_B);

}  // namespace hapticell::geometry
