// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/configuration.h"
#include "haptic/transport/haptic_link.h"

namespace hapticell::manipulation {

/// The newest data from one stylus's haptic server, and the requests to it apart from constraint sets. Manipulation
/// thread only.
class StylusInput {
 public:
  /// `link` must outlive it.
  StylusInput(haptic::HapticLink& link, const config::Configuration& configuration);

  /// Checks the connection; returns true after a reconnection (the requests have then been sent again).
  bool watchLink();
  /// Takes the newest state and statistics.
  void takeNewest();

  /// Buttons as bits, since the last call.
  struct Buttons {
    std::uint32_t down = 0, pressed = 0, let_go = 0;
  };
  /// Contract: there is a state.
  Buttons takeButtons();

  haptic::HapticLink& link() const { return link_; }
  bool isConnected() const { return link_state_ == haptic::LinkState::kConnected; }
  const std::optional<haptic::HapticState>& state() const { return state_; }
  const haptic::ServerStatistics& statistics() const { return statistics_; }
  /// Whether forces are on or requested.
  bool hasForces() const { return control_.forces_enabled || (state_ && state_->forces_on); }
  /// Time of the newest state, ns by this program's clock: the tick's stamp, converted to that clock if possible.
  /// Contract: there is a state.
  std::int64_t stateTime(std::int64_t now_ns) const;

  void setForces(bool on);
  /// Sets the load on the hand; sent if it has changed.
  void setLoad(const haptic::LoadOptions& load);

 private:
  haptic::HapticLink& link_;
  std::optional<haptic::HapticState> state_;
  haptic::ServerStatistics statistics_;
  haptic::LinkState link_state_ = haptic::LinkState::kDisconnected;
  haptic::HapticControl control_;
  std::uint32_t last_buttons_ = 0;
};

}  // namespace hapticell::manipulation
