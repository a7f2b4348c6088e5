// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "haptic/rendering/energy_account.h"

namespace hapticell::haptic {

/// The force limits of a device's motors: their peaks, and less when they are warm.
class MotorLimit {
 public:
  /// N and N m; `turning`: the device also drives rotation.
  void setPeaks(double force, double torque, bool turning);
  /// Limit of warm motors, N. Values that are not positive, or not less than the peak, mean no further limit.
  void setWarmLimit(double newtons);
  /// The largest force in this direction, N in the metric.
  double along(const MetricVector& direction_D) const;

 private:
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  double peak_force_ = 0.0;
  double peak_torque_ = 0.0;
  bool turning_ = false;
  double warm_ = kNoLimit;
};

}  // namespace hapticell::haptic
