// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/phantom_arm.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::haptic {

namespace {

// Part of each link from the shoulder to the middle of the workspace: 60 % of the whole reach, so that the far corners
// are within it. Our choice. Half: the near side meets the shoulder; twice: out of reach.
constexpr double kMiddle = 0.85;

dvec3 fromArm(const dvec3& v_A) {
  return {v_A.y, -v_A.x, v_A.z};
}
dvec3 toArm(const dvec3& v_D) {
  return {-v_D.y, v_D.x, v_D.z};
}

}  // namespace

PhantomArm::PhantomArm(double upper_arm, double forearm) : upper_arm_(upper_arm), forearm_(forearm) {
  HAPTICELL_DEMAND(upper_arm > 0.0 && forearm > 0.0);
}

dvec3 PhantomArm::shoulder() const {
  return -fromArm({kMiddle * upper_arm_, 0.0, -kMiddle * forearm_});
}

dvec3 PhantomArm::tip(const dvec3& joints) const {
  const double radius = upper_arm_ * std::cos(joints.y) + forearm_ * std::sin(joints.z);
  const double height = upper_arm_ * std::sin(joints.y) - forearm_ * std::cos(joints.z);
  return shoulder() + fromArm({std::cos(joints.x) * radius, std::sin(joints.x) * radius, height});
}

dvec3 PhantomArm::joints(const dvec3& p_D) const {
  const dvec3 p_A = toArm(p_D - shoulder());
  const double radius = std::hypot(p_A.x, p_A.y);
  const double wanted = std::hypot(radius, p_A.z);
  const double nearest = std::abs(upper_arm_ - forearm_) + 1e-6;
  const double distance = std::clamp(wanted, nearest, reach() - 1e-6);
  // Law of cosines: the angle at the shoulder between the upper arm and the line to the tip.
  const double squares = upper_arm_ * upper_arm_ + distance * distance - forearm_ * forearm_;
  const double at_shoulder = std::acos(std::clamp(squares / (2.0 * upper_arm_ * distance), -1.0, 1.0));
  const double elevation = std::atan2(p_A.z, radius);
  const double q2 = elevation + at_shoulder;  // Elbow up.
  const double forward = distance * std::cos(elevation) - upper_arm_ * std::cos(q2);
  const double down = upper_arm_ * std::sin(q2) - distance * std::sin(elevation);
  return {std::atan2(p_A.y, p_A.x), q2, std::atan2(forward, down)};
}

dmat3 PhantomArm::jacobian(const dvec3& joints) const {
  const double c1 = std::cos(joints.x), s1 = std::sin(joints.x);
  const double c2 = std::cos(joints.y), s2 = std::sin(joints.y);
  const double c3 = std::cos(joints.z), s3 = std::sin(joints.z);
  const double radius = upper_arm_ * c2 + forearm_ * s3;
  return {fromArm({-s1 * radius, c1 * radius, 0.0}),
          fromArm({-c1 * upper_arm_ * s2, -s1 * upper_arm_ * s2, upper_arm_ * c2}),
          fromArm({c1 * forearm_ * c3, s1 * forearm_ * c3, forearm_ * s3})};
}

}  // namespace hapticell::haptic
