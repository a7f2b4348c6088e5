// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/omni_firewire/omni_arm.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace hapticell::driver {

namespace {

constexpr double kCount = 2.0 * std::numbers::pi / 15000.0;  // rad.
constexpr double kRest[3]{0.0, 0.23, -0.60};                 // Joints in the inkwell.

/// As the encoders have them, without home.
dvec3 rawJoints(const std::array<int, 3>& e) {
  return {kCount * e[0], -kCount * e[1], kCount * e[2]};
}

}  // namespace

void OmniArm::home(const std::array<int, 3>& encoders) {
  const dvec3 raw = rawJoints(encoders);
  // q1 = raw1 - h1, q2 = raw2 - h2, q3 = raw3 - h3 - q2.
  home_ = {raw.x - kRest[0], raw.y - kRest[1], raw.z - kRest[1] - kRest[2]};
  homed_ = true;
}

dvec3 OmniArm::joints(const std::array<int, 3>& encoders) const {
  const dvec3 raw = rawJoints(encoders);
  const double q2 = raw.y - home_.y;
  // The published q3 = raw3 - h3 - q2 counts from the upper arm; with q2 added again it counts from the vertical.
  return {raw.x - home_.x, q2, raw.z - home_.z};
}

Pose OmniArm::X_DS(const OmniReading& reading) const {
  const dvec3 q = joints(reading.encoders);
  const auto& r = reading.gimbal_ratios;
  const double yaw = 5.48 * r[0] - 2.74, pitch = 2.64 - 5.28 * r[1], roll = 4.76 * r[2] - 2.38;
  const dquat turned = glm::angleAxis(q.x + yaw, dvec3(0, 0, 1)) * glm::angleAxis(pitch, dvec3(1, 0, 0)) *
                       glm::angleAxis(roll, dvec3(0, 1, 0));
  return {arm_.tip(q), glm::normalize(turned)};
}

dvec3 OmniArm::torques(const dvec3& joints, const dvec3& force_D) const {
  return glm::transpose(arm_.jacobian(joints)) * force_D;
}

dvec3 omniCommands(const dvec3& torques, double newton_metres_per_unit) {
  if (!(newton_metres_per_unit > 0.0)) return dvec3(0.0);
  dvec3 commands = torques / newton_metres_per_unit;
  const double most = std::max({std::abs(commands.x), std::abs(commands.y), std::abs(commands.z)});
  if (most > 1.0) commands /= most;
  return commands;
}

}  // namespace hapticell::driver
