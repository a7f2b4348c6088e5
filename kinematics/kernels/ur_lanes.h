// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/opw_lanes.h"

namespace hapticell::kinematics::kernels {
namespace {

// Lanes: shoulder x wrist; the two groups are the elbows.
inline void ur(const UrArm& arm, const ArmPose& pose, const double* previous, Solutions& solutions) {
  const double *R = pose.R, *p = pose.p;
  const ShoulderLanes turn = shoulder(p, arm.d4, arm.map, previous);
  const Lanes s1 = turn.s1, c1 = turn.c1;
  // The row y1^T R = (s5 c6, -s5 s6, c5).
  const Lanes X = c1 * R[3] - s1 * R[0], Y = c1 * R[4] - s1 * R[1], Z = c1 * R[5] - s1 * R[2];
  const Lanes size = squareRoot(X * X + Y * Y);
  const Lanes side(1.0, 1.0, -1.0, -1.0);
  const Mask free = size < Lanes(kFree);
  Lanes c6 = side * X / size, s6 = -(side * Y) / size;
  if (bitsOf(free) != 0) {
    Lanes c0, s0;
    previousAngle(arm.map, 5, previous, c0, s0);
    c6 = select(free, side * c0, c6);
    s6 = select(free, side * s0, s6);
  }
  const Lanes s5 = X * c6 - Y * s6;
  const auto axis5 = [&](int row) { return -(s6 * R[3 * row] + c6 * R[3 * row + 1]); };
  const Lanes z5x = axis5(0), z5y = axis5(1), c234 = axis5(2);
  const Lanes s234 = c1 * z5x + s1 * z5y;
  const Lanes x = c1 * p[0] + s1 * p[1] - arm.d5 * s234 - arm.a1;
  const Lanes z = p[2] - arm.d5 * c234;
  const Lanes r2 = x * x + z * z;
  const Lanes c3 = (r2 - (arm.c2 * arm.c2 + arm.c3 * arm.c3)) * (0.5 / (arm.c2 * arm.c3));
  const Lanes s3_squared = (Lanes(1.0) - c3) * (Lanes(1.0) + c3);
  const Mask reached = s3_squared >= Lanes(-kStretched);
  const Lanes s3 = squareRoot(maximum(s3_squared, 0.0));
  const Lanes A = c3 * arm.c3 + arm.c2, B = s3 * arm.c3;
  const Lanes theta1 = arcTangent(s1, c1), theta3 = arcTangent(s3, c3), theta5 = arcTangent(s5, Z);
  const Lanes theta6 = arcTangent(s6, c6), theta234 = arcTangent(s234, c234);
  const Lanes theta2[2] = {arcTangent(A * x - B * z, A * z + B * x), arcTangent(A * x + B * z, A * z - B * x)};
  for (int group = 0; group < 2; ++group) {
    const Lanes bend = group == 0 ? theta3 : -theta3;
    storeJoint(arm.map, 0, group, theta1, solutions);
    storeJoint(arm.map, 1, group, theta2[group], solutions);
    storeJoint(arm.map, 2, group, bend, solutions);
    storeJoint(arm.map, 3, group, theta234 - theta2[group] - bend, solutions);
    storeJoint(arm.map, 4, group, theta5, solutions);
    storeJoint(arm.map, 5, group, theta6, solutions);
  }
  const unsigned lanes = turn.far_enough ? bitsOf(reached) : 0u;
  solutions.valid = lanes | lanes << 4;
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
