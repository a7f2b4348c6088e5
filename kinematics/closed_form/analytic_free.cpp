// SPDX-License-Identifier: Apache-2.0
// What the pose leaves free of an arm (slides in front, a seventh joint), and the search over it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/closed_form/analytic_inverse.h"
#include "kinematics/model/turns.h"

namespace hapticell::kinematics {

namespace {

// Rounds of the pattern search; halved each time from 1/128 of the range, the step ends at 3e-9 rad. Half: ends at 1e-5
// rad, a visible distance from the nearest answer; twice: up to twice the time, below rounding.
constexpr int kRefinements = 24;

// Places of a seventh joint or swivel that are tried where coarser ones found nothing: 0.01 rad apart. Half: the descent
// is asked more often; twice: 70 us more for each pose that no joint positions reach.
constexpr int kFineSamples = 512;
// rad: a fine place is so near the limits that the descent may find a way between two places; over ten times as far as
// these are apart. Half: a narrow way may be lost; twice: more descents for poses that nothing reaches.
constexpr double kNearLimits = 0.15;

// How many places of each free parameter are tried, by how many there are.
int samplesFor(std::size_t count) {
  constexpr int kSamples[] = {1, 64, 16, 8};
  return count < 4 ? kSamples[count] : 4;
}

}  // namespace

AnalyticInverse::Free AnalyticInverse::freeAt(const Pose& X_BT, const ChainPositions& x) const {
  Free free{};
  dvec3 p = X_BT.p;
  for (std::size_t i = 0; i < rails_; ++i) {
    free[i] = x[i];
    p -= x[i] * rail_B_[i];
  }
  if (closed_->redundancy() > 0) free[rails_] = closed_->redundancyAt(X_BT.R(), p, x.data() + rails_);
  return free;
}

void AnalyticInverse::freeRange(std::size_t index, double& lower, double& upper) const {
  const Chain& chain = *numeric_->chain();
  lower = -std::numbers::pi;
  upper = std::numbers::pi;
  const bool last_joint = classification_.robot_class == RobotClass::kPanda;
  if (index >= rails_ && !last_joint) return;  // a swivel angle
  const std::size_t variable = index < rails_ ? index : chain.size() - 1;
  // A rail without limits is tried for ten times the arm either way.
  const double bound = index < rails_ ? 10.0 * chain.scale() : std::numbers::pi;
  lower = std::isfinite(chain.lower()[variable]) ? chain.lower()[variable] : -bound;
  upper = std::isfinite(chain.upper()[variable]) ? chain.upper()[variable] : bound;
}

void AnalyticInverse::consider(const Pose& X_BT, const Free& free, const ChainPositions& x_start, Best& best) const {
  kernels::Solutions solutions;
  const kernels::Choice choice = evaluate(X_BT, free, x_start, false, solutions);
  take(free, solutions, choice, x_start, best);
}

void AnalyticInverse::take(const Free& free, const kernels::Solutions& solutions, const kernels::Choice& choice,
                           const ChainPositions& x_start, Best& best) const {
  best.outside = best.outside || solutions.valid != 0;
  if (choice.nearest < 0) return;
  double distance = choice.distance_squared;
  for (std::size_t i = 0; i < rails_; ++i) distance += (free[i] - x_start[i]) * (free[i] - x_start[i]);
  if (best.any && distance >= best.distance_squared) return;
  best.x = assemble(free, solutions, choice.nearest);
  best.place = free;
  best.any = true;
  best.distance_squared = distance;
}

// All swivels of an S-R-S arm at once.
bool AnalyticInverse::considerRing(const Pose& X_BT, const ChainPositions& x_start, Best& best) const {
  if (freeCount() != 1 || rails_ != 0) return false;
  constexpr double kStep = kTurn / kernels::kRingSize;
  kernels::SwivelRing ring;
  Free place{0.5 * kStep - std::numbers::pi};
  if (!closed_->ring(X_BT.R(), X_BT.p, place[0], x_start.data(), ring)) return false;
  kernels::Solutions solutions;
  for (int k = 0; k < kernels::kRingSize; ++k, place[0] += kStep) {
    closed_->ofRing(ring, k, solutions);
    take(place, solutions, kernels::table().choose(bounds_, x_start.data(), closed_->groups(), solutions), x_start,
         best);
  }
  return true;
}

// A grid over the free parameters, then a search by halves about the best place.
void AnalyticInverse::searchFree(const Pose& X_BT, const ChainPositions& x_start, Best& best) const {
  const std::size_t count = freeCount();
  const int samples = samplesFor(count);
  Free lower{}, upper{}, place = freeAt(X_BT, x_start);
  int total = 1;
  for (std::size_t i = 0; i < count; ++i) {
    freeRange(i, lower[i], upper[i]);
    total *= samples;
  }
  consider(X_BT, place, x_start, best);
  const bool done = considerRing(X_BT, x_start, best);
  for (int index = 0; !done && index < total; ++index) {
    int rest = index;
    for (std::size_t i = 0; i < count; ++i, rest /= samples) {
      place[i] = lower[i] + (upper[i] - lower[i]) * (rest % samples + 0.5) / samples;
    }
    consider(X_BT, place, x_start, best);
  }
  if (!best.any) return;
  double share = 0.5 / samples;
  for (int round = 0; round < kRefinements; ++round) {
    const Free around = best.place;
    for (std::size_t i = 0; i < count; ++i) {
      for (const double direction : {-1.0, 1.0}) {
        place = around;
        place[i] = std::clamp(around[i] + direction * share * (upper[i] - lower[i]), lower[i], upper[i]);
        consider(X_BT, place, x_start, best);
      }
    }
    if (best.place == around) share *= 0.5;
  }
  // Only now on the true arm.
  kernels::Solutions solutions;
  const kernels::Choice choice = evaluate(X_BT, best.place, x_start, true, solutions);
  best.any = choice.nearest >= 0;
  if (best.any) best.x = assemble(best.place, solutions, choice.nearest);
}

// The least that any joint of any solution is beyond its limits at this place, rad or m; infinite: none exists.
double AnalyticInverse::leastExcess(const kernels::Solutions& solutions) const {
  double least = std::numeric_limits<double>::infinity();
  for (int slot = 0; slot < 4 * closed_->groups(); ++slot) {
    if ((solutions.valid >> slot & 1u) == 0) continue;
    double excess = 0.0;
    for (int joint = 0; joint < bounds_.joints; ++joint) {
      const double q = solutions.q[joint][slot];
      excess = std::max({excess, bounds_.lower[joint] - q, q - bounds_.upper[joint]});
    }
    least = std::min(least, excess);
  }
  return least;
}

// Where the limits leave a narrow way only, it passes between the places of solveAll(): it is searched in ever finer
// steps of the last free parameter; where these come near, the descent looks between them. Most poses out of reach are
// proven so before.
void AnalyticInverse::addBetweenSamples(const Pose& X_BT, const ChainPositions& x_start,
                                        const std::vector<double>& q_start, std::vector<Found>& all) const {
  if (rails_ == 0 && closed_->redundancy() == 1 && !classification_.calibrated) {
    double lower, upper;
    freeRange(0, lower, upper);
    if (closed_->provesNone(X_BT.R(), X_BT.p, bounds_, lower, upper)) return;
  }
  Best best;
  searchFree(X_BT, x_start, best);
  double least = best.any ? 0.0 : std::numeric_limits<double>::infinity();
  if (!best.any && rails_ == 0) {
    double lower, upper;
    freeRange(0, lower, upper);
    kernels::Solutions solutions;
    for (int k = 0; k < kFineSamples && !best.any; ++k) {
      const Free place{lower + (upper - lower) * (k + 0.5) / kFineSamples};
      take(place, solutions, evaluate(X_BT, place, x_start, true, solutions), x_start, best);
      least = std::min(least, leastExcess(solutions));
    }
  }
  if (!best.any && (rails_ > 0 || least < kNearLimits)) {
    const InverseSolution solution = numeric_->solveAny(X_BT, q_start);
    if (solution.status != InverseStatus::kSolved) return;
    best.x = pick(solution.q);
    best.any = true;
  }
  if (best.any) all.push_back({best.x, true, distanceSquared(*numeric_->chain(), best.x, x_start)});
}

}  // namespace hapticell::kinematics
