// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::workcell {

/// The SRDF of a robot file: next to it with the same stem or the robot's name, or the only *.srdf there; or likewise
/// in a folder config/ next to it or next to its folder.
std::optional<std::filesystem::path> findSrdf(const std::filesystem::path& robot_file, const std::string& robot_name);

/// Adds an SRDF's groups (chains, joints, links, subgroups), named poses and disabled collision pairs to the model; the
/// pose "home" becomes its home. Names of links and joints that the model lacks are reported once in `diagnostics` and
/// ignored. Errors, with file and line: invalid XML, another robot's file.
Expected<void> readSrdf(const std::filesystem::path& file, kinematics::RobotModel& model, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
