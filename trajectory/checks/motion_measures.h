// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory_checks {

// Measures a motion that was read back from its file. This code shares nothing but Trajectory with the code that
// smooths, simplifies, times or samples motions, so it can detect faults there.

/// The largest deviation of the given frames from a written motion, and the time of the given frame where it occurs
/// (s).
struct Distances {
  double position = 0.0, t_position = 0.0;  ///< m
  double angle = 0.0, t_angle = 0.0;        ///< rad
  double joint = 0.0, t_joint = 0.0;        ///< rad (m)
};

/// How close the written motion must pass. Joints and poses count only if both motions have them.
struct Nearness {
  double position = 0.001, angle = 0.0174533, joint = 0.001;
};

/// Measures each given frame, in order, against the straight segments between the written frames. The search for a
/// frame starts where the frame before it was passed, and ends where the path comes within `near` of it. If some frame
/// is not passed within `near`, the whole search is repeated with one and a half times the value, and so on. In this
/// way one missed frame does not shift the search of the others to a later part of the path that passes the same place
/// again.
Distances passing(const trajectory::Trajectory& given, const trajectory::Trajectory& written, const Nearness& near);

/// Measures each given frame against the pose of the written motion at the same time.
Distances atSameTimes(const trajectory::Trajectory& given, const trajectory::Trajectory& written);

/// The largest absolute time derivatives of each limited quantity: the joints, or x, y, z and the rotation about them.
/// First to third derivative, by divided differences over two, three and four frames (k! times the k-th difference is a
/// mean of the k-th derivative for any spacing of the frames); the motion is taken to be at rest before and after.
/// Jerks smaller than `least_jerk` are not resolved because of rounding.
struct Derivatives {
  std::vector<double> speed, acceleration, jerk;
  std::vector<double> t_speed, t_acceleration, t_jerk;  ///< s, time of each maximum.
};
Derivatives derivativesOf(const trajectory::Trajectory& written, bool by_joints, double least_jerk);

/// The greatest speed of the moved frame, m/s, with rotation converted by `metres_per_radian`; and its time.
struct FrameSpeed {
  double speed = 0.0, t = 0.0;
};
FrameSpeed greatestSpeed(const trajectory::Trajectory& written, double metres_per_radian);

}  // namespace hapticell::trajectory_checks
