// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <vector>

#include "kinematics/robot_model.h"

namespace hapticell::bench {

using Clock = std::chrono::steady_clock;

inline double nanoseconds(Clock::time_point begin) {
  return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

/// A pose of the tip and the joints that made it, uniform within limits.
struct ReachedPose {
  std::vector<double> q;
  Pose X_BT;
};
std::vector<ReachedPose> reachedPoses(const kinematics::RobotModel& model, int count);

/// "robot  what  mean  median  p99" in microseconds, of one number a call in nanoseconds.
void print(const char* robot, const char* what, std::vector<double>& ns);

/// The closed forms alone: mean of `poses` random poses, best of 15 passes, both builds.
void closedForms(int poses);
/// InverseModel::solveAll() and solve(): all solutions, found or not, calibrated arms.
void allSolutions(int poses);
/// The numeric model from random starts, beside KDL where it is installed.
void numericInverse(int poses);
/// Paths at 1 kHz: inside, through the wrist's singularity, past the boundary.
void paths(int poses);

}  // namespace hapticell::bench
