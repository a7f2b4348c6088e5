// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_model.h"
#include "planning/free_space.h"

namespace hapticell::planning {

/// Places of external axes to reach a pose from: values (rad or m) of the first `variables` variables of `robot`, over
/// their whole travel (joints without limits: half a turn or 10 m to both sides of the present place). The
/// present place first, then evenly spread ones; those of two and more axes follow from `seed`. At least one; contract:
/// 1 <= variables <= present.size().
std::vector<std::vector<double>> axisPlaces(const kinematics::RobotModel& robot, std::size_t variables,
                                            const std::vector<double>& present, std::uint64_t seed);

/// The configuration with its first joints at `place`.
EntityConfiguration withAxesAt(EntityConfiguration at, const std::vector<double>& place);

/// Configurations within the limits with the tool at X_WT: all of the arm, with its axes at each of `places`; the `most`
/// that are reached soonest from `start` (leastTime()), soonest first. `inverse`: of the robot without its axes.
std::vector<EntityConfiguration> soonestWithAxes(const FreeSpace& space, const kinematics::InverseModel& inverse,
                                                 const Pose& X_WT, const EntityConfiguration& start,
                                                 const std::vector<std::vector<double>>& places, std::size_t most);

}  // namespace hapticell::planning
