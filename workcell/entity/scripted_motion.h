// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/vector.h"

namespace hapticell::workcell {

/// What comes after the last point of a scripted motion.
enum class MotionRepeat {
  kOnce,  ///< It stays there.
  kLoop,  ///< At the first point again, at once: a belt that brings the next part.
  kBack,  ///< The same way back, and so on.
};

/// Motion of an entity during a session (a conveyor, a gate, a shuttle): translations in the cell, from point to point
/// at constant speed, with unchanged orientation. The document keeps its placement at the beginning.
struct ScriptedMotion {
  struct Point {
    double t = 0.0;  ///< s since the beginning.
    dvec3 p_W{0.0};  ///< m from where it stands in the document.
  };
  std::vector<Point> points;  ///< At least two, the first at t = 0, times rising.
  MotionRepeat repeat = MotionRepeat::kOnce;

  /// Where it is at `t` (below 0: at the beginning), m from where it stands in the document.
  dvec3 displacementAt(double t) const;
  /// Its velocity just after `t`, m/s; zero at a jump of kLoop and after the end.
  dvec3 velocityAt(double t) const;
};

/// Refuses fewer than two points, times that do not rise from 0, numbers that are not finite, and more than 2 m/s.
Expected<void> checkMotion(const ScriptedMotion& motion);

}  // namespace hapticell::workcell
