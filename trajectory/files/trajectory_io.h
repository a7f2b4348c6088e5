// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Reads `*.htraj` (JSON, docs/user/formats.md), `*.csv` (`t,x,y,z,qw,qx,qy,qz` and one column per joint, or `t` and
/// joints only) or `*.yaml` (ros_yaml_reader.h). A file with joints only has no poses (Trajectory::has_poses). Errors
/// name the file and the frame or line; newer versions of the format are refused. Numbers are read bit for bit as
/// written. Robot programs are read with program_reader.h; `notes` receives what was assumed or left out.
Expected<Trajectory> readTrajectory(const std::filesystem::path& file, std::vector<Text>* notes = nullptr);

/// The text of either format; every number has enough digits to be read back exactly.
std::string toJsonText(const Trajectory& trajectory);
std::string toCsvText(const Trajectory& trajectory);

}  // namespace hapticell::trajectory
