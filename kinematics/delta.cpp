// SPDX-License-Identifier: Apache-2.0
#include "kinematics/delta.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace hapticell::kinematics {

DeltaKinematics::DeltaKinematics(const DeltaGeometry& geometry)
    : geometry_(geometry), down_(geometry.upward ? 1.0 : -1.0) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = geometry.first_angle + 2.0 * std::numbers::pi / 3.0 * static_cast<double>(k);
    cosine_[k] = std::cos(angle);
    sine_[k] = std::sin(angle);
  }
}

dvec3 DeltaKinematics::knee(int k, double theta) const {
  const dvec3 level = (geometry_.base_radius + geometry_.upper_arm * std::cos(theta)) * outward(k);
  return {level.x, level.y, down_ * geometry_.upper_arm * std::sin(theta)};
}

dvec3 DeltaKinematics::platformJoint(int k, const dvec3& p_BP) const {
  return p_BP + geometry_.platform_radius * outward(k);
}

bool DeltaKinematics::inverse(const dvec3& p_BP, std::array<double, 3>& outer, std::array<double, 3>& inner) const {
  const double l = geometry_.upper_arm, L = geometry_.lower_arm;
  const double shift = geometry_.platform_radius - geometry_.base_radius;
  const double h = down_ * p_BP.z, squares = glm::dot(p_BP, p_BP) + l * l - L * L;
  bool reached = true;
  for (std::size_t k = 0; k < 3; ++k) {
    // (x, h): from the motor axis to the platform's joint in the arm's plane; x cos + h sin = e.
    const double along = p_BP.x * cosine_[k] + p_BP.y * sine_[k];
    const double x = along + shift;
    const double e = (squares + 2.0 * along * shift + shift * shift) / (2.0 * l);
    const double under = x * x + h * h - e * e;
    const double w = std::sqrt(under);  // NaN where the arm does not reach.
    reached = reached && under >= 0.0;
    outer[k] = std::atan2(h * e - x * w, x * e + h * w);
    inner[k] = std::atan2(h * e + x * w, x * e - h * w);
  }
  return reached;
}

bool DeltaKinematics::inverseAll(const dvec3& p_BP, DeltaBranches& branches) const {
  std::array<double, 3> outer{}, inner{};
  const bool reached = inverse(p_BP, outer, inner);
  for (std::size_t branch = 0; branch < branches.size(); ++branch) {
    for (std::size_t k = 0; k < 3; ++k) branches[branch][k] = (branch >> k & 1u) != 0 ? inner[k] : outer[k];
  }
  return reached;
}

bool DeltaKinematics::forward(const std::array<double, 3>& theta, dvec3& p_BP) const {
  std::array<dvec3, 3> c;
  for (int k = 0; k < 3; ++k) {
    c[static_cast<std::size_t>(k)] =
        knee(k, theta[static_cast<std::size_t>(k)]) - geometry_.platform_radius * outward(k);
  }
  // The centre of the circle through the three centres, and the normal of their plane.
  const dvec3 u = c[1] - c[0], v = c[2] - c[0], n = glm::cross(u, v);
  const double uu = glm::dot(u, u), vv = glm::dot(v, v), nn = glm::dot(n, n);
  if (!(nn > 1e-24)) {
    p_BP = (c[0] + c[1] + c[2]) / 3.0;
    return false;
  }
  const dvec3 to_middle = glm::cross(uu * v - vv * u, n) / (2.0 * nn);
  const double under = geometry_.lower_arm * geometry_.lower_arm - glm::dot(to_middle, to_middle);
  const double side = (n.z > 0.0 ? 1.0 : -1.0) * down_;
  p_BP = c[0] + to_middle + side * std::sqrt(std::max(0.0, under) / nn) * n;
  return under >= 0.0;
}

}  // namespace hapticell::kinematics
