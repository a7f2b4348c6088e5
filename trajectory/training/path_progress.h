// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/shapes/pose.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// How far along an expert's motion a trainee is. Follows the trainee on and back, but only as far as a hand moves
/// between two looks, so that a path that crosses itself or comes back (a peg in and out of its hole) is not mistaken.
class PathProgress {
 public:
  PathProgress() = default;
  /// Places closer than 0.1 mm and 0.1 deg are one; turning counts `metres_per_radian` of way.
  /// @pre at least one frame
  explicit PathProgress(const Trajectory& expert, double metres_per_radian = 0.1);

  /// The whole way, m (turning included); 0 without motion.
  double length() const { return ways_.empty() ? 0.0 : ways_.back(); }
  double way() const { return way_; }
  double share() const { return length() > 0.0 ? way_ / length() : 1.0; }
  void restart() { way_ = 0.0; }

  /// Takes the trainee's pose; looks for the nearest place at most `reach` (m of way) from where it was.
  void follow(const Pose& X_WT, double reach = 0.03);
  /// How far the pose is from the expert's at the place where it is.
  PoseDistance deviation(const Pose& X_WT) const { return distanceBetween(expertAt(way_), X_WT); }
  /// The expert's pose and time at a place of the way.
  Pose expertAt(double way) const;
  double timeAt(double way) const;
  /// The path's points from `behind` (m of way) before the trainee to `ahead` of it: what a guide shows and feels.
  std::vector<dvec3> window(double behind, double ahead) const;

 private:
  std::size_t pieceAt(double way) const;
  std::vector<Pose> poses_;
  std::vector<double> ways_, times_;
  double metres_per_radian_ = 0.1;
  double way_ = 0.0;
};

}  // namespace hapticell::trajectory
