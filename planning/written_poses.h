// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/system/promise.h"
#include "mannequin/body/skeleton.h"
#include "planning/plan.h"
#include "trajectory/motion/trajectory.h"
#include "workcell/entity/entity.h"

namespace hapticell::planning {

/// Poses of what was planned for at the frames of a motion, by the links' own kinematics: a robot's tool centre point,
/// the grip of a mannequin's hand, a solid's frame. `columns`: the variables of the motion's joints.
std::vector<Pose> writtenPoses(const trajectory::Trajectory& motion, const std::vector<std::size_t>& columns,
                               const workcell::Entity& entity, const std::optional<mannequin::Side>& hand);

/// "through": how far (m; a radian counts like 0.1 m) the motion is from each pose of Plan::X_WThrough where it is
/// nearest, in their order; "pose": how far its end is from Plan::X_WGoal. Neither is there if the plan has none.
std::vector<Promise> posePromises(const trajectory::Trajectory& motion, const std::vector<Pose>& X_WT,
                                  const Plan& plan);

/// Of a mannequin's motion: "feet" (m off where they stand in the cell; a radian counts like 0.1 m), "limits" (rad
/// beyond, for joints that are within theirs at the first frame) and, if the first frame is in balance, "balance" (m
/// that the centre of mass is within the soles).
std::vector<Promise> figurePromises(const trajectory::Trajectory& motion, const std::vector<std::size_t>& columns,
                                    const workcell::Entity& entity);

}  // namespace hapticell::planning
