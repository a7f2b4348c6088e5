// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::app {

/// A line drawn over the scene: a guide, an axis, a frame, the outline of what is being picked.
struct SceneCurve {
  enum class Role { kGuide, kGuideOff, kSelection, kAxisX, kAxisY, kAxisZ, kLimit, kContact, kNearMiss, kMeasure };
  enum class Style { kSolid, kDashDot, kDashed };
  std::vector<dvec3> points_W;  ///< One point: a disc.
  Role role = Role::kGuide;
  Style style = Style::kDashDot;
  double width = 2.0;     ///< Pixels at 100 %.
  std::string text = {};  ///< Next to its last point; empty: none.
  bool operator==(const SceneCurve&) const = default;
};

}  // namespace hapticell::app
