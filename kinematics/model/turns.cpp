// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::kinematics {

bool takeNearestTurns(const Chain& chain, const ChainPositions& x_start, ChainPositions& x) {
  bool within = true;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    // rad or m over a limit, as kLimitSlack of choose_lanes.h.
    constexpr double kSlack = 1e-9;
    const double lower = chain.lower()[i] - kSlack, upper = chain.upper()[i] + kSlack;
    if (chain.turns(i)) {
      x[i] += kTurn * std::round((x_start[i] - x[i]) / kTurn);
      const double nearest = x[i];
      if (x[i] > upper) x[i] -= kTurn * std::ceil((x[i] - upper) / kTurn);
      if (x[i] < lower) x[i] += kTurn * std::ceil((lower - x[i]) / kTurn);
      if (x[i] > upper) x[i] = nearest;
    }
    if (x[i] >= lower && x[i] <= upper) {
      x[i] = std::clamp(x[i], chain.lower()[i], chain.upper()[i]);
    } else {
      within = false;
    }
  }
  return within;
}

bool sameButForTurns(const Chain& chain, const ChainPositions& a, const ChainPositions& b, double tolerance) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    double change = a[i] - b[i];
    if (chain.turns(i) && std::abs(change) > std::numbers::pi) change = std::remainder(change, kTurn);
    if (std::abs(change) > tolerance) return false;
  }
  return true;
}

double distanceSquared(const Chain& chain, const ChainPositions& a, const ChainPositions& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chain.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

}  // namespace hapticell::kinematics
