// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "haptic/rendering/constraint_set.h"

/// The proxy's metric: a small motion as six metres, rotation times kRotationLever. Pure functions, no allocation.
namespace hapticell::haptic {

inline dvec3 linearPart(const Vector6& v) {
  return {v[0], v[1], v[2]};
}
inline dvec3 angularPart(const Vector6& v) {
  return {v[3], v[4], v[5]};
}
inline Vector6 joined(const dvec3& linear, const dvec3& angular) {
  return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
}

inline double lengthOf(const Vector6& v) {
  double sum = 0.0;
  for (const double number : v) sum += number * number;
  return std::sqrt(sum);
}

/// The way from X_DA to X_DB in the metric.
inline Vector6 metricDifference(const Pose& X_DB, const Pose& X_DA) {
  const Twist motion = difference(X_DB, X_DA);
  return joined(motion.linear, kRotationLever * motion.angular);
}

/// Undoes metricDifference: the pose that `d` leads to.
inline Pose displacedInMetric(const Pose& X_DP, const Vector6& d) {
  return displaced(X_DP, {linearPart(d), angularPart(d) / kRotationLever});
}

}  // namespace hapticell::haptic
