// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/lane_math.h"

namespace hapticell::kinematics::kernels {
namespace {

/// Sine or distance (m) below which a pose says nothing of an angle: then the joint keeps its place. Above, the pose's
/// rounding moves the joint by less than 1e-3 rad (half: 2e-3); below, the error is under 1e-12 (twice: 2e-12).
constexpr double kFree = 5e-13;
/// How far (1 - c)(1 + c) may be negative: the error 1e-16 of c is amplified by lengths, ten thousandfold is allowed.
/// Half: stretched poses may be lost; twice: one more candidate, that the check on the chain refuses.
constexpr double kStretched = 1e-12;

/// (position - offset) * sign, the canonical angle as a joint's position.
inline void storeJoint(const JointMap& map, int joint, int group, const Lanes& theta, Solutions& solutions) {
  store(solutions.q[joint] + 4 * group, (theta - map.offset[joint]) * map.sign[joint]);
}

/// Cosine and sine of the previous joint's canonical angle.
inline void previousAngle(const JointMap& map, int joint, const double* previous, Lanes& cosine, Lanes& sine) {
  const double theta = map.sign[joint] * previous[joint] + map.offset[joint];
  cosine = __builtin_cos(theta);
  sine = __builtin_sin(theta);
}

/// An angle turned by half a turn, towards zero.
inline Lanes halfTurned(const Lanes& theta) {
  return select(theta > Lanes(0.0), theta - kLanePi, theta + kLanePi);
}

struct ZyzAngles {
  Lanes first, second, third;
};

/// Numbers whose atan2 is an angle.
struct SineAndCosine {
  Lanes sine, cosine;
  Lanes angle() const { return arcTangent(sine, cosine); }
};
struct ThreeAngles {
  SineAndCosine first, second, third;
  ZyzAngles angles() const { return {first.angle(), second.angle(), third.angle()}; }
};

/// R = Rz(first) Ry(second) Rz(third) from the rows of R (see `rows`): the third angle is taken from what is left after
/// the first, so that their sum is right where the second is zero. `joint` is the first one's.
struct ZyzRows {
  Lanes xx, xy, xz, yx, yy, yz, zz;
};
inline ThreeAngles zyz(const ZyzRows& R, const JointMap& map, int joint, const double* previous) {
  const Lanes s = squareRoot(R.xz * R.xz + R.yz * R.yz);
  const Mask free = s < Lanes(kFree);
  Lanes c1 = R.xz / s, s1 = R.yz / s;
  if (bitsOf(free) != 0) {
    Lanes c0, s0;
    previousAngle(map, joint, previous, c0, s0);
    c1 = select(free, c0, c1);
    s1 = select(free, s0, s1);
  }
  return {{s1, c1}, {c1 * R.xz + s1 * R.yz, R.zz}, {c1 * R.yx - s1 * R.xx, c1 * R.yy - s1 * R.xy}};
}

/// Sine and cosine of joint 1 with the wrist before the arm and behind it, in turn, and how far it then lies ahead; the
/// arm's plane passes joint 1's axis at `beside`, and the wrist may lie too near to that for any turn.
struct ShoulderLanes {
  Lanes s1, c1, ahead;
  bool far_enough;
};
inline ShoulderLanes shoulder(const double* p, double beside, const JointMap& map, const double* previous) {
  const double flat = p[0] * p[0] + p[1] * p[1];
  const double ahead_squared = flat - beside * beside;
  const double ahead = __builtin_sqrt(ahead_squared > 0.0 ? ahead_squared : 0.0);
  const bool far_enough = ahead_squared >= -kStretched * (1.0 + flat);
  const Lanes X(ahead, -ahead, ahead, -ahead);
  if (flat < kFree * kFree) {
    Lanes c0, s0;
    previousAngle(map, 0, previous, c0, s0);
    const Lanes side(1.0, -1.0, 1.0, -1.0);
    return {side * s0, side * c0, X, far_enough};
  }
  return {(p[1] * X - p[0] * beside) / flat, (p[0] * X + p[1] * beside) / flat, X, far_enough};
}

inline void opw(const OpwArm& arm, const ArmPose& pose, const double* previous, Solutions& solutions) {
  const double *R = pose.R, *p = pose.p;
  const ShoulderLanes turn = shoulder(p, arm.b, arm.map, previous);
  const Lanes s1 = turn.s1, c1 = turn.c1, X = turn.ahead;
  const Lanes x = X - arm.a1;
  const Lanes z = p[2];
  const Lanes r2 = x * x + z * z;
  const Lanes c3 = (r2 - (arm.c2 * arm.c2 + arm.k * arm.k)) * (0.5 / (arm.c2 * arm.k));
  const Lanes s3_squared = (Lanes(1.0) - c3) * (Lanes(1.0) + c3);
  const Mask reached = s3_squared >= Lanes(-kStretched);
  const Lanes s3 = Lanes(1.0, 1.0, -1.0, -1.0) * squareRoot(maximum(s3_squared, 0.0));
  const Lanes A = c3 * arm.k + arm.c2, B = s3 * arm.k;
  const Lanes r2_inverse = 1.0 / r2;
  const Lanes sin2 = (A * x - B * z) * r2_inverse, cos2 = (A * z + B * x) * r2_inverse;
  // theta_3 = atan2(s3, c3) - psi, so sin and cos of theta_2 + theta_3 need no call.
  const Lanes sin3 = s3 * arm.cos_psi - c3 * arm.sin_psi, cos3 = c3 * arm.cos_psi + s3 * arm.sin_psi;
  const Lanes s23 = sin2 * cos3 + cos2 * sin3, c23 = cos2 * cos3 - sin2 * sin3;
  // Rows of R36 = (Rz(1) Ry(23))^T R.
  const auto ahead_part = [&](int column) { return c1 * R[column] + s1 * R[3 + column]; };
  const auto side_part = [&](int column) { return c1 * R[3 + column] - s1 * R[column]; };
  const Lanes u0 = ahead_part(0), u1 = ahead_part(1), u2 = ahead_part(2);
  const ZyzRows R36{c23 * u0 - s23 * R[6], c23 * u1 - s23 * R[7], c23 * u2 - s23 * R[8], side_part(0),
                    side_part(1),          side_part(2),          s23 * u2 + c23 * R[8]};
  const ZyzAngles wrist = zyz(R36, arm.map, 3, previous).angles();
  const Lanes theta1 = arcTangent(s1, c1), theta2 = arcTangent(sin2, cos2), theta3 = arcTangent(sin3, cos3);
  for (int group = 0; group < 2; ++group) {
    storeJoint(arm.map, 0, group, theta1, solutions);
    storeJoint(arm.map, 1, group, theta2, solutions);
    storeJoint(arm.map, 2, group, theta3, solutions);
  }
  storeJoint(arm.map, 3, 0, wrist.first, solutions);
  storeJoint(arm.map, 4, 0, wrist.second, solutions);
  storeJoint(arm.map, 5, 0, wrist.third, solutions);
  storeJoint(arm.map, 3, 1, halfTurned(wrist.first), solutions);
  storeJoint(arm.map, 4, 1, -wrist.second, solutions);
  storeJoint(arm.map, 5, 1, halfTurned(wrist.third), solutions);
  const unsigned lanes = turn.far_enough ? bitsOf(reached) : 0u;
  solutions.valid = lanes | lanes << 4;
}

inline double opwError(const OpwArm& arm, const ArmPose& pose, const Solutions& solutions) {
  const double *R = pose.R, *p = pose.p;
  const auto theta = [&](int joint, int group) {
    return load(solutions.q[joint] + 4 * group) * arm.map.sign[joint] + arm.map.offset[joint];
  };
  double worst = 0.0;
  Lanes s1, c1, s2, c2, s23, c23;
  const Lanes theta2 = theta(1, 0);
  sineCosine(theta(0, 0), s1, c1);
  sineCosine(theta2, s2, c2);
  sineCosine(theta2 + theta(2, 0), s23, c23);
  const double a2 = arm.k * arm.sin_psi, c3 = arm.k * arm.cos_psi;
  const Lanes x = arm.a1 + s2 * arm.c2 + c23 * a2 + s23 * c3, z = c2 * arm.c2 - s23 * a2 + c23 * c3;
  Lanes error = maximum(absolute(c1 * x - s1 * arm.b - p[0]), absolute(s1 * x + c1 * arm.b - p[1]));
  error = maximum(error, absolute(z - p[2]));
  Lanes row_x[3], row_y[3], row_z[3];
  for (int i = 0; i < 3; ++i) {
    const Lanes u = c1 * R[i] + s1 * R[3 + i];
    row_x[i] = c23 * u - s23 * R[6 + i];
    row_y[i] = c1 * R[3 + i] - s1 * R[i];
    row_z[i] = s23 * u + c23 * R[6 + i];
  }
  for (int group = 0; group < 2; ++group) {
    Lanes s4, c4, s5, c5, s6, c6;
    sineCosine(theta(3, group), s4, c4);
    sineCosine(theta(4, group), s5, c5);
    sineCosine(theta(5, group), s6, c6);
    const Lanes c45 = c4 * c5, s45 = s4 * c5;
    Lanes off = error;
    const auto check = [&](const Lanes& made, const Lanes& wanted) { off = maximum(off, absolute(made - wanted)); };
    check(c45 * c6 - s4 * s6, row_x[0]);
    check(-c45 * s6 - s4 * c6, row_x[1]);
    check(c4 * s5, row_x[2]);
    check(s45 * c6 + c4 * s6, row_y[0]);
    check(c4 * c6 - s45 * s6, row_y[1]);
    check(s4 * s5, row_y[2]);
    check(c5, row_z[2]);
    check(-s5 * c6, row_z[0]);
    check(s5 * s6, row_z[1]);
    for (int lane = 0; lane < 4; ++lane) {
      if ((solutions.valid >> (4 * group + lane) & 1u) != 0 && !(off[lane] <= worst)) worst = off[lane];
    }
  }
  return worst;
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
