// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::workcell {

/// The SRDF that belongs to a robot file: beside it with the same stem or the robot's name, or the only *.srdf there,
/// or so in a folder config/ beside it or beside its folder.
std::optional<std::filesystem::path> findSrdf(const std::filesystem::path& robot_file, const std::string& robot_name);

/// Adds an SRDF's groups (chains, joints, links, subgroups), named poses and disabled collision pairs to the model; the
/// pose "home" becomes its home. Names of links and joints that the model lacks are reported once in `diagnostics` and
/// ignored. Errors: XML that does not parse, another robot's file; both with file and line.
Expected<void> readSrdf(const std::filesystem::path& file, kinematics::RobotModel& model, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
