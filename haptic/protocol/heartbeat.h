// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "haptic/protocol/messages.h"

namespace hapticell::haptic {

/// One side's part of the heart-beats: makes the next one and learns the round trip and the other side's clock from
/// those that come. The reckoning is NTP's (RFC 5905, section 8), from the exchange with the shortest round trip.
class HeartbeatExchange {
 public:
  /// The heart-beat to send at `now` (own steady clock, ns).
  Heartbeat next(std::int64_t now) const;

  /// Takes the peer's heart-beat, heard at `now`. One whose stamps make no sense is only remembered as heard.
  void heard(const Heartbeat& beat, std::int64_t now);

  /// Newest round trip, seconds; 0 before the first.
  double roundTrip() const { return round_trip_; }

  /// What to add to a stamp of the peer's clock to have it in one's own; nothing before the first round trip.
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
