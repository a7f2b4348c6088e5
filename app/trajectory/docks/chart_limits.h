// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/trajectory/docks/motion_chart.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// s; time to reach an acceleration if no jerk limit is given; our choice. Half: twice the jerk counts as within
/// limits; twice: half of it is shown as exceeded.
inline constexpr double kUsualRamp = 0.1;

/// Limits for the curves of an entity's motion: for a robot its joint limits and speeds, accelerations as limitsOf()
/// has them, jerk as acceleration over kUsualRamp; for a solid the same for x, y, z and the turns, without position
/// limits.
std::vector<MotionChart::Limit> chartLimits(const workcell::Entity& entity, const trajectory::Trajectory& trajectory);

}  // namespace hapticell::app
