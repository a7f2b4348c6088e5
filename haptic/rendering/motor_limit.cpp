// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/motor_limit.h"

#include <algorithm>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

void MotorLimit::setPeaks(double force, double torque, bool turning) {
  peak_force_ = force;
  peak_torque_ = torque;
  turning_ = turning;
}

void MotorLimit::setWarmLimit(double newtons) {
  warm_ = newtons > 0.0 && newtons < peak_force_ ? newtons : kNoLimit;
}

double MotorLimit::along(const MetricVector& direction_D) const {
  const double force = std::min(warm_, peak_force_);
  if (!turning_) return force;
  const double size = length(direction_D), turn = glm::length(direction_D.angular);
  const double torque = peak_torque_ / kRotationLever * (force / peak_force_);
  return size * std::min(force / std::max(glm::length(direction_D.linear), 1e-12 * size + 1e-300),
                         torque / std::max(turn, 1e-12 * size + 1e-300));
}

}  // namespace hapticell::haptic
