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

/// The tool's poses that go with a trajectory's joints, by a robot's forward kinematics.
///
/// The poses of a file are of a tool, in a world: where the given frames' poses are those of the robot's tip but for a
/// fixed place of its base, or a fixed tool, that is found from them and kept.
class ToolPoses {
 public:
  /// `robot`: a file or library:NAME. Errors: no such robot, joints that it does not have.
  static Expected<ToolPoses> create(const std::string& robot, const trajectory::Trajectory& given);

  /// False: the given poses are not those of the given joints, whatever the base or the tool.
  bool match() const { return match_; }
  Pose at(std::span<const double> joints) const;
  /// The same motion with poses by its joints in every frame, none of them marked.
  trajectory::Trajectory posesOf(const trajectory::Trajectory& motion) const;
  /// The largest distance of a pose from where the joints of its frame put the tool; frames that say so left out.
  trajectory::PoseDistance largestError(const trajectory::Trajectory& motion) const;

 private:
  void findPlacement(const trajectory::Trajectory& given);
  bool agrees(const trajectory::Trajectory& given) const;

  std::shared_ptr<const RobotWithTip> robot_;
  std::vector<std::size_t> columns_;  ///< The model's variable of each joint of the trajectory.
  Pose X_WB_, X_LT_;
  bool match_ = true;
};

}  // namespace hapticell::cli
