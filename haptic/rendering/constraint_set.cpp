// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/constraint_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hapticell::haptic {

namespace {

Vector6 multiply(const SymmetricMatrix6& B, const Vector6& xi) {
  Vector6 result{};
  std::size_t k = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    result[i] += B[k++] * xi[i];
    for (std::size_t j = i + 1; j < 6; ++j, ++k) {
      result[i] += B[k] * xi[j];
      result[j] += B[k] * xi[i];
    }
  }
  return result;
}

/// None is greater, or no number. All are looked at, so that several are at once.
template <typename Container>
bool allWithin(const Container& values, double most) {
  std::uint64_t outside = 0;  // As wide as the numbers.
  for (const double v : values) outside |= std::abs(v) <= most ? 0 : 1;
  return outside == 0;
}

bool isBetween(double value, double least, double most) {
  return value >= least && value <= most;
}

bool isWellFormed(const Constraint& c) {
  return allWithin(c.gradient, bound::kSlope) && allWithin(c.curvature, bound::kCurvature) &&
         allWithin(c.trim_gradient, bound::kSlope) &&
         allWithin(std::array{c.velocity_D.x, c.velocity_D.y, c.velocity_D.z}, bound::kSpeed) &&
         allWithin(std::array{c.gap, c.trim_gap}, bound::kLength) && isBetween(c.stiffness, 0.0, bound::kStiffness) &&
         isBetween(c.reach, 0.0, bound::kLength) && isBetween(c.damping, 0.0, bound::kDamping) &&
         isBetween(c.friction, 0.0, bound::kFriction);
}

}  // namespace

double evaluate(const Constraint& constraint, const Vector6& xi) {
  const Vector6 B_xi = multiply(constraint.curvature, xi);
  double value = constraint.gap;
  for (std::size_t i = 0; i < 6; ++i) value += (constraint.gradient[i] + 0.5 * B_xi[i]) * xi[i];
  return value;
}

Vector6 gradientAt(const Constraint& constraint, const Vector6& xi) {
  Vector6 result = multiply(constraint.curvature, xi);
  for (std::size_t i = 0; i < 6; ++i) result[i] += constraint.gradient[i];
  return result;
}

double evaluateWithGradient(const Constraint& constraint, const Vector6& xi, Vector6& gradient) {
  const Vector6 B_xi = multiply(constraint.curvature, xi);
  double value = constraint.gap;
  for (std::size_t i = 0; i < 6; ++i) {
    value += (constraint.gradient[i] + 0.5 * B_xi[i]) * xi[i];
    gradient[i] = constraint.gradient[i] + B_xi[i];
  }
  return value;
}

bool isWellFormed(const ConstraintSet& set) {
  if (set.count > kMaxConstraints || !set.X_DR.isValid()) return false;
  const dvec3& p_DR = set.X_DR.p;
  if (!allWithin(std::array{p_DR.x, p_DR.y, p_DR.z}, bound::kLength)) return false;
  if (!isBetween(set.zone_radius, bound::kLeastZone, bound::kLength)) return false;
  return std::all_of(set.active().begin(), set.active().end(), [](const Constraint& c) { return isWellFormed(c); });
}

}  // namespace hapticell::haptic
