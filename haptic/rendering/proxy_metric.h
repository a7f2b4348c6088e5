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

/// A motion in the metric (six metres), its velocity (six m/s), or the corresponding force (six newtons: a torque is
/// kRotationLever times the angular part, so that force . motion is work).
struct MetricVector {
  dvec3 linear{0.0};
  dvec3 angular{0.0};

  MetricVector& operator+=(const MetricVector& other) {
    linear += other.linear;
    angular += other.angular;
    return *this;
  }
  MetricVector& operator-=(const MetricVector& other) {
    linear -= other.linear;
    angular -= other.angular;
    return *this;
  }
  MetricVector& operator*=(double factor) {
    linear *= factor;
    angular *= factor;
    return *this;
  }
  bool operator==(const MetricVector& other) const { return linear == other.linear && angular == other.angular; }
};

inline MetricVector operator+(MetricVector a, const MetricVector& b) {
  return a += b;
}
inline MetricVector operator-(MetricVector a, const MetricVector& b) {
  return a -= b;
}
inline MetricVector operator*(double factor, MetricVector v) {
  return v *= factor;
}
inline double dot(const MetricVector& a, const MetricVector& b) {
  return glm::dot(a.linear, b.linear) + glm::dot(a.angular, b.angular);
}
inline double length(const MetricVector& v) {
  return std::sqrt(dot(v, v));
}
inline MetricVector limited(const MetricVector& v, double limit) {
  const double size = length(v);
  return size > limit ? (limit / size) * v : v;
}

inline MetricVector metricVector(const Vector6& v) {
  return {linearPart(v), angularPart(v)};
}
inline Vector6 asVector6(const MetricVector& v) {
  return joined(v.linear, v.angular);
}

inline double lengthOf(const Vector6& v) {
  double sum = 0.0;
  for (const double number : v) sum += number * number;
  return std::sqrt(sum);
}

/// The motion from X_DA to X_DB in the metric.
inline Vector6 metricDifference(const Pose& X_DB, const Pose& X_DA) {
  const Twist motion = difference(X_DB, X_DA);
  return joined(motion.linear, kRotationLever * motion.angular);
}

/// The inverse of metricDifference(): the pose that `d` leads to.
inline Pose displacedInMetric(const Pose& X_DP, const Vector6& d) {
  return displaced(X_DP, {linearPart(d), angularPart(d) / kRotationLever});
}

}  // namespace hapticell::haptic
