// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/manipulators/robot_manipulator.h"

namespace hapticell::manipulation {

/// A robot that is moved by its base while its tool centre point stays where it is in the cell: the joints follow by
/// the inverse model. The base moves only as far as the tool can be kept; the joints' limits are felt.
class RobotBaseManipulator final : public Manipulator {
 public:
  /// The tool keeps its pose of `taken`. `inverse` is for the same tool.
  RobotBaseManipulator(std::shared_ptr<const kinematics::RobotModel> model, const RobotManipulator::Tool& tool,
                       std::unique_ptr<const kinematics::InverseModel> inverse,
                       std::vector<RobotManipulator::Part> parts, const EntityConfiguration& taken);

  Pose movedFrame(const EntityConfiguration& configuration) const override { return configuration.X_WE; }
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  MotionTime leastTime(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override;
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override;
  Pose partPose(const EntityConfiguration& configuration, std::size_t part) const override;
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override;
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  /// By differences of the inverse model, to second order.
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone, double lever) const override;

 private:
  bool follow(const EntityConfiguration& from, const Pose& X_WE, double duration_s, EntityConfiguration& to) const;

  std::shared_ptr<const kinematics::RobotModel> model_;  // Shared: documents and snapshots hold the same one.
  RobotManipulator::Tool tool_;
  RobotManipulator arm_;
  std::size_t parts_;
  Pose X_WT_;  ///< The tool's fixed pose.
};

}  // namespace hapticell::manipulation
