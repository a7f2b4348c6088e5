// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/timing/motion_path.h"
#include "trajectory/timing/time_optimal.h"

namespace hapticell::trajectory {

enum class TimingMode {
  kConstantSpeed,  ///< One speed of the moved frame, reached and left with the given acceleration.
  kTimeOptimal,    ///< As fast as the limits of the joints (for a solid: of the frame) allow.
};

struct RetimingOptions {
  TimingMode mode = TimingMode::kTimeOptimal;
  double speed = 0.1;         ///< m/s, for kConstantSpeed; rotation is converted by `metres_per_radian`.
  double acceleration = 1.0;  ///< m/s2, likewise.
  double metres_per_radian = 0.1;
  /// One entry per joint or, for a trajectory without joints, six: x, y, z, then the rotation about them.
  MotionLimits limits{};
  std::size_t grid_points = 1000;
  double sample_s = 0.01;  ///< Between the frames of the result; shorter if the tolerance requires it.
  /// How close the result passes each given frame, with straight segments between its own frames.
  PathTolerance tolerance{5e-5, 2e-4, 2e-4};
  /// Once true, the work ends with an error. Null: never.
  const std::atomic<bool>* stop = nullptr;
};

struct RetimingReport {
  double duration_before = 0.0, duration_after = 0.0;
  /// Of the given frames from the straight segments between the frames of the result.
  PoseDistance max_deviation{};
  double max_joint_deviation = 0.0;  ///< rad (m)
  LimitUse use{};                    ///< Share of the limits that the frames of the result use, kTimeOptimal only.
  std::size_t still_frames = 0;      ///< Frames dropped because nothing moved.
  std::size_t corners = 0;           ///< Corners at which the motion stops to pass them.
  double sample_s = 0.0;             ///< The sampling interval used.
};

struct Retimed {
  Trajectory trajectory;
  /// The result's times for the given frames: for each frame of `trajectory`, the time when the result passes the same
  /// place.
  Trajectory given;
  RetimingReport report;
};

/// A copy through the same places with new times, evenly sampled. Frames without motion are dropped first; at frames
/// with a dwell the motion stops and waits. Every given frame is passed within the tolerance; the motion stops at
/// corners that no smooth path passes within it. The limits hold for the differences of the result's frames (a mean
/// over them is all that a controller sees), from rest to rest.
///
/// A robot's poses match its joints only at given frames: the others are marked (is_pose_apart) until posesFromJoints()
/// of manipulation computes them.
///
/// Errors: fewer than two different frames, limits that are missing or not positive, joints at rest while the pose
/// moves (time-optimal), a pose at rest while joints move, or no poses at all (constant speed).
Expected<Retimed> retimed(const Trajectory& trajectory, const RetimingOptions& options);

}  // namespace hapticell::trajectory
