// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/error.h"
#include "workcell/robots/robot_toml.h"
#include "workcell/robots/urdf_reader.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

enum class RobotFormat { kUrdf, kXacro, kSdf, kToml };

/// Recognised by the file's name and first element; empty if it is not a robot: an XML document whose element is <robot>
/// (with xacro elements: xacro) or <sdf>, or a TOML document with format = "hapticell-robot".
std::optional<RobotFormat> robotFormatOf(const std::filesystem::path& file);
/// "urdf", "xacro", "sdf", "toml".
const char* formatName(RobotFormat format);

inline bool looksLikeRobot(const std::filesystem::path& file) {
  return robotFormatOf(file).has_value();
}

/// Reads a robot in any of the formats: readUrdf(), expandXacroFile(), readSdf(), readRobotToml(). For a URDF, an SRDF
/// is searched next to it (see readSrdf()). A file of another kind is refused. `monitor` and `content` as for
/// readUrdf(). `arguments` are those of a xacro; for another file they are a warning. `declared` (may be null) gets
/// what a xacro asks for, also where it is refused.
Expected<TomlRobot> readRobot(const std::filesystem::path& file, Diagnostics& diagnostics,
                              ImportMonitor* monitor = nullptr, RobotContent content = RobotContent::kAll,
                              const xacro::Arguments& arguments = {},
                              std::vector<xacro::DeclaredArgument>* declared = nullptr);

/// The arguments that a xacro asks for, as far as it can be expanded with `arguments`; empty for other files.
std::vector<xacro::DeclaredArgument> robotArguments(const std::filesystem::path& file,
                                                    const xacro::Arguments& arguments = {});

}  // namespace hapticell::workcell
