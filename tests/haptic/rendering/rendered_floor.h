// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "feel/scene.h"
#include "haptic/rendering/force_renderer.h"

/// Floors and hands for the renderer's tests.
namespace hapticell::haptic {

using feel::planeConstraint;

inline constexpr double kTick = 0.001;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline ConstraintSet floorSet(std::uint64_t sequence, double height = 0.0, const dvec3& reference = dvec3(0.0)) {
  ConstraintSet set;
  set.sequence = sequence;
  set.X_DR = Pose::translation(reference);
  set.count = 1;
  set.constraints[0] = planeConstraint(dvec3(0, 0, height), dvec3(0, 0, 1), set.X_DR, 0);
  return set;
}

inline Pose at(double x, double y, double z) {
  return Pose::translation(dvec3(x, y, z));
}

/// Moves in steps that a hand makes, then waits until filters have settled.
inline RenderResult moveTo(ForceRenderer& renderer, const dvec3& from, const dvec3& to, int ticks = 200,
                           int wait = 200) {
  RenderResult result;
  for (int i = 1; i <= ticks; ++i) {
    result = renderer.tick(Pose::translation(glm::mix(from, to, static_cast<double>(i) / ticks)), kTick);
  }
  for (int i = 0; i < wait; ++i) result = renderer.tick(Pose::translation(to), kTick);
  return result;
}

}  // namespace hapticell::haptic
