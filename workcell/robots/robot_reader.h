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

/// The format, from the file's name and first element; empty if it is not a robot. A robot is an XML document whose
/// element is <robot> (with xacro elements: xacro) or <sdf>, or a TOML document with format = "hapticell-robot".
std::optional<RobotFormat> robotFormatOf(const std::filesystem::path& file);
/// "urdf", "xacro", "sdf", "toml".
const char* formatName(RobotFormat format);

inline bool looksLikeRobot(const std::filesystem::path& file) {
  return robotFormatOf(file).has_value();
}

/// Reads a robot in any of the formats: readUrdf(), expandXacroFile(), readSdf(), readRobotToml(). For a URDF, searches
/// an SRDF next to it (see readSrdf()). Error: a file of another kind. `monitor` and `content` as for readUrdf().
/// `arguments` are those of a xacro; for another file they give a warning. `declared` (may be null) gets the arguments
/// that a xacro declares, even on error.
Expected<TomlRobot> readRobot(const std::filesystem::path& file, Diagnostics& diagnostics,
                              ImportMonitor* monitor = nullptr, RobotContent content = RobotContent::kAll,
                              const xacro::Arguments& arguments = {},
                              std::vector<xacro::DeclaredArgument>* declared = nullptr);

/// The arguments that a xacro declares, as far as it can be expanded with `arguments`; empty for other files.
std::vector<xacro::DeclaredArgument> robotArguments(const std::filesystem::path& file,
                                                    const xacro::Arguments& arguments = {});

}  // namespace hapticell::workcell
