// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/heartbeat.h"

namespace hapticell::haptic {

namespace {

// ns. Clocks of two machines drift by some 10 us in a second: an old exchange is worth more than a new one for no
// longer. Half: the ages of sets follow the round trips more; twice: they are off by up to 0.2 ms.
constexpr std::int64_t kTrustedFor = 10'000'000'000;
constexpr std::int64_t kLatestStamp = std::int64_t{1} << 62;  // A century and a half after boot.
// ns: an echo that is older is no answer but garbage; links end after 5 s of silence. Half and twice change nothing
// that a real link does.
constexpr std::int64_t kLongestRoundTrip = 60'000'000'000;

}  // namespace

Heartbeat HeartbeatExchange::next(std::int64_t now) const {
  return {.sent_ns = now, .echo_ns = peer_sent_, .held_ns = peer_sent_ == 0 ? 0 : now - peer_heard_};
}

void HeartbeatExchange::heard(const Heartbeat& beat, std::int64_t now) {
  peer_sent_ = beat.sent_ns;
  peer_heard_ = now;
  // The stamps come from outside: anything may stand there, so differences are taken only of what is near.
  if (beat.echo_ns <= 0 || beat.echo_ns > now || now - beat.echo_ns > kLongestRoundTrip) return;
  if (beat.held_ns < 0 || beat.held_ns > now - beat.echo_ns) return;
  const std::int64_t round_trip = now - beat.echo_ns - beat.held_ns;
  round_trip_ = 1e-9 * static_cast<double>(round_trip);
  if (from_peer_ && round_trip > best_round_trip_ && now - best_heard_ < kTrustedFor) return;
  if (beat.sent_ns < 0 || beat.sent_ns > kLatestStamp) return;
  from_peer_ = now - round_trip / 2 - beat.sent_ns;
  best_round_trip_ = round_trip;
  best_heard_ = now;
}

}  // namespace hapticell::haptic
