// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory_checks {

// Measures a motion that was read back from its file. This code shares nothing but Trajectory with the code that
// smooths, simplifies, times or samples motions, so it can detect faults there.

/// The largest distance of given frames from a written motion, and the time of the given frame where each is (s).
struct Distances {
  double position = 0.0, t_position = 0.0;  ///< m
  double angle = 0.0, t_angle = 0.0;        ///< rad
  double joint = 0.0, t_joint = 0.0;        ///< rad (m)
};

/// How near things must be to count as passed; joints and poses count where both motions have them.
struct Nearness {
  double position = 0.001, angle = 0.0174533, joint = 0.001;
};

/// Each given frame from the straight ways between the written frames, in their order: the next one is looked for from
/// where the one before was passed on, to where the way comes within `near` of it. Where some frame is so nowhere
/// passed, all are looked for again within one and a half times as much, and so on: a frame that is missed does not
/// make the others be looked for further on, where the way comes by again.
Distances passing(const trajectory::Trajectory& given, const trajectory::Trajectory& written, const Nearness& near);

/// Each given frame from where the written motion is at the same time.
Distances atSameTimes(const trajectory::Trajectory& given, const trajectory::Trajectory& written);

/// Largest absolute time derivative of each limited number: joints, or x, y, z and the turn about them. Per second,
/// second squared and cubed, by divided differences over two, three and four frames (their k-th, times k!, is a mean of
/// the k-th derivative whatever the times between frames are), the motion standing before and after itself. Jerks are
/// looked at no closer than rounding allows beside `least_jerk`.
struct Derivatives {
  std::vector<double> speed, acceleration, jerk;
  std::vector<double> t_speed, t_acceleration, t_jerk;  ///< s, where each is.
};
Derivatives derivativesOf(const trajectory::Trajectory& written, bool by_joints, double least_jerk);

/// The greatest speed of the frame, m/s, turning counted by `metres_per_radian`; and when.
struct FrameSpeed {
  double speed = 0.0, t = 0.0;
};
FrameSpeed greatestSpeed(const trajectory::Trajectory& written, double metres_per_radian);

}  // namespace hapticell::trajectory_checks
