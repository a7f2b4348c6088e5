// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::planning {

/// Places of external axes to reach a pose from: values (rad or m) of the first `variables` variables of `robot`, over
/// their whole travel (joints without limits: half a turn or 10 m to both sides of the present place). The
/// present place first, then evenly spread ones; those of two and more axes follow from `seed`. At least one; contract:
/// 1 <= variables <= present.size().
std::vector<std::vector<double>> axisPlaces(const kinematics::RobotModel& robot, std::size_t variables,
                                            const std::vector<double>& present, std::uint64_t seed);

}  // namespace hapticell::planning
