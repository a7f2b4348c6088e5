// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/shapes/pose.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// A trainee's progress along an expert's motion. Follows the trainee forward and back, but only as far as a hand can
/// move between two calls, so that a path that crosses itself or returns (a peg in and out of its hole) is followed
/// correctly.
class PathProgress {
 public:
  PathProgress() = default;
  /// Places closer than 0.1 mm and 0.1 deg count as one; rotation is converted to length by `metres_per_radian`.
  /// @pre at least one frame
  explicit PathProgress(const Trajectory& expert, double metres_per_radian = 0.1);

  /// The total length, m (rotation included); 0 without motion.
  double length() const { return ways_.empty() ? 0.0 : ways_.back(); }
  double way() const { return way_; }
  /// Share of the way to where the expert arrived, 0 .. 1: first within 1 mm of the last pose, and from there on within
  /// 4 mm (or 10 % of the length, if that is less). A hand settles when it lets go, which nobody is asked to repeat.
  double share() const { return arrival_ > 0.0 ? std::min(1.0, way_ / arrival_) : 1.0; }
  void restart() { way_ = 0.0; }
  /// Goes to a place, limited to the path.
  void setWay(double way) { way_ = std::clamp(way, 0.0, length()); }

  /// Takes the trainee's pose and searches for the nearest place within `reach` (m of path length) of the last one.
  void follow(const Pose& X_WT, double reach = 0.03);
  /// The deviation of the pose from the expert's pose at the present place.
  PoseDistance deviation(const Pose& X_WT) const { return distanceBetween(expertAt(way_), X_WT); }
  /// The expert's pose and time at a place on the path.
  Pose expertAt(double way) const;
  double timeAt(double way) const;
  /// The points of the path from `behind` (m of path length) behind the trainee to `ahead` in front: the part that a
  /// guide shows and makes felt.
  std::vector<dvec3> window(double behind, double ahead) const;

 private:
  std::size_t pieceAt(double way) const;
  double away(const Pose& X_WT, const Pose& X_WE) const;
  double arrivalWay() const;
  std::vector<Pose> poses_;
  std::vector<double> ways_, times_;
  double metres_per_radian_ = 0.1;
  double way_ = 0.0, arrival_ = 0.0;
};

}  // namespace hapticell::trajectory
