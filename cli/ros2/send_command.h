// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

/// Adds `send` below `ros2`: a checked motion for a controller's FollowJointTrajectory action.
void addSendCommand(Subcommand ros2, Action& chosen);

/// What a person confirms, in one sentence: robot, duration, speed, and what was not checked. `preview` is that of
/// hapticell-ros2.
std::string confirmationSentence(const nlohmann::ordered_json& preview);

}  // namespace hapticell::cli
