// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/opw_lanes.h"

namespace hapticell::kinematics::kernels {
namespace {

/// Rz(1) Ry(2) Rz(3) with the third column z3 and the second column y3.
inline ThreeAngles shoulder(const Lanes3& z3, const Lanes3& y3, const JointMap& map, const double* previous) {
  const Lanes s = squareRoot(z3.x * z3.x + z3.y * z3.y);
  const Mask free = s < Lanes(kFree);
  Lanes c1 = z3.x / s, s1 = z3.y / s;
  if (bitsOf(free) != 0) {
    Lanes c0, s0;
    previousAngle(map, 0, previous, c0, s0);
    c1 = select(free, c0, c1);
    s1 = select(free, s0, s1);
  }
  const Lanes s2 = c1 * z3.x + s1 * z3.y;
  // y3 in the frame turned by theta_1 and theta_2 is (-sin, cos, 0); its part along Ry(2)'s x needs no division.
  const Lanes ahead = c1 * y3.x + s1 * y3.y, side = c1 * y3.y - s1 * y3.x;
  return {{s1, c1}, {s2, z3.z}, {s2 * y3.z - z3.z * ahead, side}};
}

inline Lanes3 column(const ArmPose& pose, int i) {
  return {pose.R[i], pose.R[3 + i], pose.R[6 + i]};
}

/// The triangle of shoulder, elbow and wrist, and the circle that the elbow may lie on.
struct ElbowCircle {
  double cos_a, sin_a, cos_b, sin_b;  ///< Angles at the shoulder and at the wrist.
  double sin_4, cos_4;
  double w[3], up[3], side[3];  ///< The line's direction, "up" in its vertical plane, the third direction.
  bool reached = false;
};

inline ElbowCircle elbowCircle(const SevenArm& arm, const ArmPose& pose) {
  ElbowCircle c;
  const double* p = pose.p;
  // Roots and divisions side by side: what waits for another is most of the time.
  const double flat2 = p[0] * p[0] + p[1] * p[1], r2 = flat2 + p[2] * p[2];
  const double flat = __builtin_sqrt(flat2), r = __builtin_sqrt(r2);
  const double l1 = arm.d3, l2 = arm.d5, to_l1 = 0.5 / l1, to_l2 = 1.0 / l2;
  const double r_inverse = 1.0 / r;
  c.cos_a = (r2 + l1 * l1 - l2 * l2) * to_l1 * r_inverse;  // at the shoulder, between upper arm and line
  const double sin_a_squared = (1.0 - c.cos_a) * (1.0 + c.cos_a);
  if (!(sin_a_squared >= -kStretched)) return c;
  c.reached = true;
  c.sin_a = __builtin_sqrt(sin_a_squared > 0.0 ? sin_a_squared : 0.0);
  for (int i = 0; i < 3; ++i) c.w[i] = p[i] * r_inverse;
  const bool upright = flat < 1e-12 * r;
  const double flat_inverse = 1.0 / flat;
  const double cx = upright ? 1.0 : p[0] * flat_inverse, cy = upright ? 0.0 : p[1] * flat_inverse;
  c.up[0] = -c.w[2] * cx;
  c.up[1] = -c.w[2] * cy;
  c.up[2] = flat * r_inverse;
  c.side[0] = -cy;
  c.side[1] = cx;
  c.side[2] = 0.0;
  c.cos_b = (r - l1 * c.cos_a) * to_l2;
  c.sin_b = l1 * c.sin_a * to_l2;
  c.cos_4 = c.cos_a * c.cos_b - c.sin_a * c.sin_b;
  c.sin_4 = c.sin_a * c.cos_b + c.cos_a * c.sin_b;
  return c;
}

/// Of the eight solutions the one from which the others come by half turns; theta_4 is the circle's.
struct SrsAngles {
  ZyzAngles shoulder, wrist;
};
struct SrsArm {
  ThreeAngles shoulder, wrist;
};

/// For the swivel angles of these cosines and sines, one a lane.
inline SrsArm srsAngles(const SevenArm& arm, const ArmPose& pose, const ElbowCircle& c, const Lanes& cosine,
                        const Lanes& sine, const double* previous) {
  const Lanes3 w{c.w[0], c.w[1], c.w[2]};
  const Lanes3 radial = cosine * Lanes3{c.up[0], c.up[1], c.up[2]} + sine * Lanes3{c.side[0], c.side[1], c.side[2]};
  const Lanes3 z3 = Lanes(c.cos_a) * w + Lanes(c.sin_a) * radial;
  const Lanes3 z5 = Lanes(c.cos_b) * w - Lanes(c.sin_b) * radial;
  const Lanes3 y4 = cross(radial, w), x4 = cross(y4, z5);
  const Lanes3 x7 = column(pose, 0), y7 = column(pose, 1), z7 = column(pose, 2);
  return {shoulder(z3, y4, arm.map, previous),
          zyz({dot(x4, x7), dot(x4, y7), dot(x4, z7), dot(y4, x7), dot(y4, y7), dot(y4, z7), dot(z5, z7)}, arm.map, 4,
              previous)};
}

/// All eight, lanes: shoulder flip x elbow sign; groups: wrist flip.
inline void srsSolutions(const JointMap& map, const SrsAngles& first, const Lanes& theta4, Solutions& solutions) {
  const Mask shoulder_flips = Lanes(0.0, 1.0, 0.0, 1.0) > Lanes(0.5),
             elbow_flips = Lanes(0.0, 0.0, 1.0, 1.0) > Lanes(0.5);
  const Lanes theta1 = select(shoulder_flips, halfTurned(first.shoulder.first), first.shoulder.first);
  const Lanes theta2 = select(shoulder_flips, -first.shoulder.second, first.shoulder.second);
  const Lanes theta3 = select(shoulder_flips ^ elbow_flips, halfTurned(first.shoulder.third), first.shoulder.third);
  // An elbow bent the other way turns the frame before the wrist by half a turn.
  const Lanes flipped = halfTurned(first.wrist.first);
  for (int group = 0; group < 2; ++group) {
    storeJoint(map, 0, group, theta1, solutions);
    storeJoint(map, 1, group, theta2, solutions);
    storeJoint(map, 2, group, theta3, solutions);
    storeJoint(map, 3, group, select(elbow_flips, -theta4, theta4), solutions);
    storeJoint(
        map, 4, group,
        group == 0 ? select(elbow_flips, flipped, first.wrist.first) : select(elbow_flips, first.wrist.first, flipped),
        solutions);
    storeJoint(map, 5, group, group == 0 ? first.wrist.second : -first.wrist.second, solutions);
    storeJoint(map, 6, group, group == 0 ? first.wrist.third : halfTurned(first.wrist.third), solutions);
  }
  solutions.valid = 0xffu;
}

inline void srs(const SevenArm& arm, const ArmPose& pose, double swivel, const double* previous, Solutions& solutions) {
  const ElbowCircle circle = elbowCircle(arm, pose);
  solutions.valid = 0;
  if (!circle.reached) return;
  Lanes cosine, sine;
  sineCosine(swivel, sine, cosine);
  const SrsArm arm_1 = srsAngles(arm, pose, circle, cosine, sine, previous);
  // All lanes are alike: seven angles are two arc tangents of four.
  const auto four = [](const SineAndCosine& a, const SineAndCosine& b, const SineAndCosine& c, double s, double k) {
    return arcTangent({a.sine[0], b.sine[0], c.sine[0], s}, {a.cosine[0], b.cosine[0], c.cosine[0], k});
  };
  const ThreeAngles &shoulder = arm_1.shoulder, &wrist = arm_1.wrist;
  const Lanes upper = four(shoulder.first, shoulder.second, shoulder.third, circle.sin_4, circle.cos_4);
  const Lanes lower = four(wrist.first, wrist.second, wrist.third, 0.0, 1.0);
  srsSolutions(arm.map, {{upper[0], upper[1], upper[2]}, {lower[0], lower[1], lower[2]}}, upper[3], solutions);
}

// Four swivels at a time, turned on from one four to the next.
inline void srsRing(const SevenArm& arm, const ArmPose& pose, double first_swivel, const double* previous,
                    SwivelRing& ring) {
  const ElbowCircle circle = elbowCircle(arm, pose);
  ring.reached = circle.reached;
  if (!circle.reached) return;
  constexpr double kStep = 2.0 * kLanePi / kRingSize;
  Lanes cosine, sine;
  sineCosine(Lanes(first_swivel) + Lanes(0.0, kStep, 2.0 * kStep, 3.0 * kStep), sine, cosine);
  const double turn_cosine = __builtin_cos(4.0 * kStep), turn_sine = __builtin_sin(4.0 * kStep);
  const Lanes theta4 = arcTangent(Lanes(circle.sin_4), Lanes(circle.cos_4));
  for (int k = 0; k < kRingSize; k += 4) {
    const SrsArm at = srsAngles(arm, pose, circle, cosine, sine, previous);
    const SrsAngles angles{at.shoulder.angles(), at.wrist.angles()};
    const Lanes thetas[] = {angles.shoulder.first, angles.shoulder.second, angles.shoulder.third, theta4,
                            angles.wrist.first,    angles.wrist.second,    angles.wrist.third};
    for (int joint = 0; joint < 7; ++joint) store(ring.theta[joint] + k, thetas[joint]);
    const Lanes turned = cosine * turn_cosine - sine * turn_sine;
    sine = sine * turn_cosine + cosine * turn_sine;
    cosine = turned;
  }
}

inline void srsOfRing(const SevenArm& arm, const SwivelRing& ring, int index, Solutions& solutions) {
  solutions.valid = 0;
  if (!ring.reached) return;
  const auto theta = [&](int joint) { return Lanes(ring.theta[joint][index]); };
  srsSolutions(arm.map, {{theta(0), theta(1), theta(2)}, {theta(4), theta(5), theta(6)}}, theta(3), solutions);
}

// Lanes: the elbow's bend x the two directions of axis 5; groups: shoulder flip.
inline void panda(const SevenArm& arm, const ArmPose& pose, double q_7, const double* previous, Solutions& solutions) {
  const double theta7 = arm.map.sign[6] * q_7 + arm.map.offset[6];
  Lanes cosine7, sine7;
  sineCosine(theta7, sine7, cosine7);
  const double c7 = cosine7[0], s7 = sine7[0];
  double x6[3], y6[3], w[3];
  for (int i = 0; i < 3; ++i) {  // R06 = R07 Rz(-theta_7)
    x6[i] = c7 * pose.R[3 * i] - s7 * pose.R[3 * i + 1];
    y6[i] = s7 * pose.R[3 * i] + c7 * pose.R[3 * i + 1];
    w[i] = pose.p[i] - arm.a7 * x6[i];
  }
  const double r2 = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  // The triangle of shoulder, axis 4 and wrist, and the wrist seen from the shoulder in frame 4.
  const double L1 = __builtin_sqrt(arm.d3 * arm.d3 + arm.a4 * arm.a4);
  const double L2 = __builtin_sqrt(arm.d5 * arm.d5 + arm.a5 * arm.a5);
  const double cos_g = (L1 * L1 + L2 * L2 - r2) / (2.0 * L1 * L2);
  const double sin_g_squared = (1.0 - cos_g) * (1.0 + cos_g);
  const double sin_w = arm.a5 / L2, cos_w = arm.d5 / L2, sin_s = -arm.a4 / L1, cos_s = -arm.d3 / L1;
  const Lanes sin_g = Lanes(1.0, -1.0, 1.0, -1.0) * Lanes(__builtin_sqrt(sin_g_squared > 0.0 ? sin_g_squared : 0.0));
  const Lanes wx = arm.a5 - L1 * (sin_w * cos_g - cos_w * sin_g), wz = arm.d5 - L1 * (cos_w * cos_g + sin_w * sin_g);
  // theta_4 = g + angle of the shoulder - angle of the wrist.
  const double cos_o = cos_s * cos_w + sin_s * sin_w, sin_o = sin_s * cos_w - cos_s * sin_w;
  const Lanes s4 = sin_g * cos_o + cos_g * sin_o, c4 = cos_g * cos_o - sin_g * sin_o;
  // Axis 5 is square to axis 6 and has the part wz along the wrist's direction.
  const double along = w[0] * y6[0] + w[1] * y6[1] + w[2] * y6[2];
  const double e[3] = {w[0] - along * y6[0], w[1] - along * y6[1], w[2] - along * y6[2]};
  const double rho2 = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  const Lanes cos_f = wz / rho2;  // times e, which has the length rho
  const Lanes sin_f_squared = (Lanes(rho2) - wz * wz) / (rho2 * rho2);
  const Mask reached = sin_f_squared * rho2 >= Lanes(-kStretched);
  const Lanes sin_f = Lanes(1.0, 1.0, -1.0, -1.0) * squareRoot(maximum(sin_f_squared, 0.0));
  const Lanes3 w3{w[0], w[1], w[2]}, axis6{y6[0], y6[1], y6[2]}, e1{e[0], e[1], e[2]};
  const Lanes3 z5 = cos_f * e1 + sin_f * cross(axis6, e1);
  const Lanes3 rest = w3 - wz * z5;
  const Mask usable = absolute(wx) > Lanes(1e-9);  // else axis 5 points at the shoulder and says nothing of axis 4
  const Lanes3 x4 = (Lanes(1.0) / select(usable, wx, Lanes(1.0))) * rest;
  const Lanes3 y4 = cross(z5, x4);
  const Lanes3 z3 = c4 * z5 - s4 * x4;
  const Lanes3 z7 = column(pose, 2);
  const ZyzAngles first = shoulder(z3, y4, arm.map, previous).angles();
  const Lanes theta4 = arcTangent(s4, c4), theta5 = arcTangent(-dot(x4, axis6), dot(y4, axis6));
  const Lanes theta6 = arcTangent(dot(z7, cross(axis6, z5)), dot(z7, z5));
  for (int group = 0; group < 2; ++group) {
    storeJoint(arm.map, 0, group, group == 0 ? first.first : halfTurned(first.first), solutions);
    storeJoint(arm.map, 1, group, group == 0 ? first.second : -first.second, solutions);
    storeJoint(arm.map, 2, group, group == 0 ? first.third : halfTurned(first.third), solutions);
    storeJoint(arm.map, 3, group, theta4, solutions);
    storeJoint(arm.map, 4, group, theta5, solutions);
    storeJoint(arm.map, 5, group, theta6, solutions);
    store(solutions.q[6] + 4 * group, Lanes(q_7));
  }
  const unsigned lanes = sin_g_squared >= -kStretched && rho2 > 0.0 ? bitsOf(reached & usable) : 0u;
  solutions.valid = lanes | lanes << 4;
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
