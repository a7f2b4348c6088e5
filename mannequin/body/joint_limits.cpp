// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/joint_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {
constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// Direction of a bone from its azimuth (0 forward, 90 deg outward) and elevation (0 hanging), the left side's.
dvec3 direction(double azimuth, double elevation) {
  return {std::sin(elevation) * std::cos(azimuth), std::sin(elevation) * std::sin(azimuth), -std::cos(elevation)};
}

struct Knot {
  double psi, rho;
};

/// The cone of the left side's joint: its middle c, the tangent directions psi is counted from, the boundary.
struct Cone {
  dvec3 c, towards_zero, towards_quarter;
  dmat3 R_middle;              ///< The bone swung from hanging to c.
  std::vector<Knot> knots;     ///< Rising in psi, around the circle; empty for the ellipse.
  double cos_narrowest = 2.0;  ///< Of the least boundary; inside that, psi need not be known.
  double half_flexion = 0.0, half_abduction = 0.0;

  double boundary(double psi, double& slope) const;
};

double Cone::boundary(double psi, double& slope) const {
  if (knots.empty()) {
    const double x = std::cos(psi) / half_flexion, y = std::sin(psi) / half_abduction;
    const double rho = 1.0 / std::sqrt(x * x + y * y);
    const double dx = -std::sin(psi) / half_flexion, dy = std::cos(psi) / half_abduction;
    slope = -rho * rho * rho * (x * dx + y * dy);
    return rho;
  }
  auto after = std::upper_bound(knots.begin(), knots.end(), psi, [](double p, const Knot& k) { return p < k.psi; });
  Knot left = after == knots.begin() ? knots.back() : *(after - 1);
  Knot right = after == knots.end() ? knots.front() : *after;
  if (after == knots.begin()) left.psi -= 2.0 * std::numbers::pi;
  if (after == knots.end()) right.psi += 2.0 * std::numbers::pi;
  slope = (right.rho - left.rho) / (right.psi - left.psi);
  return left.rho + slope * (psi - left.psi);
}

Knot knotAt(const Cone& cone, const dvec3& d) {
  return {std::atan2(glm::dot(d, cone.towards_quarter), glm::dot(d, cone.towards_zero)),
          std::acos(std::clamp(glm::dot(d, cone.c), -1.0, 1.0))};
}

Cone makeShoulder() {
  Cone cone;
  const double azimuth = radians(45.0), elevation = radians(75.0);
  cone.c = direction(azimuth, elevation);
  cone.towards_zero = direction(azimuth, elevation + 0.5 * std::numbers::pi);
  cone.towards_quarter = {-std::sin(azimuth), std::cos(azimuth), 0.0};
  cone.R_middle = leastTurn({0.0, 0.0, -1.0}, cone.c);
  constexpr double kBoundary[][2] = {{0, 130},  {45, 140}, {90, 130}, {112, 110}, {125, 90}, {150, 70},
                                     {180, 55}, {225, 35}, {270, 25}, {305, 50},  {320, 90}, {340, 115}};
  for (const auto& point : kBoundary)
    cone.knots.push_back(knotAt(cone, direction(radians(point[0]), radians(point[1]))));
  std::sort(cone.knots.begin(), cone.knots.end(), [](const Knot& a, const Knot& b) { return a.psi < b.psi; });
  double narrowest = std::numbers::pi;
  for (const Knot& knot : cone.knots) narrowest = std::min(narrowest, knot.rho);
  cone.cos_narrowest = std::cos(narrowest) + 1e-9;
  return cone;
}

Cone makeHip() {
  Cone cone;
  const double flexion = radians(45.0), abduction = radians(7.5);
  cone.c = {std::sin(flexion) * std::cos(abduction), std::sin(abduction), -std::cos(flexion) * std::cos(abduction)};
  cone.towards_zero = glm::normalize(dvec3(std::cos(flexion), 0.0, std::sin(flexion)));
  cone.towards_quarter = glm::cross(cone.towards_zero, -cone.c);
  cone.R_middle = leastTurn({0.0, 0.0, -1.0}, cone.c);
  cone.half_flexion = radians(75.0);
  cone.half_abduction = radians(37.5);
  return cone;
}

const Cone& coneOf(BallJoint joint) {
  static const Cone kShoulderCone = makeShoulder();
  static const Cone kHipCone = makeHip();
  return joint == BallJoint::kShoulder ? kShoulderCone : kHipCone;
}

dmat3 asLeft(Side side, const dmat3& R) {
  return side == Side::kLeft ? R : mirroredRotation(R);
}
/// Axes of turns are mirrored with the opposite sign.
dvec3 axisFromLeft(Side side, const dvec3& axis) {
  return side == Side::kLeft ? axis : axis * dvec3(-1, 1, -1);
}

/// Cosine and sine (times some positive factor) of the twist; internal positive.
struct TwistParts {
  double cosine, sine;
};
TwistParts twistOfLeft(const Cone& cone, const dmat3& R, const dvec3& d) {
  const dvec3 v = glm::cross(cone.c, d);
  const double w = 1.0 / std::max(1e-9, 1.0 + glm::dot(cone.c, d));
  const auto swung = [&](const dvec3& m) {
    const dvec3 turned = glm::cross(v, m);
    return m + turned + w * glm::cross(v, turned);
  };
  const dvec3 x = swung(cone.R_middle[0]), y = swung(cone.R_middle[1]);
  // The bone points along -z of its own frame, so an internal turn is one about -z.
  return {glm::dot(x, R[0]) + glm::dot(y, R[1]), glm::dot(x, R[1]) - glm::dot(y, R[0])};
}

double swing(const Cone& cone, const dvec3& d) {
  return std::atan2(glm::length(glm::cross(cone.c, d)), glm::dot(cone.c, d));
}

BallState stateOfLeft(const Cone& cone, const dmat3& R, double& slope) {
  const dvec3 d = -R[2];
  BallState state;
  state.rho = swing(cone, d);
  state.psi = std::atan2(glm::dot(d, cone.towards_quarter), glm::dot(d, cone.towards_zero));
  state.rho_max = cone.boundary(state.psi, slope);
  const TwistParts twist = twistOfLeft(cone, R, d);
  state.twist = std::atan2(twist.sine, twist.cosine);
  return state;
}

/// True when surely inside: without the arc tangents that the exact answer needs. False may still be inside.
bool surelyInside(const Cone& cone, BallJoint joint, const dmat3& R) {
  const dvec3 d = -R[2];
  const TwistParts twist = twistOfLeft(cone, R, d);
  static const double kShoulderSlope = std::tan(kShoulderTwistUpper) - 1e-9, kHipSlope = 1.0 - 1e-9;
  if (twist.cosine <= 1e-9) return false;
  const double upper = joint == BallJoint::kShoulder ? kShoulderSlope : kHipSlope;
  if (twist.sine > upper * twist.cosine) return false;
  if (joint == BallJoint::kHip && twist.sine < -upper * twist.cosine) return false;
  if (joint == BallJoint::kShoulder) return glm::dot(cone.c, d) > cone.cos_narrowest;
  const double sine = glm::length(glm::cross(cone.c, d));
  if (sine < 1e-6) return glm::dot(cone.c, d) > 0.0;
  const double share = std::atan2(sine, glm::dot(cone.c, d)) / sine;
  const double x = share * glm::dot(d, cone.towards_zero) / cone.half_flexion;
  const double y = share * glm::dot(d, cone.towards_quarter) / cone.half_abduction;
  return x * x + y * y < 1.0 - 1e-9;
}

dmat3 rotationOfLeft(const Cone& cone, double rho, double psi, double twist) {
  const dvec3 along = std::cos(psi) * cone.towards_zero + std::sin(psi) * cone.towards_quarter;
  const dvec3 d = std::cos(rho) * cone.c + std::sin(rho) * along;
  const double s = std::sin(-twist), c = std::cos(twist);
  return leastTurn(cone.c, d) * cone.R_middle * dmat3(dvec3(c, s, 0), dvec3(-s, c, 0), dvec3(0, 0, 1));
}

}  // namespace

bool isCoupled(Dof dof) {
  const std::string_view joint = dofInfo(dof).joint;
  return joint.ends_with("_shoulder") || joint.ends_with("_hip");
}

double twistLower(BallJoint joint) {
  return joint == BallJoint::kShoulder ? kShoulderTwistLower : kHipTwistLower;
}

double twistUpper(BallJoint joint) {
  return joint == BallJoint::kShoulder ? kShoulderTwistUpper : kHipTwistUpper;
}

BallState ballState(BallJoint joint, Side side, const dmat3& R_PS) {
  double slope = 0.0;
  return stateOfLeft(coneOf(joint), asLeft(side, R_PS), slope);
}

double ballViolation(BallJoint joint, Side side, const dmat3& R_PS) {
  if (surelyInside(coneOf(joint), joint, asLeft(side, R_PS))) return 0.0;
  const BallState state = ballState(joint, side, R_PS);
  return std::max({0.0, state.excess(), state.twist - twistUpper(joint), twistLower(joint) - state.twist});
}

dmat3 clampBall(BallJoint joint, Side side, const dmat3& R_PS) {
  if (surelyInside(coneOf(joint), joint, asLeft(side, R_PS))) return R_PS;
  const BallState state = ballState(joint, side, R_PS);
  const double twist = std::clamp(state.twist, twistLower(joint), twistUpper(joint));
  if (state.excess() <= 0.0 && twist == state.twist) return R_PS;
  return ballRotation(joint, side, std::min(state.rho, state.rho_max), state.psi, twist);
}

dmat3 ballRotation(BallJoint joint, Side side, double rho, double psi, double twist) {
  return asLeft(side, rotationOfLeft(coneOf(joint), rho, psi, twist));
}

BallAxes ballAxes(BallJoint joint, Side side, const dmat3& R_PS) {
  const Cone& cone = coneOf(joint);
  const dmat3 R = asLeft(side, R_PS);
  double slope = 0.0;
  BallAxes axes;
  axes.state = stateOfLeft(cone, R, slope);
  const dvec3 d = -R[2];
  const double sine = std::max(1e-6, std::sin(axes.state.rho));
  // Tangents at d along which rho and psi grow.
  dvec3 along = cone.c - glm::dot(cone.c, d) * d;
  along = glm::length(along) > 1e-9
              ? -glm::normalize(along)
              : std::cos(axes.state.psi) * cone.towards_zero + std::sin(axes.state.psi) * cone.towards_quarter;
  const dvec3 around = glm::cross(cone.c, d) / sine;
  // Near the middle psi means nothing, and the limit is far.
  const double sideways = axes.state.rho < 0.1 ? 0.0 : slope / sine;
  const dvec3 gradient = along - sideways * around;
  axes.cone_rate = glm::length(gradient);
  const dvec3 n = gradient / axes.cone_rate;
  const auto withoutTwist = [&](const dvec3& axis) {
    const dvec3 moved = glm::cross(axis, d);
    return axis + glm::dot(d, glm::cross(cone.c, moved)) / (1.0 + glm::dot(cone.c, d)) * d;
  };
  axes.cone = axisFromLeft(side, withoutTwist(glm::cross(d, n)));
  axes.free = axisFromLeft(side, withoutTwist(n));
  axes.bone = axisFromLeft(side, d);
  return axes;
}

double girdleElevation(double arm_elevation) {
  return 0.22 * std::max(0.0, arm_elevation - radians(30.0));
}

double girdleProtraction(double forward) {
  return radians(10.0) * forward;
}

}  // namespace hapticell::mannequin
