// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/delta.h"

#include <algorithm>
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
  for (std::size_t k = 0; k < 4; ++k) {
    arms_.cosine[k] = cosine_[std::min<std::size_t>(k, 2)];
    arms_.sine[k] = sine_[std::min<std::size_t>(k, 2)];
  }
  arms_.base = geometry.base_radius;
  arms_.upper = geometry.upper_arm;
  arms_.lower = geometry.lower_arm;
  arms_.platform = geometry.platform_radius;
  arms_.down = down_;
}

dvec3 DeltaKinematics::knee(int k, double theta) const {
  const dvec3 level = (geometry_.base_radius + geometry_.upper_arm * std::cos(theta)) * outward(k);
  return {level.x, level.y, down_ * geometry_.upper_arm * std::sin(theta)};
}

dvec3 DeltaKinematics::platformJoint(int k, const dvec3& p_BP) const {
  return p_BP + geometry_.platform_radius * outward(k);
}

bool DeltaKinematics::inverse(const dvec3& p_BP, std::array<double, 3>& outer, std::array<double, 3>& inner) const {
  alignas(32) double out[4], in[4];
  const unsigned reached = kernels_->deltaInverse(arms_, &p_BP.x, out, in);
  for (std::size_t k = 0; k < 3; ++k) {
    outer[k] = out[k];
    inner[k] = in[k];
  }
  return reached == 15U;
}

bool DeltaKinematics::inverseAll(const dvec3& p_BP, DeltaBranches& branches) const {
  std::array<double, 3> outer{}, inner{};
  const bool reached = inverse(p_BP, outer, inner);
  for (std::size_t branch = 0; branch < branches.size(); ++branch) {
    for (std::size_t k = 0; k < 3; ++k) branches[branch][k] = (branch >> k & 1U) != 0 ? inner[k] : outer[k];
  }
  return reached;
}

bool DeltaKinematics::forward(const std::array<double, 3>& theta, dvec3& p_BP) const {
  alignas(32) double sine[4], cosine[4];
  kernels_->deltaAngles(theta.data(), sine, cosine);
  std::array<dvec3, 3> c;  // The knees, moved inwards by the platform's radius.
  for (std::size_t k = 0; k < 3; ++k) {
    const double level = geometry_.base_radius - geometry_.platform_radius + geometry_.upper_arm * cosine[k];
    c[k] = {level * cosine_[k], level * sine_[k], down_ * geometry_.upper_arm * sine[k]};
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
