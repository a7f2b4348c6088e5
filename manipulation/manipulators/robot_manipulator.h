// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_model.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/manipulators/singularity_wall.h"

namespace hapticell::manipulation {

struct RobotDifferential;

/// A robot that is dragged by its tool centre point: the inverse model nearest to the previous joints moves the arm,
/// and its joint limits and the edge of its workspace are felt.
///
/// One proposal never moves a joint further than its greatest speed allows in the given time: at a wrist singularity
/// the arm swings round in many steps, keeping its position (or what kinematics::SingularityChoice selects), and never
/// jumps. The next step proposes the rest of the motion.
class RobotManipulator final : public Manipulator {
 public:
  struct Tool {
    int tip_link = 0;
    Pose X_LT;  ///< Tool centre point in the tip link.
  };
  /// A moved part: a link's own shape, or a part attached to the link (a gripped part).
  struct Part {
    int link = 0;
    Pose X_LP;
  };
  /// `inverse` is for the same tool.
  RobotManipulator(std::shared_ptr<const kinematics::RobotModel> model, const Tool& tool,
                   std::unique_ptr<const kinematics::InverseModel> inverse, std::vector<Part> parts);
  /// Makes singularities walls that are felt and never passed. No effect on robots with closed loops, whose closure has
  /// its own limits.
  void stopAtSingularities();
  /// The parts for these links.
  static std::vector<Part> partsOf(const std::vector<int>& links);

  Pose movedFrame(const EntityConfiguration& configuration) const override;
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  MotionTime leastTime(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override;
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override;
  Pose partPose(const EntityConfiguration& configuration, std::size_t part) const override;
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override;
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone, double lever) const override;
  double resistance(const EntityConfiguration& configuration, std::span<const double> friction) const override;

 private:
  EntityConfiguration proposeFreely(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const;
  MotionLimit wallAt(const EntityConfiguration& configuration, const RobotDifferential& robot) const;
  std::vector<Pose> linkPoses(const EntityConfiguration& configuration) const;
  void closedPathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                        std::span<const PartSphere> spheres, std::span<double> bounds) const;

  std::shared_ptr<const kinematics::RobotModel> model_;  // Shared: documents and snapshots hold the same one.
  Tool tool_;
  std::unique_ptr<const kinematics::InverseModel> inverse_;
  std::vector<Part> parts_;
  std::optional<SingularityWall> wall_;
};

}  // namespace hapticell::manipulation
