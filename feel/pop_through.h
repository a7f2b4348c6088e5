// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "feel/slow_client.h"

namespace hapticell::feel {

/// Random straight sweeps through, beside and over a plate of 1 mm, 0.05 to 1 m/s, with tremor of 10 to 30 Hz.
struct SweepSetup {
  ClientRate rate;
  int sweeps = 1000;
  std::uint64_t seed = 2026;
  bool stalls = false;      ///< The client stalls for 300 ms in the middle of each sweep.
  double zone_share = 1.0;  ///< Of the zone that is good for the fastest sweep at this rate.
  bool classic = false;     ///< The single moving plane instead.
};

struct SweepOutcome {
  int pops = 0;              ///< The displayed stylus went through the plate.
  int blocked = 0;           ///< Ticks in which it was held where nothing is.
  double penetration = 0.0;  ///< m.
};

SweepOutcome sweepThroughPlate(const SweepSetup& setup);

/// True when a chord from a to b enters the plate by one face and leaves by the other, away from its rim.
bool crossesPlate(const dvec3& a, const dvec3& b);

}  // namespace hapticell::feel
