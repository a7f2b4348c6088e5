// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "haptic/protocol/messages.h"

namespace hapticell::haptic {

/// One side of the heart-beat exchange: makes the next heart-beat and computes the round trip and the clock offset from
/// those received. The calculation is that of NTP (RFC 5905, section 8), with the exchange of the shortest round trip.
class HeartbeatExchange {
 public:
  /// The heart-beat to send at `now` (own steady clock, ns).
  Heartbeat next(std::int64_t now) const;

  /// Takes the peer's heart-beat, received at `now`. If its stamps are implausible, only its arrival is stored.
  void heard(const Heartbeat& beat, std::int64_t now);

  /// Newest round trip, seconds; 0 before the first.
  double roundTrip() const { return round_trip_; }

  /// Add this to a stamp of the peer's clock to convert it to the own clock; empty before the first round trip.
  std::optional<std::int64_t> fromPeerClock() const { return from_peer_; }

 private:
  std::int64_t peer_sent_ = 0;
  std::int64_t peer_heard_ = 0;
  double round_trip_ = 0.0;
  std::optional<std::int64_t> from_peer_;
  std::int64_t best_round_trip_ = 0;
  std::int64_t best_heard_ = 0;
};

}  // namespace hapticell::haptic
