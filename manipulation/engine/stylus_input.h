// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/configuration.h"
#include "haptic/transport/haptic_link.h"

namespace hapticell::manipulation {

/// What the haptic server of one stylus told last, and what it is asked for besides constraint sets. The manipulation
/// thread's.
class StylusInput {
 public:
  /// `link` must outlive it.
  StylusInput(haptic::HapticLink& link, const config::Configuration& configuration);

  /// Looks at the connection; true where it is made anew (the server has been told what it is asked for then).
  bool watchLink();
  /// Takes the newest state and statistics.
  void takeNewest();

  /// Buttons by bits, since the last call.
  struct Buttons {
    std::uint32_t down = 0, pressed = 0, let_go = 0;
  };
  /// With a state (contract).
  Buttons takeButtons();

  haptic::HapticLink& link() const { return link_; }
  bool isConnected() const { return link_state_ == haptic::LinkState::kConnected; }
  const std::optional<haptic::HapticState>& state() const { return state_; }
  const haptic::ServerStatistics& statistics() const { return statistics_; }
  /// Forces are on, or asked for.
  bool hasForces() const { return control_.forces_enabled || (state_ && state_->forces_on); }
  /// When the newest state was, ns by this program's clock: the tick's stamp, as far as it can be brought to that
  /// clock. With a state (contract).
  std::int64_t stateTime(std::int64_t now_ns) const;

  void setForces(bool on);
  /// What the hand carries; told where it has changed.
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
