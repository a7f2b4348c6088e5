// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "haptic/rendering/energy_account.h"

namespace hapticell::haptic {

/// What the motors of a device bear: their peaks, and less while they are warm.
class MotorLimit {
 public:
  /// N and N m; `turning`: the device drives the turning too.
  void setPeaks(double force, double torque, bool turning);
  /// N of warm motors. What is no positive number, or not less than the peak, counts as no further limit.
  void setWarmLimit(double newtons);
  /// The largest force, N in the metric, in this direction.
  double along(const MetricVector& direction_D) const;

 private:
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  double peak_force_ = 0.0;
  double peak_torque_ = 0.0;
  bool turning_ = false;
  double warm_ = kNoLimit;
};

}  // namespace hapticell::haptic
