// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/error.h"
#include "workcell/robot_toml.h"
#include "workcell/urdf_reader.h"

namespace hapticell::workcell {

enum class RobotFormat { kUrdf, kXacro, kSdf, kToml };

/// Told by the file's name and first element; nothing where it is no robot: an XML document whose element is <robot>
/// (with xacro elements: xacro) or <sdf>, or a TOML document with format = "hapticell-robot".
std::optional<RobotFormat> robotFormatOf(const std::filesystem::path& file);
/// "urdf", "xacro", "sdf", "toml".
const char* formatName(RobotFormat format);

inline bool looksLikeRobot(const std::filesystem::path& file) {
  return robotFormatOf(file).has_value();
}

/// Reads a robot in any of the formats: readUrdf(), expandXacro(), readSdf(), readRobotToml(). Beside a URDF an SRDF is
/// looked for (see readSrdf()). A file of another kind is refused. `monitor` and `content` as for
/// readUrdf().
Expected<TomlRobot> readRobot(const std::filesystem::path& file, Diagnostics& diagnostics,
                              ImportMonitor* monitor = nullptr, RobotContent content = RobotContent::kAll);

}  // namespace hapticell::workcell
