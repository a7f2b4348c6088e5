// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/shapes/pose.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// The nearest points of one pair within its near-miss distance (or the nearest pair of all).
struct PairState {
  workcell::EntityId moved = 0;
  workcell::EntityId other = 0;
  std::string moved_part;  ///< Link name of a robot; empty for a solid.
  std::string other_part;
  double distance = 0.0;  ///< Metres.
  dvec3 p_WA{0.0};        ///< On the moved entity.
  dvec3 p_WB{0.0};
  bool contact = false;  ///< At the safety boundary.
  bool near_miss = false;
  double near_miss_distance = 0.010;  ///< Metres: the distance at which this pair's near miss begins.
};

}  // namespace hapticell::manipulation
