// SPDX-License-Identifier: Apache-2.0
#include "feel/slow_client.h"

#include <algorithm>

namespace hapticell::feel {

namespace {

/// Narrows a set: a group with an entry that stays free within the radius cannot be met there.
void narrow(ConstraintSet& set, double radius) {
  set.zone_radius = radius;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < set.count; ++i) {
    bool free = false;
    for (const Constraint& other : set.active()) {
      free = free || (other.group == set.constraints[i].group && other.gap > radius);
    }
    if (!free) set.constraints[kept++] = set.constraints[i];
  }
  set.count = kept;
}

}  // namespace

ConstraintSet SlowClient::look(const RenderingWay& way, double t) const {
  ConstraintSet set = scene_.setAt(way.lookedAt(), t);
  if (zone_ > 0.0) narrow(set, zone_);
  return way.sent(set);
}

double SlowClient::arrivalOf(double t) {
  double arrival = t + rate_.latency;
  if (rate_.jitter > 0.0 || rate_.loss > 0.0) {
    // 53 bits by hand: the distributions of the library differ between libraries.
    const auto share = [this] { return static_cast<double>(random_() >> 11) * 0x1p-53; };
    arrival += rate_.jitter * share();
    if (share() < rate_.loss) arrival += rate_.retransmit;
    arrival = last_arrival_ = std::max(arrival, last_arrival_);
  }
  return arrival;
}

void SlowClient::step(double t, RenderingWay& way) {
  if (t + 1e-9 >= next_look_) {
    next_look_ += 1.0 / rate_.rate_hz;
    if (t < stall_from_ || t >= stall_until_) {
      on_the_way_.push_back({t, arrivalOf(t), look(way, t)});
      on_the_way_.back().set.sequence = ++sequence_;
    }
  }
  while (!on_the_way_.empty() && on_the_way_.front().arrival <= t + 1e-9) {
    const Sent& sent = on_the_way_.front();
    way.offer(sent.set, t - sent.made);
    if (sent.made >= stall_until_ && back_at_ < 0.0) back_at_ = t;
    on_the_way_.pop_front();
  }
}

}  // namespace hapticell::feel
