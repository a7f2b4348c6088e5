// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/pose.h"

#include <algorithm>
#include <cmath>

namespace hapticell {

namespace {

/// m: what is squared on the way is finite then, and beyond any cell (2000 m). Half, twice: no effect.
constexpr double kFarthest = 1e12;

bool finite(double value) {
  return std::isfinite(value);
}

bool isNear(double coordinate) {
  return std::abs(coordinate) <= kFarthest;  // Nor is what is no number.
}

}  // namespace

Pose Pose::inverse() const {
  const dquat q_BA = glm::conjugate(q);
  return {-(q_BA * p), q_BA};
}

bool Pose::isValid() const {
  const bool all_finite =
      isNear(p.x) && isNear(p.y) && isNear(p.z) && finite(q.w) && finite(q.x) && finite(q.y) && finite(q.z);
  return all_finite && std::abs(glm::dot(q, q) - 1.0) < 2e-6;
}

Pose operator*(const Pose& X_AB, const Pose& X_BC) {
  return {X_AB.p + X_AB.q * X_BC.p, glm::normalize(X_AB.q * X_BC.q)};
}

dvec3 operator*(const Pose& X_AB, const dvec3& p_BQ) {
  return X_AB.p + X_AB.q * p_BQ;
}

dvec3 rotationVector(const dquat& q) {
  const double sign = q.w < 0.0 ? -1.0 : 1.0;
  const dvec3 v = sign * dvec3(q.x, q.y, q.z);
  const double sine = glm::length(v);
  const double angle = 2.0 * std::atan2(sine, sign * q.w);
  // Near zero the ratio angle / sin(angle / 2) tends to 2.
  return sine < 1e-12 ? 2.0 * v : v * (angle / sine);
}

dquat quaternionFromRotationVector(const dvec3& rotation_vector) {
  const double angle = glm::length(rotation_vector);
  if (angle < 1e-12) {
    return glm::normalize(dquat(1.0, 0.5 * rotation_vector.x, 0.5 * rotation_vector.y, 0.5 * rotation_vector.z));
  }
  const dvec3 v = rotation_vector * (std::sin(0.5 * angle) / angle);
  return {std::cos(0.5 * angle), v.x, v.y, v.z};
}

Twist difference(const Pose& X_AC, const Pose& X_AB) {
  return {X_AC.p - X_AB.p, rotationVector(X_AC.q * glm::conjugate(X_AB.q))};
}

Pose displaced(const Pose& X_AB, const Twist& motion_A) {
  return {X_AB.p + motion_A.linear, glm::normalize(quaternionFromRotationVector(motion_A.angular) * X_AB.q)};
}

Pose interpolate(const Pose& X_A0, const Pose& X_A1, double s) {
  const Twist whole = difference(X_A1, X_A0);
  return displaced(X_A0, {s * whole.linear, s * whole.angular});
}

}  // namespace hapticell
