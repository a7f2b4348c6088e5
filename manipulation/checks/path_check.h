// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/holding/held_entity.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::manipulation {

/// A finding of a check of a whole motion.
struct PathFinding {
  enum class Kind {
    kCollision,      ///< Two parts meet; checked continuously between the frames.
    kJointLimit,     ///< A joint beyond its limit.
    kJointSpeed,     ///< A joint faster than it can move.
    kSingularity,    ///< A direction of the tool centre point is (nearly) lost.
    kOffPose,        ///< The joints do not bring the tool centre point to the frame's pose.
    kConfiguration,  ///< A six-axis arm changes to another branch (through a singular position).
  };
  Kind kind = Kind::kCollision;
  double t_in = 0.0, t_out = 0.0;  ///< s
  std::string first, second;       ///< Collision: "robot/link_3", "fixture". Else the joint.
  double worst = 0.0;              ///< rad, m, rad/s: how far beyond; collisions: 0.
  dvec3 p_W{0.0};                  ///< Collision: where it begins.
};

/// "collision", "joint_limit", "joint_speed", "singularity", "off_pose", "configuration".
const char* toString(PathFinding::Kind kind);

struct PathCheckResult {
  std::vector<PathFinding> findings{};
  /// Pairs that already touch in the first frame (a robot on its table); listed separately because they touch at rest.
  std::vector<PathFinding> touching_at_start{};
  /// Least clearance (m) at the frames between pairs that are apart, to the cell (not between the robot's own parts);
  /// infinite if nothing comes near.
  double least_clearance = 0.0;
  std::string nearest_first, nearest_second;
  double t_nearest = 0.0;
  std::vector<std::string> notes{};  ///< What was not checked, in sentences: links that touch each other at rest.
  bool cancelled = false;  ///< `progress` ended the check; the results cover the motion so far.
};

struct PathCheckOptions {
  HoldOptions hold{};
  /// Motions of the robot's external axes, on the same clock (the same take); an axis without a motion does not move.
  /// Used if the motion has joints.
  std::vector<std::shared_ptr<const trajectory::Trajectory>> axes{};
  double look = 0.05;            ///< m: larger clearances are not measured.
  double pose_tolerance = 1e-4;  ///< m and rad, for kOffPose.
  /// Gets the progress (0 .. 1); returning false ends the check. Called in the checking thread; may be empty.
  std::function<bool(double)> progress = {};
};

/// Moves the entity, with everything attached to it, through the frames as the manipulation loop would: by its joints
/// if the trajectory has them (by name), else by its inverse model, nearest to the frame before. The motion between
/// frames is checked continuously, so thin parts are not skipped. It checks what HeldEntity checks: the entity's parts
/// and what it carries, against the cell and against each other. Errors: no such entity, no frames, a joint that the
/// robot does not have.
Expected<PathCheckResult> checkPath(std::shared_ptr<const PreparedScene> scene, const std::string& entity,
                                    const trajectory::Trajectory& trajectory, const PathCheckOptions& options,
                                    const config::Configuration& configuration);

}  // namespace hapticell::manipulation
