// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_boundaries.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

namespace {

double wantedBoundary(const HeldPair& pair) {
  return std::max(HeldState::kSkin, pair.safety_distance);
}

}  // namespace

HeldBoundaries::HeldBoundaries(HeldState& state) : state_(state), gaps_(state.pairs.size()) {
  std::vector<PairFeel>& feel = state_.pairs.feel();
  double widest = HeldState::kSkin;
  for (std::size_t i = 0; i < feel.size(); ++i) {
    feel[i].boundary = wantedBoundary(state_.pairs[i]);
    widest = std::max(widest, feel[i].boundary);
  }
  // Nearer than its boundary already: it must not be thrown out, only get no nearer.
  state_.motion.distances(widest * (1.0 + 1e-9), near_);
  for (const auto& [pair, found] : near_) {
    feel[pair].boundary = std::min(feel[pair].boundary, found.distance);
  }
  if (state_.motion.anySoft()) leadOut(near_);
}

/// What touches or intersects already: the deepest way in is where its boundary is, and what only touches is guarded.
void HeldBoundaries::leadOut(std::span<const FreeMotion::PairDistance> near) {
  ways_out_.find(state_, near);
  std::vector<PairFeel>& feel = state_.pairs.feel();
  FreeMotion& motion = state_.motion;
  MotionMapping here;
  here.anchor(state_.movedFrame(), state_.movedFrame());
  const BuiltConstraints built =
      buildConstraints({*state_.manipulator, state_.accepted, here, state_.movedFrame(), 0.01, 0.01,
                        state_.model.pieces(), state_.pairs.obstacles(), state_.pairs.motionPairs(), feel});
  pairGaps(built, built.set.X_DR, gaps_);
  for (std::uint32_t i = 0; i < feel.size(); ++i) {
    if (motion.isSoft(i) && gaps_[i] < 0.0) feel[i].boundary += gaps_[i];
  }
  for (std::size_t k = 0; k < built.set.count; ++k) {
    const int pair = built.origins[k].pair;
    if (pair < 0 || std::abs(built.set.constraints[k].gap) > FreeMotion::kGuard) continue;
    const haptic::Vector6& a = built.set.constraints[k].gradient;
    motion.guard(static_cast<std::uint32_t>(pair), glm::normalize(dvec3(a[0], a[1], a[2])));
  }
}

void HeldBoundaries::raise() {
  std::vector<PairFeel>& feel = state_.pairs.feel();
  bool any = false;
  double widest = 0.0;
  for (std::size_t i = 0; i < feel.size(); ++i) {
    const double wanted = wantedBoundary(state_.pairs[i]);
    widest = std::max(widest, wanted);
    any = any || feel[i].boundary < wanted;
  }
  if (!any) return;
  state_.motion.distances(widest, near_);
  std::fill(gaps_.begin(), gaps_.end(), widest);
  for (const auto& [pair, found] : near_) gaps_[pair] = found.distance;
  for (std::uint32_t i = 0; i < feel.size(); ++i) {
    if (state_.motion.isSoft(i)) continue;
    feel[i].boundary = std::min(wantedBoundary(state_.pairs[i]), std::max(feel[i].boundary, gaps_[i]));
  }
}

const std::vector<FreeingPlane>& HeldBoundaries::freeingPlanes() {
  ways_out_.update(state_);
  return ways_out_.planes();
}

}  // namespace hapticell::manipulation
