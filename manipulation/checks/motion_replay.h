// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/manipulators/manipulator.h"
#include "trajectory/motion/trajectory.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// For each joint column of the trajectory the robot's variable, by name; columns q1, q2, ... count from base to tip.
/// Empty for a trajectory without joints. Errors: a joint that the entity does not have.
Expected<std::vector<std::size_t>> jointColumns(const workcell::Entity& entity,
                                                const trajectory::Trajectory& trajectory);

/// A motion as configurations of the entity that goes through it: what a play draws. Immutable; any thread.
class MotionReplay {
 public:
  /// `entities` are those of the document (a frame that the motion is about may be another's). A robot's motion without
  /// joints is followed by its inverse model, each frame from the one before. Errors: an unknown entity, no frames,
  /// joints or a moved frame that the entity does not have.
  /// The inverse model begins at `start` (one a variable; empty: as the robot stands).
  static Expected<MotionReplay> create(const std::vector<std::shared_ptr<const workcell::Entity>>& entities,
                                       const std::string& entity,
                                       std::shared_ptr<const trajectory::Trajectory> trajectory,
                                       const std::vector<double>& start = {});

  workcell::EntityId entity() const { return entity_->id; }
  const trajectory::Trajectory& motion() const { return *trajectory_; }
  /// Where the entity is at `t` (s of the trajectory, clamped to its ends).
  EntityConfiguration at(double t) const;
  /// The moved frame of the entity when it stands so.
  Pose movedFrame(const EntityConfiguration& at) const;
  /// The moved frame there.
  Pose movedFrameAt(double t) const { return trajectory_->poseAt(t); }
  /// The motion with the joints of every frame: as it is where it has them, else as the inverse model found them.
  trajectory::Trajectory withJoints() const;
  /// Largest distance of a frame from where the inverse model could bring the moved frame; 0 where it was not needed.
  const trajectory::PoseDistance& offPose() const { return off_pose_; }

 private:
  MotionReplay() = default;
  Expected<void> follow(const std::vector<double>& start);

  std::shared_ptr<const workcell::Entity> entity_;
  std::shared_ptr<const trajectory::Trajectory> trajectory_;
  std::vector<std::size_t> columns_;
  bool moves_root_ = false;  ///< The moved frame is fixed in the entity: it places it.
  Pose X_EM_;
  std::vector<std::vector<double>> followed_;  ///< Joints of each frame, where the trajectory has none.
  trajectory::PoseDistance off_pose_;
};

/// Joints that bring the moved frame to the poses of a robot's trajectory: for each frame the solution nearest to the
/// joints that it has. What an edit of the poses needs; other trajectories come back as they are. Frames that it cannot
/// bring within 1e-6 (m, rad) are marked (is_pose_apart). Errors: joints that the entity does not have, no inverse
/// model. A motion of joints alone is given its poses instead.
Expected<trajectory::Trajectory> jointsFromPoses(const workcell::Entity& entity,
                                                 const trajectory::Trajectory& trajectory);

/// The poses that the joints of a robot's trajectory make; the other way round.
Expected<trajectory::Trajectory> posesFromJoints(const workcell::Entity& entity,
                                                 const trajectory::Trajectory& trajectory);

}  // namespace hapticell::manipulation
