// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/system/error.h"
#include "trajectory/timing/motion_path.h"
#include "trajectory/timing/time_optimal.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

enum class TimingMode {
  kConstantSpeed,  ///< One speed of the moved frame all along, reached and left at the acceleration given.
  kTimeOptimal,    ///< As fast as the limits of the joints allow (of the frame, for a solid).
};

struct RetimingOptions {
  TimingMode mode = TimingMode::kTimeOptimal;
  double speed = 0.1;         ///< m/s, for kConstantSpeed; turning counts `metres_per_radian`.
  double acceleration = 1.0;  ///< m/s2, likewise.
  double metres_per_radian = 0.1;
  /// One entry a joint, or, for a trajectory without joints, six: x, y, z, then the rotation about them.
  MotionLimits limits{};
  std::size_t grid_points = 1000;
  double sample_s = 0.01;  ///< Between the frames of the result; shorter where the tolerance needs it.
  /// How near the result passes each given frame, straight ways between its own frames counted.
  PathTolerance tolerance{5e-5, 2e-4, 2e-4};
};

struct RetimingReport {
  double duration_before = 0.0, duration_after = 0.0;
  /// Of the given frames from the straight ways between the result's frames.
  PoseDistance max_deviation{};
  double max_joint_deviation = 0.0;  ///< rad (m)
  LimitUse use{};                    ///< Of the limits by the result's frames, kTimeOptimal only.
  std::size_t still_frames = 0;      ///< Dropped because nothing moved.
  std::size_t corners = 0;           ///< At which the motion rests to pass them.
  double sample_s = 0.0;             ///< That was taken.
};

struct Retimed {
  Trajectory trajectory;
  /// Where the given motion is at the same places of its way: frame for frame the times of `trajectory`.
  Trajectory given;
  RetimingReport report;
};

/// A copy that runs through the same places with new times, sampled evenly. Still frames are dropped first; frames with
/// a dwell are waited at (the motion comes to rest there). Every given frame is passed within the tolerance: corners
/// that no smooth path passes so are rested at. The limits hold for the differences of the result's frames (a mean over
/// them is all that a controller sees), from rest to rest.
///
/// A robot's poses are those that go with its joints only at given frames: the others are marked (is_pose_apart) until
/// manipulation's posesFromJoints() makes them.
///
/// Errors: fewer than two different frames, limits that are missing or not positive, joints that stand while the pose
/// moves (time-optimal), a pose that stands while joints move or no poses at all (constant speed).
Expected<Retimed> retimed(const Trajectory& trajectory, const RetimingOptions& options);

}  // namespace hapticell::trajectory
