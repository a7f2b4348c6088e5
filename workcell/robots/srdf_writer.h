// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "kinematics/model/robot_model.h"

namespace hapticell::workcell {

/// The SRDF of a robot as MoveIt reads it: groups (that of the default tip as "arm" for a model without groups), named
/// poses and "home", and the pairs of links that are never checked, with their reasons. `name` is that of the URDF's
/// robot. readSrdf() brings groups, poses and pairs back equal.
std::string srdfText(const std::string& name, const kinematics::RobotModel& model,
                     std::span<const kinematics::DisabledPair> pairs);

}  // namespace hapticell::workcell
