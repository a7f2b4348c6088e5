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

/// The robot's variable for each joint column of the trajectory, by name; columns q1, q2, ... count from base to tip.
/// Empty for a trajectory without joints. Error: the entity lacks a joint.
Expected<std::vector<std::size_t>> jointColumns(const workcell::Entity& entity,
                                                const trajectory::Trajectory& trajectory);

/// A motion as configurations of the moving entity, for playing it. Immutable; any thread.
class MotionReplay {
 public:
  /// `entities` are those of the document (the motion's reference frame may belong to another one). For a robot's
  /// motion without joints the inverse model computes them, each frame from the one before, beginning at `start` (one
  /// number per variable; empty: the robot's present joints). Errors: an unknown entity, no frames, joints or a moved
  /// frame that the entity does not have.
  static Expected<MotionReplay> create(const std::vector<std::shared_ptr<const workcell::Entity>>& entities,
                                       const std::string& entity,
                                       std::shared_ptr<const trajectory::Trajectory> trajectory,
                                       const std::vector<double>& start = {});

  workcell::EntityId entity() const { return entity_->id; }
  /// True if the motion places the entity as a whole; otherwise its joints move and it stays where it stands, or rides
  /// on what carries it.
  bool movesRoot() const { return moves_root_; }
  const trajectory::Trajectory& motion() const { return *trajectory_; }
  /// The entity's configuration at `t` (s of the trajectory, clamped to its ends).
  EntityConfiguration at(double t) const;
  /// The entity's moved frame in that configuration.
  Pose movedFrame(const EntityConfiguration& at) const;
  /// The moved frame at `t`.
  Pose movedFrameAt(double t) const { return trajectory_->poseAt(t); }
  /// The motion with joints in every frame: its own, or those of the inverse model.
  trajectory::Trajectory withJoints() const;
  /// Largest distance between a frame and the pose that the inverse model reached; 0 if the inverse model was not
  /// needed.
  const trajectory::PoseDistance& offPose() const { return off_pose_; }

 private:
  MotionReplay() = default;
  Expected<void> follow(const std::vector<double>& start);

  std::shared_ptr<const workcell::Entity> entity_;
  std::shared_ptr<const trajectory::Trajectory> trajectory_;
  std::vector<std::size_t> columns_;
  bool moves_root_ = false;  ///< The moved frame is fixed in the entity, so its pose gives the entity's placement.
  Pose X_EM_;
  std::vector<std::vector<double>> followed_;  ///< Joints of each frame, if the trajectory has no joints.
  trajectory::PoseDistance off_pose_;
};

/// Computes joints that bring the moved frame to the poses of a robot's trajectory: for each frame the solution nearest
/// to its joints. Call it after an edit of the poses; other trajectories are returned unchanged. Frames that it cannot
/// reach within 1e-6 (m, rad) are marked (is_pose_apart). Errors: joints that the entity does not have, no inverse
/// model. If a motion has joints only, its poses are computed instead.
Expected<trajectory::Trajectory> jointsFromPoses(const workcell::Entity& entity,
                                                 const trajectory::Trajectory& trajectory);

/// The inverse: computes the poses from the joints of a robot's trajectory.
Expected<trajectory::Trajectory> posesFromJoints(const workcell::Entity& entity,
                                                 const trajectory::Trajectory& trajectory);

}  // namespace hapticell::manipulation
