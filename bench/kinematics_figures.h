// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::bench {

/// Nanoseconds that this thread worked; what other programs do to the machine is out of it.
inline double threadTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// What reading the clock twice costs by itself, taken off each single call.
double clockCost();

/// The time of one call, ns.
template <typename Call>
double timed(const Call& call) {
  const double begin = threadTime();
  call();
  const double end = threadTime();
  return std::max(0.0, end - begin - clockCost());
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
/// Seven axes: how often solveAll() has no solution within limits where solve() has one, and the times of both.
void sevenAxisLists(int poses);
/// The numeric model from random starts, beside KDL where it is installed.
void numericInverse(int poses);
/// Paths at 1 kHz: inside, through the wrist's singularity, past the boundary.
void paths(int poses);

}  // namespace hapticell::bench
