// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "workcell/robots/robot_toml.h"
#include "workcell/robots/robot_toml_common.h"

namespace hapticell::workcell {

/// Reads one robot.toml: the common parts with RobotTomlCommon, the kinds with SerialKindReader and
/// ParallelKindReader.
class RobotTomlReader {
 public:
  RobotTomlReader(const toml::table& root, const std::filesystem::path& file, Diagnostics& diagnostics)
      : common_(root, file), diagnostics_(diagnostics) {}

  Expected<TomlRobot> read();
  Expected<RobotSheet> readSheet();

 private:
  void readKind();
  void readTools();

  RobotTomlCommon common_;
  Diagnostics& diagnostics_;
  TomlRobot robot_;
};

}  // namespace hapticell::workcell
