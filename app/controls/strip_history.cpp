// SPDX-License-Identifier: Apache-2.0
#include "app/controls/strip_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hapticell::app {

void StripHistory::add(const manipulation::SceneSnapshot& snapshot) {
  if (!samples_.empty() && snapshot.time_s < samples_.back().time_s - step_s_) samples_.clear();
  const bool known = !snapshot.pairs.empty() && std::isfinite(snapshot.free_gap_m);
  StripSample fresh{snapshot.time_s,
                    known ? snapshot.free_gap_m : std::numeric_limits<double>::quiet_NaN(),
                    snapshot.stylus.force_n,
                    false,
                    false,
                    snapshot.server.rate_hz,
                    snapshot.rate_manipulation_hz};
  for (const auto& pair : snapshot.pairs) {
    fresh.contact = fresh.contact || pair.contact;
    fresh.near_miss = fresh.near_miss || pair.near_miss;
  }
  if (samples_.empty() || snapshot.time_s - samples_.back().time_s >= step_s_) {
    samples_.push_back(fresh);
  } else {
    StripSample& last = samples_.back();
    last.gap_m = std::fmin(last.gap_m, fresh.gap_m);
    last.force_n = std::max(last.force_n, fresh.force_n);
    last.contact = last.contact || fresh.contact;
    last.near_miss = last.near_miss || fresh.near_miss;
    last.haptic_hz = std::min(last.haptic_hz, fresh.haptic_hz);
    last.manipulation_hz = std::min(last.manipulation_hz, fresh.manipulation_hz);
  }
  while (samples_.front().time_s < now() - length_s_) samples_.pop_front();
}

const StripSample* StripHistory::at(double time_s) const {
  const StripSample* best = nullptr;
  for (const StripSample& sample : samples_)
    if (!best || std::abs(sample.time_s - time_s) < std::abs(best->time_s - time_s)) best = &sample;
  return best;
}

double axisTop(double value, double least) {
  const double wanted = std::max(value, least);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (factor * power >= wanted * (1.0 - 1e-12)) return factor * power;
  return 10.0 * power;
}

}  // namespace hapticell::app
