// SPDX-License-Identifier: Apache-2.0
#include "workcell/pair_policy.h"

#include <algorithm>
#include <optional>

namespace hapticell::workcell {

namespace {

bool names(const std::vector<std::string>& side, const std::string& name) {
  return side.empty() || std::find(side.begin(), side.end(), name) != side.end();
}

bool joins(const PairSet& set, const Entity& a, const Entity& b) {
  return (names(set.first, a.name) && names(set.second, b.name)) ||
         (names(set.first, b.name) && names(set.second, a.name));
}

std::optional<EffectivePair> pairOf(const Entity& moved, const Entity& other, std::span<const PairSet> sets) {
  std::optional<EffectivePair> pair;
  for (const PairSet& set : sets) {
    if (!set.enabled || !joins(set, moved, other)) continue;
    if (!pair) pair = EffectivePair{moved.id, other.id, 0.0, 0.0, moved.on_contact};
    pair->safety_distance = std::max(pair->safety_distance, set.safety_distance);
    pair->near_miss = std::max(pair->near_miss, set.near_miss);
    if (set.on_contact) pair->on_contact = *set.on_contact;
  }
  return pair;
}

}  // namespace

std::vector<EffectivePair> effectivePairs(std::span<const Entity> entities, std::span<const PairSet> sets,
                                          EntityId moved, const PairDefaults& defaults) {
  std::vector<EffectivePair> pairs;
  const auto held = std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id == moved; });
  if (held == entities.end() || !held->checked) return pairs;
  for (const Entity& other : entities) {
    if (other.id == moved || !other.checked) continue;
    if (sets.empty()) {
      pairs.push_back({moved, other.id, defaults.safety_distance, defaults.near_miss, held->on_contact});
    } else if (const auto pair = pairOf(*held, other, sets)) {
      pairs.push_back(*pair);
    }
  }
  return pairs;
}

}  // namespace hapticell::workcell
