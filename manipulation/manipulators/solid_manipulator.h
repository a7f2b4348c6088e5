// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/manipulators/manipulator.h"

namespace hapticell::manipulation {

/// An entity that moves as one rigid body: a solid, or a robot by its base with its joints at rest.
class SolidManipulator final : public Manipulator {
 public:
  /// `X_EM` is the moved frame in the entity's frame; `X_EP` are the parts' poses in it.
  SolidManipulator(const Pose& X_EM, std::vector<Pose> X_EP);

  Pose movedFrame(const EntityConfiguration& configuration) const override;
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override;
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override;
  Pose partPose(const EntityConfiguration& configuration, std::size_t part) const override;
  bool movesJoints() const override { return false; }
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override;
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone, double lever) const override;

 private:
  Pose X_EM_;
  std::vector<Pose> X_EP_;
};

}  // namespace hapticell::manipulation
