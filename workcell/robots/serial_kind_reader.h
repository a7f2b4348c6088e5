// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/model/robot_model.h"
#include "workcell/robots/robot_toml_common.h"

namespace hapticell::workcell {

/// Reads the serial kinds of a robot.toml into a model with its body: OPW parameters, Denavit-Hartenberg tables, chains
/// of frames. Notes a problem in `common`.
class SerialKindReader {
 public:
  SerialKindReader(RobotTomlCommon& common, kinematics::RobotModel& model) : common_(common), model_(model) {}

  void readOpw();
  void readDh();
  void readChain();

 private:
  Pose readFlange();
  void addBody();

  RobotTomlCommon& common_;
  kinematics::RobotModel& model_;
};

}  // namespace hapticell::workcell
