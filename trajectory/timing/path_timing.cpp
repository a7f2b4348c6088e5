// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/path_timing.h"

#include <algorithm>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

PathTiming::PathTiming(std::vector<double> s, std::vector<double> speed) : s_(std::move(s)), speed_(std::move(speed)) {
  HAPTICELL_DEMAND(s_.size() == speed_.size() && s_.size() >= 2);
  t_.reserve(s_.size());
  t_.push_back(0.0);
  integral_.push_back(0.0);
  for (std::size_t i = 1; i < s_.size(); ++i) {
    const double sum = std::max(speed_[i] + speed_[i - 1], 1e-9);
    const double dt = 2.0 * (s_[i] - s_[i - 1]) / sum;
    t_.push_back(t_.back() + dt);
    const double growth = (speed_[i] - speed_[i - 1]) / 6.0;  // acceleration * dt / 6
    integral_.push_back(integral_.back() +
                        static_cast<long double>(dt) * (s_[i - 1] + dt * (0.5 * speed_[i - 1] + growth)));
  }
}

PathTiming PathTiming::averaged(double window) const {
  PathTiming timing = *this;
  timing.window_ = window / stretch_;
  return timing;
}

PathTiming PathTiming::stretched(double factor) const {
  PathTiming timing = *this;
  timing.stretch_ *= factor;
  return timing;
}

PathTiming::State PathTiming::plainAt(double t) const {
  if (t <= 0.0) return {s_.front(), speed_.front(), 0.0};
  if (t >= t_.back()) return {s_.back(), speed_.back(), 0.0};
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  const auto i = static_cast<std::size_t>(after - t_.begin()) - 1;
  const double dt = t_[i + 1] - t_[i];
  const double acceleration = (speed_[i + 1] - speed_[i]) / dt;
  const double tau = t - t_[i];
  return {std::min(s_[i + 1], s_[i] + (speed_[i] + 0.5 * acceleration * tau) * tau), speed_[i] + acceleration * tau,
          acceleration};
}

long double PathTiming::integralTo(double t) const {
  if (t <= 0.0) return static_cast<long double>(t) * s_.front();
  if (t >= t_.back()) return integral_.back() + static_cast<long double>(t - t_.back()) * s_.back();
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  const auto i = static_cast<std::size_t>(after - t_.begin()) - 1;
  const double acceleration = (speed_[i + 1] - speed_[i]) / (t_[i + 1] - t_[i]);
  const long double tau = static_cast<long double>(t) - t_[i];
  return integral_[i] + tau * (s_[i] + tau * (0.5 * speed_[i] + tau * acceleration / 6.0));
}

PathTiming::State PathTiming::at(double t) const {
  t /= stretch_;
  State state = plainAt(t);
  if (window_ > 0.0) {
    const State before = plainAt(t - window_);
    const auto mean = static_cast<double>((integralTo(t) - integralTo(t - window_)) / window_);
    state = {std::clamp(mean, s_.front(), s_.back()), (state.s - before.s) / window_,
             (state.speed - before.speed) / window_};
    if (t <= 0.0) state.s = s_.front();
    if (t >= t_.back() + window_) state.s = s_.back();
  }
  return {state.s, state.speed / stretch_, state.acceleration / (stretch_ * stretch_)};
}

}  // namespace hapticell::trajectory
