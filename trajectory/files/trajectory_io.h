// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Reads `*.htraj` (JSON, docs/user/formats.md), `*.csv` (`t,x,y,z,qw,qx,qy,qz` and one column a joint, or `t` and
/// joints alone) or `*.yaml` (ros_yaml_reader.h). What has joints alone has no poses (Trajectory::has_poses). Errors
/// name the file and the frame or line; newer versions of the format are refused. Numbers come back bit for bit as
/// written. Programs of robots are read with program_reader.h; `notes` gets what was assumed or left out there.
Expected<Trajectory> readTrajectory(const std::filesystem::path& file, std::vector<Text>* notes = nullptr);

/// The text of either twin; every number with as many digits as bring it back exactly.
std::string toJsonText(const Trajectory& trajectory);
std::string toCsvText(const Trajectory& trajectory);

}  // namespace hapticell::trajectory
