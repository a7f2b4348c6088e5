// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// All named poses of a robot to choose from: "home" (its rest positions, unless another pose is called so), those of
/// its files (SRDF, robot.toml), those of the user. A user's pose replaces a file's of the same name. Empty if it is
/// not a robot. A pose's name is to be shown as it is.
std::vector<kinematics::NamedPose> namedPosesOf(const Entity& entity);

/// A pose by its name in namedPosesOf(); empty if it does not exist.
std::vector<double> findNamedPose(const Entity& entity, const std::string& name);

/// The user's poses of `before` for another model, number by number where joints have the same name, others at rest.
std::vector<kinematics::NamedPose> posesFor(const kinematics::RobotModel& model, const Entity& before);

}  // namespace hapticell::workcell
