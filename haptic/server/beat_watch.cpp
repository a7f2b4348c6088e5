// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/beat_watch.h"

#include <algorithm>
#include <cmath>

#include "haptic/server/clock.h"

namespace hapticell::haptic {

namespace {

constexpr int kRhythm = 20;            // Beats that make one.
constexpr double kForgotten = 1.0;     // s: time constant of what was longest.
constexpr double kQuickBeat = 0.03;    // s between beats; slower ones are no quick rhythm.
constexpr double kOfGaps = 2.0;        // A beat that is missed and half of the next.
constexpr double kOfRoundTrips = 4.0;  // A lost packet is told and sent again within some of them.

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
