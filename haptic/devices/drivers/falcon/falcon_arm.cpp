// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/falcon/falcon_arm.h"

#include <array>
#include <cmath>

namespace hapticell::driver {

namespace {

constexpr double kArm = 0.060;           // Stamper's a: from the motor to the parallelogram,
constexpr double kForearm = 0.1025;      // b: its length,
constexpr double kGrip = 0.01443;        // c: radius of the grip's plate,
constexpr double kHinges = 0.0225;       // d + e: its hinges.
constexpr double kGripAside = -0.025;    // f: of the grip's joint beside the leg's plane.
constexpr double kBase = 0.040;          // r: from the middle to a motor,
constexpr double kBaseAside = -0.02309;  // s: and beside the leg's plane.
constexpr std::array<double, 3> kLegs{105.0 * kDegree, -15.0 * kDegree, -135.0 * kDegree};
constexpr double kZeroAngle = 35.0 * kDegree;
constexpr double kCount = 0.036435 * kDegree;  // 4 x 320 slots a turn, geared 14.25 to 110.

/// One leg's closure at a place of the grip: (u + c - a cos t)^2 + (w - a sin t)^2 = L(v)^2.
struct Leg {
  dvec3 u, v;          // The leg's axes in F; w is F's z.
  double pu, pv, pw;   // Of the grip's plate: pu with c.
  double side, reach;  // Cosine of the parallelogram's angle aside; L.
  double angle;        // t.
};

std::optional<Leg> solveLeg(const dvec3& p, std::size_t i) {
  Leg leg{};
  leg.u = {std::cos(kLegs[i]), std::sin(kLegs[i]), 0.0};
  leg.v = {-std::sin(kLegs[i]), std::cos(kLegs[i]), 0.0};
  leg.pu = glm::dot(p, leg.u) - kBase + kGrip;
  leg.pv = glm::dot(p, leg.v) - kBaseAside;
  leg.pw = p.z;
  leg.side = (leg.pv + kGripAside) / kForearm;
  if (!(std::abs(leg.side) < 1.0)) return std::nullopt;
  leg.reach = kHinges + kForearm * std::sqrt(1.0 - leg.side * leg.side);
  const double distance = std::hypot(leg.pu, leg.pw);
  const double cosine = (distance * distance + kArm * kArm - leg.reach * leg.reach) / (2.0 * kArm * distance);
  if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
  leg.angle = std::atan2(leg.pw, leg.pu) - std::acos(cosine);  // The elbow outwards.
  return leg;
}

/// dangle/dp of one leg, from the closure's total differential; nothing at its singularity.
std::optional<dvec3> gradient(const Leg& leg) {
  const double U = leg.pu - kArm * std::cos(leg.angle);
  const double W = leg.pw - kArm * std::sin(leg.angle);
  const double by_angle = kArm * (U * std::sin(leg.angle) - W * std::cos(leg.angle));
  const double sine = std::sqrt(1.0 - leg.side * leg.side);
  if (std::abs(by_angle) < 1e-9 || sine < 1e-9) return std::nullopt;
  const double by_v = leg.reach * leg.side / sine;  // -L dL/dv.
  return -(U * leg.u + by_v * leg.v + dvec3(0.0, 0.0, W)) / by_angle;
}

}  // namespace

std::optional<dvec3> FalconArm::angles(const dvec3& p_F) {
  dvec3 result(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto leg = solveLeg(p_F, i);
    if (!leg) return std::nullopt;
    result[static_cast<int>(i)] = leg->angle;
  }
  return result;
}

std::optional<dmat3> FalconArm::jacobian(const dvec3& p_F) {
  dmat3 rows(0.0);  // Column i holds motor i's gradient.
  for (std::size_t i = 0; i < 3; ++i) {
    const auto leg = solveLeg(p_F, i);
    const auto row = leg ? gradient(*leg) : std::nullopt;
    if (!row) return std::nullopt;
    rows[static_cast<int>(i)] = *row;
  }
  if (!(std::abs(glm::determinant(rows)) > 1e-3)) return std::nullopt;
  return glm::inverse(glm::transpose(rows));
}

std::optional<dvec3> FalconArm::position(const dvec3& wanted, const dvec3& start) {
  dvec3 p = start;
  for (int i = 0; i < 30; ++i) {
    const auto now = angles(p);
    const auto J = now ? jacobian(p) : std::nullopt;
    if (!J) return std::nullopt;
    dvec3 step = *J * (wanted - *now);
    const double length = glm::length(step);
    if (length > 0.02) step *= 0.02 / length;  // Never out of reach at one bound.
    p += step;
    if (length < 1e-9) return p;
  }
  return std::nullopt;
}

double FalconArm::angleOf(int count) {
  return kZeroAngle + kCount * count;
}

double FalconArm::countOf(double angle) {
  return (angle - kZeroAngle) / kCount;
}

dvec3 falconToDevice(const dvec3& p_F) {
  const dvec3 p = p_F - FalconArm::middle();
  return {p.x, -p.z, p.y};
}

dvec3 deviceToFalcon(const dvec3& v_D) {
  return {v_D.x, v_D.z, -v_D.y};
}

}  // namespace hapticell::driver
