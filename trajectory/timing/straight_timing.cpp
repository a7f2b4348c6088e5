// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/straight_timing.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

StraightTiming::StraightTiming(double way, double speed, double acceleration, double jerk) : way_(way), jerk_(jerk) {
  HAPTICELL_DEMAND(way > 0.0 && speed > 0.0 && acceleration > 0.0 && jerk > 0.0);
  // The acceleration reaches its bound where the speed leaves time for it.
  const auto timeTo = [&](double reached) {
    return reached * jerk_ >= acceleration * acceleration ? reached / acceleration + acceleration / jerk_
                                                          : 2.0 * std::sqrt(reached / jerk_);
  };
  speed_ = speed;
  if (speed_ * timeTo(speed_) > way_) {
    // Half the way gains speed, half loses it: way = speed * timeTo(speed).
    const double ramp = acceleration * acceleration / jerk_;
    speed_ = 0.5 * (std::sqrt(ramp * ramp + 4.0 * acceleration * way_) - ramp);
    if (speed_ < ramp) speed_ = std::cbrt(0.25 * way_ * way_ * jerk_);
  }
  gain_time_ = timeTo(speed_);
  acceleration_ = std::min(acceleration, std::sqrt(speed_ * jerk_));
  jerk_time_ = acceleration_ / jerk_;
  cruise_time_ = std::max(0.0, way_ / speed_ - gain_time_);
}

double StraightTiming::gained(double t) const {
  if (t < jerk_time_) return jerk_ * t * t * t / 6.0;
  const double left = gain_time_ - t;
  if (left < jerk_time_) return 0.5 * speed_ * gain_time_ - speed_ * left + jerk_ * left * left * left / 6.0;
  const double tau = t - jerk_time_;
  const double growing = jerk_time_ > 0.0 ? jerk_ * jerk_time_ * jerk_time_ * jerk_time_ / 6.0 : 0.0;
  const double slow = 0.5 * acceleration_ * jerk_time_;
  return growing + (slow + 0.5 * acceleration_ * tau) * tau;
}

double StraightTiming::at(double t) const {
  if (t <= 0.0) return 0.0;
  if (t >= duration()) return way_;
  if (t < gain_time_) return gained(t);
  const double left = duration() - t;
  if (left < gain_time_) return way_ - gained(left);
  return 0.5 * speed_ * gain_time_ + speed_ * (t - gain_time_);
}

}  // namespace hapticell::trajectory
