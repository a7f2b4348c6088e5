// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "manipulation/manipulators/manipulator.h"

namespace hapticell::manipulation {

/// An entity that the stylus moves as a rigid whole while something else moves its joints: a mannequin or a free hand
/// that a glove poses, a mannequin whose other hand a second stylus moves. Its joints are a tree (no closed loops).
class JointedWhole final : public Manipulator {
 public:
  struct Part {
    int link = 0;
    Pose X_LP;
  };
  /// The moved frame M is fixed in the entity's own frame E. Contract: `model` has no closure.
  JointedWhole(std::shared_ptr<const kinematics::RobotModel> model, const Pose& X_EM, std::vector<Part> parts);

  Pose movedFrame(const EntityConfiguration& configuration) const override;
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override;
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override;
  Pose partPose(const EntityConfiguration& configuration, std::size_t part) const override;
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override;
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration&, double, double) const override { return {}; }

 private:
  double stepOf(const kinematics::Joint& joint, const EntityConfiguration& from, const EntityConfiguration& to) const;

  std::shared_ptr<const kinematics::RobotModel> model_;  // Shared: documents and snapshots hold the same one.
  Pose X_EM_;
  std::vector<Part> parts_;
};

}  // namespace hapticell::manipulation
