// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/trajectory/docks/motion_chart.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// s in which an acceleration is reached, where no jerk is given; our choice. Half: twice the jerk passes for kept;
/// twice: half of it is drawn as over.
inline constexpr double kUsualRamp = 0.1;

/// What the curves of an entity's motion are held against: a robot's joint limits and speeds, accelerations as
/// limitsOf() has them, jerk as acceleration over kUsualRamp; of a solid the same for x, y, z and the turns, without
/// places.
std::vector<MotionChart::Limit> chartLimits(const workcell::Entity& entity, const trajectory::Trajectory& trajectory);

}  // namespace hapticell::app
