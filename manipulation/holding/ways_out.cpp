// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/ways_out.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "collision/queries/freeing_shift.h"

namespace hapticell::manipulation {

namespace {

// m: parts that rest in each other by less (coarse chords, press fits) are not inside of each other. Half: a message
// for a chord's error; twice: parts led out too late.
constexpr double kHairsBreadth = 1e-4;
// Pairs that are led out at a time, each a plane of the set. Half: deep heaps stay blocked; twice: it may take twice as
// long to hold the part.
constexpr std::size_t kMostWaysOut = 8;

}  // namespace

void WaysOut::find(HeldState& state, std::span<const FreeMotion::PairDistance> near) {
  for (const auto& [pair, found] : near) {
    const MotionPair& who = state.pairs.motionPairs()[pair];
    PairFeel& feel = state.pairs.feel()[pair];
    if (ways_.size() >= kMostWaysOut || !found.colliding || who.other_part >= 0 || !feel.felt) continue;
    const auto& part = state.model.parts()[who.part].part->mesh.collider;
    const Pose& X_WP = state.motion.partPoses()[who.part];
    const Obstacle& obstacle = state.motion.obstacle(who.obstacle);
    collision::ProximityQuery query(part, obstacle.collider);
    const collision::FreeingShift shift = collision::freeingShift(query, X_WP, obstacle.X_WO);
    if (shift.found && shift.depth < kHairsBreadth) continue;
    note(state, pair, shift);
    if (!shift.found) continue;
    WayOut way;
    way.plane.pair = pair;
    way.plane.nhat_W = shift.direction_W;
    way.p_PC = part->center();
    way.reached = glm::dot(shift.direction_W, X_WP * way.p_PC);
    ways_.push_back(way);
    feel.felt = false;
  }
}

void WaysOut::note(HeldState& state, std::uint32_t pair, const collision::FreeingShift& shift) {
  const MotionPair& who = state.pairs.motionPairs()[pair];
  const HeldModel& model = state.model;
  const std::string part = model.nameOf(*model.parts()[who.part].part);
  const std::string obstacle = model.nameOf(*state.pairs.obstacleParts()[who.obstacle]);
  if (!shift.found) {
    state.notes.push_back(
        Text("%1 starts inside %2 and no straight way out was found; it is not held back by it until "
             "they are apart",
             part, obstacle));
    return;
  }
  std::array<char, 96> way{};
  const dvec3& n = shift.direction_W;
  std::snprintf(way.data(), way.size(), "(%.2f, %.2f, %.2f)", n.x + 0.0, n.y + 0.0, n.z + 0.0);
  const Text::Length depth{shift.depth};
  state.notes.push_back(
      shift.by_winding
          ? Text("%1 starts inside %2, %3 deep: it comes free along %4 (an open mesh: judged by its winding number)",
                 part, obstacle, depth, way.data())
          : Text("%1 starts inside %2, %3 deep: it comes free along %4", part, obstacle, depth, way.data()));
}

void WaysOut::update(HeldState& state) {
  planes_.clear();
  for (std::size_t i = 0; i < ways_.size();) {
    WayOut& way = ways_[i];
    const std::uint32_t pair = way.plane.pair;
    if (!state.motion.isSoft(pair)) {
      state.pairs.feel()[pair].felt = state.pairs[pair].feel.felt;
      ways_.erase(ways_.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    way.plane.p_W = state.motion.partPoses()[state.pairs.motionPairs()[pair].part] * way.p_PC;
    const double at = glm::dot(way.plane.nhat_W, way.plane.p_W);
    way.reached = std::max(way.reached, at);
    way.plane.gap = at - way.reached;
    planes_.push_back(way.plane);
    ++i;
  }
}

}  // namespace hapticell::manipulation
