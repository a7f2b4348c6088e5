// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/seven_reach.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hapticell::kinematics {

namespace {

// m, rad and of a direction: ten times what the axes of an exact class may be off (ClassTolerance::exact), far more
// than the search accepts. Half: no effect; twice: a pose that the limits miss by 2e-5 is left to the search.
constexpr double kReserve = 1e-5;
// rad: a piece this narrow that is not excluded ends the proof. Half: one more evaluation for each reachable pose;
// twice: more poses that just miss the limits are left to the search.
constexpr double kNarrowest = 2e-4;
// Pieces looked at in one proof, a bound of its time; chosen, not tuned. Half: poses near the limits may be left to the
// search; twice: such a pose may cost twice as much before the search begins.
constexpr int kMostPieces = 1024;
// Pieces in a row that wait to be looked at: one for each halving of a whole turn down to kNarrowest, and one spare.
constexpr int kMostWaiting = 20;

/// Of a pose's direction in the plane square to axis 7, as it turns with that joint.
struct FlangePart {
  Span x, y;
};

FlangePart flangePart(double along_x, double along_y, const Span& theta) {
  // (c x - s y, s x + c y) is the vector of this length, at this angle further on.
  const double length = std::hypot(along_x, along_y);
  const Span angle = theta + Span(std::atan2(along_y, along_x));
  return {(Span(length) * cosine(angle)).wider(kReserve), (Span(length) * sine(angle)).wider(kReserve)};
}

}  // namespace

SevenReach::SevenReach(const kernels::SevenArm& arm, const kernels::JointBounds& bounds, const kernels::ArmPose& pose,
                       bool srs)
    : arm_(arm),
      bounds_(bounds),
      pose_(pose),
      srs_(srs),
      L1_(std::hypot(arm.d3, arm.a4)),
      L2_(std::hypot(arm.d5, arm.a5)),
      at_shoulder_(std::atan2(-arm.a4, -arm.d3)),
      at_wrist_(std::atan2(arm.a5, arm.d5)) {}

bool SevenReach::provesNone(double from, double to) const {
  std::array<Span, kMostWaiting> waiting{Span(from, to)};
  int count = 1;
  for (int pieces = 0; count > 0; ++pieces) {
    const Span piece = waiting[static_cast<std::size_t>(--count)];
    if (excludes(piece)) continue;
    if (piece.width() < kNarrowest || pieces >= kMostPieces || count + 2 > kMostWaiting) return false;
    const double middle = 0.5 * (piece.low + piece.high);
    waiting[static_cast<std::size_t>(count++)] = {piece.low, middle};
    waiting[static_cast<std::size_t>(count++)] = {middle, piece.high};
  }
  return true;
}

// Whether some full turn of the joint may be within its limits.
bool SevenReach::mayBe(int joint, const Span& theta) const {
  const Span q = (arm_.map.sign[joint] * (theta - Span(arm_.map.offset[joint]))).wider(kReserve);
  const double lower = bounds_.lower[joint], upper = bounds_.upper[joint];
  // The last turn that begins below the upper limit.
  const double turns = std::isfinite(upper) ? std::floor((upper - q.low) / kTurn) : 0.0;
  return !std::isfinite(upper) || !std::isfinite(lower) || q.high + kTurn * turns >= lower;
}

// Either way round: the same directions of axes 1 and 3 by joint 2 to the other side.
bool SevenReach::shoulderMayBe(const Span& theta_1, const Span& theta_2, const Span& theta_3) const {
  const Span half(std::numbers::pi);
  return (mayBe(0, theta_1) && mayBe(1, theta_2) && mayBe(2, theta_3)) ||
         (mayBe(0, theta_1 + half) && mayBe(1, -theta_2) && mayBe(2, theta_3 + half));
}

bool SevenReach::excludesLast(const Span& q_7) const {
  const Span theta_7 = arm_.map.sign[6] * q_7 + Span(arm_.map.offset[6]);
  const double* R = pose_.R;
  const double* p = pose_.p;
  const FlangePart flange =
      flangePart(p[0] * R[0] + p[1] * R[3] + p[2] * R[6], p[0] * R[1] + p[1] * R[4] + p[2] * R[7], theta_7);
  const double ahead = p[0] * R[2] + p[1] * R[5] + p[2] * R[8];
  const Directions wrist{flange.x - Span(arm_.a7), flange.y, Span(ahead).wider(kReserve)};
  // |w|^2 = |p|^2 + a7^2 - 2 a7 p.x6 exactly, the narrowest form.
  const double constant = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + arm_.a7 * arm_.a7;
  const Span r2 = (Span(constant) - Span(2.0 * arm_.a7) * flange.x).wider(kReserve);
  const Span cos_g = (Span(L1_ * L1_ + L2_ * L2_) - r2) * Span(0.5 / (L1_ * L2_));
  if (cos_g.low > 1.0 || cos_g.high < -1.0) return true;
  const Span between = arcCosine(cos_g);
  return excludesElbow(theta_7, wrist, 1.0, between) && excludesElbow(theta_7, wrist, -1.0, between);
}

// `between`: the angle at the elbow between the lines to shoulder and wrist.
bool SevenReach::excludesElbow(const Span& theta_7, const Directions& wrist, double bend, const Span& between) const {
  const Span g = bend * between;
  const Span theta_4 = g + Span(at_shoulder_ - at_wrist_);
  if (!mayBe(3, theta_4)) return true;
  const Span wx = (Span(arm_.a5) + Span(L1_) * sine(g - Span(at_wrist_))).wider(kReserve);
  const Span wz = (Span(arm_.d5) - Span(L1_) * cosine(g - Span(at_wrist_))).wider(kReserve);
  const Span rho2 = squared(wrist.z) + squared(wrist.x);
  const Span wz2 = squared(wz);
  if (wz2.low > rho2.high) return true;
  return excludesWrist(theta_7, wrist, theta_4, wx, wz, 1.0) && excludesWrist(theta_7, wrist, theta_4, wx, wz, -1.0);
}

// All in frame 6: `wrist` and axis 5 by their parts along x6, axis 6 and z7; `side`: of the two directions of axis 5.
bool SevenReach::excludesWrist(const Span& theta_7, const Directions& wrist, const Span& theta_4, const Span& wx,
                               const Span& wz, double side) const {
  const Span rho = squareRoot(squared(wrist.z) + squared(wrist.x));
  if (rho.low < kReserve) return false;
  const Span off = arcCosine(wz / rho);
  const Span axis_5 = angleOf(wrist.x, wrist.z) + side * off;
  if (!mayBe(5, -axis_5)) return true;
  if (wx.has(0.0)) return false;
  const Span s5 = -(wrist.y / wx);
  if (s5.low > 1.0 || s5.high < -1.0) return true;
  const bool ahead = side * wx.low < 0.0;
  const Span theta_5 = ahead ? arcSine(s5) : Span(std::numbers::pi) - arcSine(s5);
  if (!mayBe(4, theta_5)) return true;

  const Span sin_5 = sine(axis_5), cos_5 = cosine(axis_5), sin_4 = sine(theta_4), cos_4 = cosine(theta_4);
  const auto part = [&](int row) {
    const FlangePart in_6 = flangePart(pose_.R[3 * row], pose_.R[3 * row + 1], theta_7);
    const Directions base{in_6.x, in_6.y, Span(pose_.R[3 * row + 2])};
    const Span z5 = sin_5 * base.x + cos_5 * base.z;
    const Span w = wrist.x * base.x + wrist.y * base.y + wrist.z * base.z;
    const Span x4 = (w - wz * z5) / wx;
    // z5 x w, of which axis 4 is the direction.
    const Span normal = -(cos_5 * wrist.y) * base.x + (cos_5 * wrist.x - sin_5 * wrist.z) * base.y +
                        (sin_5 * wrist.y) * base.z;
    return Directions{cos_4 * x4 + sin_4 * z5, normal / wx, (cos_4 * z5 - sin_4 * x4).wider(kReserve)};
  };
  const Directions up = part(2);
  if (up.z.low > 1.0 || up.z.high < -1.0) return true;
  const Span theta_2 = arcCosine(up.z);
  if (!mayBe(1, theta_2) && !mayBe(1, -theta_2)) return true;
  const Span theta_1 = angleOf(part(1).z, part(0).z), theta_3 = angleOf(up.y.wider(kReserve), (-up.x).wider(kReserve));
  return !shoulderMayBe(theta_1, theta_2, theta_3);
}

bool SevenReach::excludesSwivel(const Span& swivel) const {
  const double* p = pose_.p;
  const double flat = std::hypot(p[0], p[1]), r = std::hypot(flat, p[2]);
  if (flat < kReserve) return false;
  const double l1 = arm_.d3, l2 = arm_.d5;
  const Span length = Span(r).wider(kReserve);
  const Span cos_a = (squared(length) + Span(l1 * l1 - l2 * l2)) / (Span(2.0 * l1) * length);
  if (cos_a.low > 1.0 || cos_a.high < -1.0) return true;
  const Span cos_b = (squared(length) + Span(l2 * l2 - l1 * l1)) / (Span(2.0 * l2) * length);
  const Span a = arcCosine(cos_a), b = arcCosine(cos_b), theta_4 = a + b;
  if (!mayBe(3, theta_4) && !mayBe(3, -theta_4)) return true;
  // The elbow's circle: w along the line, "up" in its vertical plane, "side" level.
  const double w[3] = {p[0] / r, p[1] / r, p[2] / r};
  const double up[3] = {-w[2] * p[0] / flat, -w[2] * p[1] / flat, flat / r}, side[3] = {-p[1] / flat, p[0] / flat, 0.0};
  const auto along = [&](const double* line, const Span& by_w, const Span& by_radial) {
    const double on_up = line[0] * up[0] + line[1] * up[1] + line[2] * up[2];
    const double on_side = line[0] * side[0] + line[1] * side[1] + line[2] * side[2];
    const Span radial = Span(std::hypot(on_up, on_side)) * cosine(swivel - Span(std::atan2(on_side, on_up)));
    return (by_w * Span(line[0] * w[0] + line[1] * w[1] + line[2] * w[2]) + by_radial * radial).wider(kReserve);
  };
  const double upright[3] = {0.0, 0.0, 1.0}, tool[3] = {pose_.R[2], pose_.R[5], pose_.R[8]};
  const Span theta_2 = arcCosine(along(upright, cosine(a), sine(a)));
  const Span theta_6 = arcCosine(along(tool, cosine(b), -sine(b)));
  const auto either = [&](int joint, const Span& theta) { return mayBe(joint, theta) || mayBe(joint, -theta); };
  return !either(1, theta_2) || !either(5, theta_6);
}

}  // namespace hapticell::kinematics
