// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "cli/kit/subcommand.h"
#include "geometry/system/error.h"

namespace hapticell::cli {

/// Options of every command that speaks with ROS 2.
struct RosWords {
  int domain = -1;  ///< 0 to 232; below 0: not given.
  bool this_machine = false;
};

void addRosWords(Subcommand command, RosWords& words);

/// What hapticell-ros2 answers to a job, in the domain of the words or of the environment (ROS_DOMAIN_ID,
/// ROS_LOCALHOST_ONLY). Empty: it failed and printed a sentence. Errors: a wrong ROS_DOMAIN_ID; the program cannot be
/// started, crashed or answered nothing.
Expected<std::optional<nlohmann::ordered_json>> bridgeResult(nlohmann::ordered_json job, const RosWords& words);

}  // namespace hapticell::cli
