// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/closures/arm_builder.h"
#include "workcell/robots/robot_body.h"
#include "workcell/robots/robot_toml.h"
#include "workcell/text/toml_fields.h"

namespace hapticell::workcell {

/// The body that a robot.toml asks for.
enum class BodyStyle { kOfTheKind, kArm, kCobot, kScara, kGantry, kNone };

/// The common parts of robot.toml files of all kinds: the data sheet, the look of the body and the data of the joints.
/// Keeps the first problem; later calls have no effect then.
class RobotTomlCommon {
 public:
  RobotTomlCommon(const toml::table& root, std::filesystem::path file)
      : root_(root, "", error_), file_(std::move(file)) {}
  RobotTomlCommon(const RobotTomlCommon&) = delete;
  RobotTomlCommon& operator=(const RobotTomlCommon&) = delete;

  void readHead();
  void readLook();
  /// Limits and speeds in degrees, or in the unit of length for sliding joints.
  void readJoints();
  /// Data of as many joints as the kind has; `slides[k]` selects the unit of joint k. Fills rest().
  std::vector<kinematics::JointData> jointData(const std::vector<bool>& slides);

  /// Notes `cause` at the line of `at`, unless there is an earlier problem.
  void failWith(const Error& cause, const toml::node* at);
  /// The first problem, with the file's name. Only valid if there is one.
  Error failure() const;
  std::optional<Error>& error() { return error_; }

  TomlFields& root() { return root_; }
  const std::filesystem::path& file() const { return file_; }
  const RobotSheet& sheet() const { return sheet_; }
  const RobotLook& look() const { return look_; }
  BodyStyle style() const { return style_; }
  double unit() const { return unit_; }  ///< m per unit of length in the file.
  std::size_t jointCount() const { return lower_.size(); }
  const std::vector<double>& rest() const { return rest_; }  ///< Home position, rad or m; empty if not given.

 private:
  std::optional<Error> error_;
  TomlFields root_;
  std::filesystem::path file_;
  RobotSheet sheet_;
  RobotLook look_;
  BodyStyle style_ = BodyStyle::kOfTheKind;
  double unit_ = 1.0;
  std::vector<std::string> names_;
  std::vector<double> lower_, upper_, velocity_, home_, rest_;
  const toml::table* joints_node_ = nullptr;
};

}  // namespace hapticell::workcell
