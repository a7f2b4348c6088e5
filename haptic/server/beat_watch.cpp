// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/beat_watch.h"

#include <algorithm>
#include <cmath>

#include "haptic/server/clock.h"

namespace hapticell::haptic {

namespace {

// Beats until a rhythm counts: 0.2 s at 10 ms. Our choice. Half: believed after 0.1 s; twice: a client that dies in its
// first 0.4 s is only missed after 0.6 s.
constexpr int kRhythm = 20;
// s: time constant of the longest gap and round trip. BeatWatch.ALateBeatGivesMoreTimeForAWhile wants it back in 3 s.
// Half: a net that hiccups each second loses force; twice: slow to be strict again.
constexpr double kForgotten = 1.0;
// s: three beats of kQuickHeartbeatPeriod; slower is no quick rhythm. Half: one missed beat drops to the 0.6 s of slow
// ones; twice: limits up to 0.12 s, and no longer zero within 50 ms.
constexpr double kQuickBeat = 0.03;
// Times the longest gap: one beat is missed and half of the next is late. Half: each late beat would cost the force;
// twice: a dead client pushes twice as long where beats are uneven.
constexpr double kOfGaps = 2.0;
// Round trips: a lost packet is noticed and sent again within some. Half: one loss can cost the force; twice: a far
// dead client pushes longer (BeatWatch.AFarMachineHasTheTimeOfItsRoundTrips).
constexpr double kOfRoundTrips = 4.0;

}  // namespace

void BeatWatch::heard(std::int64_t now, double round_trip) noexcept {
  const double gap = kSecondsPerNanosecond * static_cast<double>(now - last_ns_);
  if (beats_ > 0 && gap >= 0.0) {
    const double kept = std::exp(-gap / kForgotten);
    gap_ = std::max(gap, kept * gap_);
    round_trip_ = std::max(std::isfinite(round_trip) ? round_trip : 0.0, kept * round_trip_);
  }
  last_ns_ = now;
  beats_ = std::min(beats_ + 1, kRhythm);
}

double BeatWatch::limit() const noexcept {
  if (beats_ < kRhythm || gap_ > kQuickBeat) return 0.0;
  return std::max({kShortest, kOfGaps * gap_, gap_ + kOfRoundTrips * round_trip_});
}

}  // namespace hapticell::haptic
