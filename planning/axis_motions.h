// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/error.h"
#include "planning/free_space.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning {

/// A motion of a robot with its external axes (timedMotion()) as one motion for each entity, all with the same times:
/// first the robot's with its own joints and the poses of its tool, then the axes', the lowest first, each with its
/// joints and the poses of the link that carries the robot (moved "frame:LINK"). Without axes: the motion as it is.
std::vector<trajectory::Trajectory> motionsOfEntities(const trajectory::Trajectory& motion, const FreeSpace& space);

/// The reverse, from the motions themselves: joints named as `whole` (HeldModel::form()) has them, the axes' first, and
/// the robot's poses. `axes`: from the lowest on. Errors: a motion with other times or without joints, joints that do
/// not fit.
Expected<trajectory::Trajectory> motionOfAll(const trajectory::Trajectory& own,
                                             const std::vector<trajectory::Trajectory>& axes,
                                             const workcell::Entity& whole);

}  // namespace hapticell::planning
