// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/tool_poses.h"

#include <algorithm>

namespace hapticell::cli {

namespace {

using trajectory::PoseDistance;
using trajectory::Trajectory;

/// m, rad: of poses as files give them with five digits. Half: those do not agree; twice: a tool 20 um off is taken.
constexpr double kSameAsFile = 1e-5;
/// m, rad: of poses that were smoothed apart from the joints (their ends are met). Half: strongly smoothed ones do not
/// agree; twice: another tool, 40 mm off, is taken.
constexpr double kNear = 0.02;
/// Frames that are looked at to find base or tool. Half: a short difference may be missed; twice: twice the time.
constexpr std::size_t kMostLooks = 200;

}  // namespace

Expected<ToolPoses> ToolPoses::create(const std::string& name, const Trajectory& given) {
  auto robot = readRobotWithTip(name, "", workcell::RobotContent::kKinematics);
  HAPTICELL_TRY(robot);
  ToolPoses tool;
  const auto names = robot->jointNames();
  for (std::size_t j = 0; j < given.joint_names.size(); ++j) {
    const std::string& joint = given.joint_names[j];
    auto at = std::find(names.begin(), names.end(), joint);
    // CSV twins name their columns q1, q2, ... from base to tip.
    if (at == names.end() && joint == "q" + std::to_string(j + 1) && j < names.size())
      at = names.begin() + static_cast<std::ptrdiff_t>(j);
    if (at == names.end())
      return makeError({.place = Text("joint '%1'", joint),
                        .found = "the robot has no joint of this name",
                        .expected = "names of the robot's joints"});
    tool.columns_.push_back(static_cast<std::size_t>(robot->variables[static_cast<std::size_t>(at - names.begin())]));
  }
  tool.robot_ = std::make_shared<const RobotWithTip>(std::move(*robot));
  tool.findPlacement(given);
  return tool;
}

Pose ToolPoses::at(std::span<const double> joints) const {
  std::vector<double> q(robot_->model.dof(), 0.0);
  for (std::size_t j = 0; j < columns_.size(); ++j) q[columns_[j]] = joints[j];
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(robot_->model, q, X_BL);
  return X_WB_ * X_BL[static_cast<std::size_t>(robot_->tip)] * X_LT_;
}

bool ToolPoses::agrees(const Trajectory& given) const {
  const std::size_t step = std::max<std::size_t>(1, given.size() / kMostLooks);
  for (std::size_t i = 0; i < given.size(); i += step) {
    const PoseDistance off = trajectory::distanceBetween(at(given.joints(i)), given[i].X_WT);
    const double same = given[i].is_pose_apart ? kNear : kSameAsFile;
    if (off.position > same || off.angle > same) return false;
  }
  return true;
}

void ToolPoses::findPlacement(const Trajectory& given) {
  if (!given.has_poses || given.empty() || agrees(given)) return;
  const Pose X_BT = at(given.joints(0));
  X_WB_ = given[0].X_WT * X_BT.inverse();
  if (agrees(given)) return;
  X_WB_ = Pose::identity();
  X_LT_ = X_BT.inverse() * given[0].X_WT;
  if (agrees(given)) return;
  X_LT_ = Pose::identity();
  match_ = false;
}

Trajectory ToolPoses::posesOf(const Trajectory& motion) const {
  Trajectory result = motion.emptyRecording();
  result.touches = motion.touches;
  result.has_poses = true;
  result.reserve(motion.size());
  for (std::size_t i = 0; i < motion.size(); ++i) {
    Trajectory::Frame frame = motion[i];
    frame.X_WT = at(motion.joints(i));
    frame.is_pose_apart = false;
    result.addFrame(frame, motion.joints(i), motion.channels(i));
  }
  return result;
}

PoseDistance ToolPoses::largestError(const Trajectory& motion) const {
  PoseDistance worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion[i].is_pose_apart) continue;
    const PoseDistance off = trajectory::distanceBetween(at(motion.joints(i)), motion[i].X_WT);
    worst = {std::max(worst.position, off.position), std::max(worst.angle, off.angle)};
  }
  return worst;
}

}  // namespace hapticell::cli
