// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/kit/robot_options.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// Computes the tool's poses for the joints of a trajectory, by a robot's forward kinematics.
///
/// The poses in a file are those of some tool in some world: if the given poses are those of the robot's tip except for
/// a constant base pose, or a constant tool, these are determined from the poses and kept.
class ToolPoses {
 public:
  /// `robot`: a file or library:NAME. Errors: no such robot, joints that it does not have.
  static Expected<ToolPoses> create(const std::string& robot, const trajectory::Trajectory& given);

  /// False: the given poses do not belong to the given joints, whatever the base or the tool.
  bool match() const { return match_; }
  Pose at(std::span<const double> joints) const;
  /// The same motion with poses computed from its joints in every frame, none of them marked.
  trajectory::Trajectory posesOf(const trajectory::Trajectory& motion) const;
  /// The largest distance of a pose from where its frame's joints put the tool, except for frames marked independent.
  trajectory::PoseDistance largestError(const trajectory::Trajectory& motion) const;

 private:
  void findPlacement(const trajectory::Trajectory& given);
  bool agrees(const trajectory::Trajectory& given) const;

  std::shared_ptr<const RobotWithTip> robot_;
  std::vector<std::size_t> columns_;  ///< The variable of the model for each joint of the trajectory.
  Pose X_WB_, X_LT_;
  bool match_ = true;
};

}  // namespace hapticell::cli
