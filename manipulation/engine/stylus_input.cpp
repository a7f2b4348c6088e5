// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/stylus_input.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

StylusInput::StylusInput(haptic::HapticLink& link, const config::Configuration& configuration) : link_(link) {
  control_.stiffness = configuration.haptic.stiffness;
  control_.damping = configuration.haptic.damping;
}

bool StylusInput::watchLink() {
  const haptic::LinkState now = link_.linkState();
  // Forces that a lost server took away do not come back with the next one: they are asked for again.
  if (isConnected() && now != link_state_) control_.forces_enabled = false;
  const bool anew = now != link_state_ && now == haptic::LinkState::kConnected;
  if (anew) link_.sendControl(control_);
  link_state_ = now;
  return anew;
}

void StylusInput::takeNewest() {
  if (std::optional<haptic::HapticState> newest = link_.latestState()) state_ = *newest;
  // What a server said that is gone is no answer for the next one: its forces are off until it says otherwise.
  if (state_ && !isConnected()) {
    state_->forces_on = false;
    state_->force_ramp = 0.0;
    state_->force_D = dvec3(0.0);
  }
  if (std::optional<haptic::ServerStatistics> newest = link_.latestStatistics()) statistics_ = *newest;
}

StylusInput::Buttons StylusInput::takeButtons() {
  const Buttons buttons{state_->buttons, state_->buttons & ~last_buttons_, last_buttons_ & ~state_->buttons};
  last_buttons_ = state_->buttons;
  return buttons;
}

std::int64_t StylusInput::stateTime(std::int64_t now_ns) const {
  /// ns: beyond it the clocks are not as they were reported. Half: a bad network (0.5 s) counts as wrong clocks; twice:
  /// recordings may be off by 2 s after a clock was set.
  constexpr std::int64_t kOldest = 1'000'000'000;
  if (!statistics_.clock_offset_ms) return now_ns;
  const std::int64_t tick = state_->server_stamp_ns - std::llround(1e6 * *statistics_.clock_offset_ms);
  return now_ns - tick > kOldest ? now_ns : std::min(tick, now_ns);
}

void StylusInput::setForces(bool on) {
  control_.forces_enabled = on;
  link_.sendControl(control_);
}

void StylusInput::setLoad(const haptic::LoadOptions& load) {
  if (load == control_.load) return;
  control_.load = load;
  link_.sendControl(control_);
}

}  // namespace hapticell::manipulation
