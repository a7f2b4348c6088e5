// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/lanes.h"

namespace hapticell::kinematics::kernels {
namespace {

/// Columns in lanes; the fourth lane is of no use.
inline void map(const ArmFrames& frames, const double* R_BT, const double* p_BT, ArmPose& pose) {
  const Lanes x = load(frames.R_0B[0]), y = load(frames.R_0B[1]), z = load(frames.R_0B[2]);
  const auto turned = [&](double a, double b, double c) { return a * x + b * y + c * z; };
  const Lanes R_0T[3] = {turned(R_BT[0], R_BT[1], R_BT[2]), turned(R_BT[3], R_BT[4], R_BT[5]),
                         turned(R_BT[6], R_BT[7], R_BT[8])};
  const auto combined = [&](double a, double b, double c) { return a * R_0T[0] + b * R_0T[1] + c * R_0T[2]; };
  const double* p = frames.p_B0;
  const Lanes columns[4] = {combined(frames.R_TN[0], frames.R_TN[3], frames.R_TN[6]),
                            combined(frames.R_TN[1], frames.R_TN[4], frames.R_TN[7]),
                            combined(frames.R_TN[2], frames.R_TN[5], frames.R_TN[8]),
                            turned(p_BT[0] - p[0], p_BT[1] - p[1], p_BT[2] - p[2]) +
                                combined(frames.p_TN[0], frames.p_TN[1], frames.p_TN[2])};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.R[3 * row + column] = columns[column][row];
    pose.p[row] = columns[3][row];
  }
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
