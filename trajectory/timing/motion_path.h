// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "trajectory/motion/motion_spline.h"
#include "trajectory/timing/time_optimal.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// A way through given frames, over the way run: what is timed and what is written are the same curve. Limits are on
/// the joints, or on the position and the angular velocity about x, y, z of the world.
class MotionPath : public LimitedPath {
 public:
  virtual Pose pose(double u) const = 0;
  virtual std::vector<double> joints(double u) const = 0;
  /// Along it all limited coordinates change in proportion to u.
  virtual bool isStraight() const { return false; }
  /// It has corners that are rounded off within the tolerance: its bend and the change of that are great there.
  virtual bool isRounded() const { return false; }
};

/// What limits are on.
enum class LimitedBy { kJoints, kPose };

/// The straight way from the first frame to the last: origin on a line, rotation about a fixed axis (more than half a
/// turn where the frames between go so), joints in proportion.
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
  Pose X_WT_;  ///< At its begin.
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

/// The rotation from frame to frame, added up: rotation vectors in the world that do not leap at half a turn.
std::vector<dvec3> runningTurns(const Trajectory& frames);

/// A path that passes every frame within `tolerance`: straight where the frames are; else a spline of few spans, or
/// one with a span from frame to frame, where it passes the frames and stays by the straight ways between them (8 % of
/// their length, 1 mm or 0.25 degrees at most); else the frames' own straight ways with their corners rounded off
/// within the tolerance (Schoenberg's variation diminishing spline; de Boor, A Practical Guide to Splines, chapter XI).
/// `ways`: increasing, the way run at each frame.
/// @pre frames.size() == ways.size() >= 2
std::unique_ptr<MotionPath> pathThrough(const Trajectory& frames, std::span<const double> ways,
                                        const PathTolerance& tolerance, LimitedBy by);

/// Indices of inner frames at which the path turns so sharply (by more than `angle`, rad, seen at the scale of forty
/// tolerances) that it is passed best by resting there.
std::vector<std::size_t> cornersOf(const Trajectory& frames, const PathTolerance& tolerance, LimitedBy by,
                                   double angle);

}  // namespace hapticell::trajectory
