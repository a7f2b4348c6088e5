// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/ways_out.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "collision/queries/freeing_shift.h"

namespace hapticell::manipulation {

namespace {

constexpr double kHairsBreadth = 1e-4;  ///< m: parts that rest in each other by less are not inside of each other.
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
  const std::string inside = model.nameOf(*model.parts()[who.part].part) + " starts inside " +
                             model.nameOf(*state.pairs.obstacleParts()[who.obstacle]);
  if (!shift.found) {
    state.notes.push_back(inside +
                          " and no straight way out was found; it is not held back by it until they are apart");
    return;
  }
  std::array<char, 96> way{};
  const dvec3& n = shift.direction_W;
  std::snprintf(way.data(), way.size(), ", %.1f mm deep: it comes free along (%.2f, %.2f, %.2f)", 1e3 * shift.depth,
                n.x + 0.0, n.y + 0.0, n.z + 0.0);
  state.notes.push_back(inside + way.data() +
                        (shift.by_winding ? " (an open mesh: told by its winding number)" : std::string()));
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
