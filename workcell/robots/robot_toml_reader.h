// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/closures/arm_builder.h"
#include "kinematics/closures/loop_closure.h"
#include "workcell/robots/robot_body.h"
#include "workcell/robots/robot_toml.h"
#include "workcell/text/toml_fields.h"

namespace hapticell::workcell {

/// Reads one robot.toml: what all kinds have in common in robot_toml.cpp, the kinds in robot_toml_serial.cpp and
/// robot_toml_parallel.cpp. The first problem counts, the rest is then without effect. For robot_toml.cpp alone.
class RobotTomlReader {
 public:
  RobotTomlReader(const toml::table& root, std::filesystem::path file, Diagnostics& diagnostics)
      : root_(root, "", error_), file_(std::move(file)), diagnostics_(diagnostics) {}

  Expected<TomlRobot> read();
  Expected<RobotSheet> readSheet();

 private:
  using JointData = kinematics::JointData;
  using RobotModel = kinematics::RobotModel;

  Expected<TomlRobot> failed();
  void failWith(const Error& cause, const toml::node* at);
  void readHead();
  void readLook();
  /// Limits and speeds in degrees, or in the unit of lengths where the joint slides.
  void readJoints();
  /// As many joints as the kind has; `slides[k]` tells the unit of joint k.
  std::vector<JointData> jointData(const std::vector<bool>& slides);
  void readKind();
  void takeModel(Expected<RobotModel> model, const toml::node* at);
  void readOpw();
  Pose readFlange();
  void addChainBody();
  void readDh();
  void readChain();
  void readDelta();
  void readHexapod();
  void readUrdfWithLoops();
  /// A moving joint becomes a fixed one.
  void lock(RobotModel& model, const std::string& name, TomlFields& fields);
  void readLoops(const RobotModel& tree, std::vector<kinematics::LoopConstraint>& loops);
  void readEnd(const RobotModel& tree, TomlFields& fields, const char* key, int& link, Pose& X);
  void readTools();

  std::optional<Error> error_;
  TomlFields root_;
  std::filesystem::path file_;
  Diagnostics& diagnostics_;
  TomlRobot robot_;
  RobotLook look_;
  int style_ = -1;  // Not said.
  double unit_ = 1.0;
  std::vector<std::string> names_;
  std::vector<double> lower_, upper_, velocity_, home_, rest_;
  const toml::table* joints_node_ = nullptr;
};

}  // namespace hapticell::workcell
