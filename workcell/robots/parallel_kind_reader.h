// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "kinematics/closures/loop_closure.h"
#include "kinematics/model/robot_model.h"
#include "workcell/robots/robot_toml_common.h"

namespace hapticell::workcell {

/// Reads the kinds of a robot.toml with closed loops into a model with its body: Delta, hexapod, a URDF with its loops.
/// Notes a problem in `common`.
class ParallelKindReader {
 public:
  ParallelKindReader(RobotTomlCommon& common, kinematics::RobotModel& model, Diagnostics& diagnostics)
      : common_(common), model_(model), diagnostics_(diagnostics) {}

  void readDelta();
  void readHexapod();
  void readUrdfWithLoops();

 private:
  void takeModel(Expected<kinematics::RobotModel> model, const toml::node* at);
  /// Turns a moving joint into a fixed one.
  void lock(kinematics::RobotModel& model, const std::string& name, TomlFields& fields);
  void readLoops(const kinematics::RobotModel& tree, std::vector<kinematics::LoopConstraint>& loops);
  void readEnd(const kinematics::RobotModel& tree, TomlFields& fields, const char* key, int& link, Pose& X);

  RobotTomlCommon& common_;
  kinematics::RobotModel& model_;
  Diagnostics& diagnostics_;
};

}  // namespace hapticell::workcell
