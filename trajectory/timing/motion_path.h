// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "trajectory/motion/motion_spline.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/timing/time_optimal.h"

namespace hapticell::trajectory {

/// A curve through given frames, by path length: the same curve is timed and written. The limits apply to the joints,
/// or to the position and the angular velocity about x, y, z of the world.
class MotionPath : public LimitedPath {
 public:
  virtual Pose pose(double u) const = 0;
  virtual std::vector<double> joints(double u) const = 0;
  /// All limited coordinates change in proportion to u along the path.
  virtual bool isStraight() const { return false; }
  /// The path has corners that are rounded within the tolerance: its curvature and the change of it are large there.
  virtual bool isRounded() const { return false; }
};

/// The coordinates that limits apply to.
enum class LimitedBy { kJoints, kPose };

/// The straight path from the first frame to the last: origin on a line, rotation about a fixed axis (more than half a
/// turn if the frames between require it), joints in proportion.
class StraightPath : public MotionPath {
 public:
  StraightPath(const Trajectory& frames, double length, LimitedBy by);

  std::size_t dimensions() const override { return first_.size(); }
  const std::vector<double>& breaks() const override { return breaks_; }
  void derivatives(double u, std::span<double> first, std::span<double> second) const override;
  Pose pose(double u) const override;
  std::vector<double> joints(double u) const override;
  bool isStraight() const override { return true; }

 private:
  std::vector<double> breaks_, first_;
  Pose X_WT_;  ///< At its start.
  dvec3 way_{0.0}, turn_{0.0};
  std::vector<double> start_, change_;  ///< Of the joints.
};

/// A spline through position, quaternion and joints.
class CurvedPath : public MotionPath {
 public:
  CurvedPath(MotionSpline spline, LimitedBy by, bool rounded)
      : spline_(std::move(spline)), by_(by), rounded_(rounded) {}

  std::size_t dimensions() const override { return by_ == LimitedBy::kPose ? 6 : spline_.spline().dimensions() - 7; }
  const std::vector<double>& breaks() const override { return spline_.spline().breaks(); }
  void derivatives(double u, std::span<double> first, std::span<double> second) const override;
  Pose pose(double u) const override { return spline_.pose(u); }
  std::vector<double> joints(double u) const override { return spline_.joints(u); }
  bool isRounded() const override { return rounded_; }

 private:
  MotionSpline spline_;
  LimitedBy by_;
  bool rounded_;
};

/// The rotation from frame to frame, summed: rotation vectors in the world without a jump at half a turn.
std::vector<dvec3> runningTurns(const Trajectory& frames);

/// A path that passes every frame within `tolerance`: straight if the frames are; otherwise a spline with few spans, or
/// one span between each two frames, if it passes through the frames and stays close to the straight segments between
/// them (8 % of their length, at most 1 mm or 0.25 degrees); otherwise the straight segments of the frames with corners
/// rounded within the tolerance (Schoenberg's variation diminishing spline; de Boor, A Practical Guide to Splines,
/// chapter XI). `ways`: increasing, the path length at each frame.
/// @pre frames.size() == ways.size() >= 2
std::unique_ptr<MotionPath> pathThrough(const Trajectory& frames, std::span<const double> ways,
                                        const PathTolerance& tolerance, LimitedBy by);

/// Indices of inner frames where the path turns so sharply (by more than `angle`, rad, seen at the scale of forty
/// tolerances) that stopping there is the fastest way to pass.
std::vector<std::size_t> cornersOf(const Trajectory& frames, const PathTolerance& tolerance, LimitedBy by,
                                   double angle);

}  // namespace hapticell::trajectory
