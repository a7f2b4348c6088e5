// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shapes/vector.h"

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
  bool cancelled = false;            ///< `progress` ended the check; the results cover the motion so far.
};

/// Findings that go on from frame to frame become one interval for each kind and name. One thread.
class FindingList {
 public:
  /// A finding of the present frame, at t (s); `worst` as in PathFinding.
  void add(PathFinding::Kind kind, const std::string& name, double t, double worst);

  /// After each frame: what was not added again is over, and goes into the result.
  void endFrame(PathCheckResult& result);

 private:
  using Key = std::pair<PathFinding::Kind, std::string>;
  std::map<Key, std::optional<PathFinding>> open_;
  std::vector<Key> touched_;
};

}  // namespace hapticell::manipulation
