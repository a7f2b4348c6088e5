// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/scene_pairs.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::collision {

ScenePairs::Roles& ScenePairs::rolesOf(PartIndex part) {
  if (roles_.size() <= part) roles_.resize(part + std::size_t{1});
  return roles_[part];
}

void ScenePairs::setSeeks(PartIndex part) {
  if (std::exchange(rolesOf(part).seeks, true)) return;
  seekers_.push_back(part);
}

PairIndex ScenePairs::make(PartIndex moved, PartIndex environment, std::uint32_t tag) {
  const auto index = static_cast<PairIndex>(pairs_.size());
  rolesOf(std::max(moved, environment));
  std::vector<PairIndex>&of_moved = roles_[moved].pairs, &of_environment = roles_[environment].pairs;
  Pair& pair = pairs_.emplace_back();
  pair.moved = moved;
  pair.environment = environment;
  pair.tag = tag;
  pair.at_moved = static_cast<std::uint32_t>(of_moved.size());
  pair.at_environment = static_cast<std::uint32_t>(of_environment.size());
  of_moved.push_back(index);
  of_environment.push_back(index);
  table_.set(moved, environment, index);
  return index;
}

PairIndex ScenePairs::add(PartIndex moved, PartIndex environment, std::uint32_t tag) {
  setSeeks(moved);
  rolesOf(environment).sought = true;
  const PairIndex there = known(moved, environment);
  if (there == kNone) return make(moved, environment, tag);
  pairs_[there].tag = tag;
  return there;
}

void ScenePairs::addSet(std::span<const PartIndex> moved, std::span<const PartIndex> environment, std::uint32_t tag) {
  HAPTICELL_DEMAND(set_tags_.size() < kMostSets);
  const std::uint64_t bit = std::uint64_t{1} << set_tags_.size();
  set_tags_.push_back(tag);
  const bool moved_seek = moved.size() <= environment.size();
  for (const PartIndex part : moved) {
    rolesOf(part).moved_in |= bit;
    if (moved_seek)
      setSeeks(part);
    else
      roles_[part].sought = true;
  }
  for (const PartIndex part : environment) {
    rolesOf(part).environment_in |= bit;
    if (moved_seek)
      roles_[part].sought = true;
    else
      setSeeks(part);
  }
}

PairIndex ScenePairs::find(PartIndex a, PartIndex b) {
  const PairIndex there = known(a, b);
  if (there != kNone || set_tags_.empty() || a == b || std::max(a, b) >= roles_.size()) return there;
  const std::uint64_t as_moved = roles_[a].moved_in & roles_[b].environment_in;
  const std::uint64_t as_environment = roles_[b].moved_in & roles_[a].environment_in;
  if ((as_moved | as_environment) == 0) return kNone;
  // Of several sets the later one counts.
  const bool a_moves = as_moved >= as_environment;
  const auto set = static_cast<std::size_t>(std::bit_width(std::max(as_moved, as_environment)) - 1);
  return a_moves ? make(a, b, set_tags_[set]) : make(b, a, set_tags_[set]);
}

/// Takes the pair at this place out of the part's list; the last one takes the place.
void ScenePairs::unlist(PartIndex part, std::uint32_t at) {
  std::vector<PairIndex>& list = roles_[part].pairs;
  list[at] = list.back();
  list.pop_back();
  if (at == list.size()) return;
  Pair& there = pairs_[list[at]];
  (there.moved == part ? there.at_moved : there.at_environment) = at;
}

void ScenePairs::remove(PairIndex index) {
  unlist(pairs_[index].moved, pairs_[index].at_moved);
  unlist(pairs_[index].environment, pairs_[index].at_environment);
  table_.erase(pairs_[index].moved, pairs_[index].environment);
  if (index + std::size_t{1} < pairs_.size()) {
    Pair& last = pairs_[index] = std::move(pairs_.back());
    roles_[last.moved].pairs[last.at_moved] = index;
    roles_[last.environment].pairs[last.at_environment] = index;
    table_.set(last.moved, last.environment, index);
  }
  pairs_.pop_back();
}

void ScenePairs::removePart(PartIndex part) {
  if (part >= roles_.size()) return;
  while (!roles_[part].pairs.empty()) remove(roles_[part].pairs.back());
  if (roles_[part].seeks) std::erase(seekers_, part);
  roles_[part] = {};
}

void ScenePairs::forgetDistances(PartIndex part) {
  if (part >= roles_.size()) return;
  for (const PairIndex pair : roles_[part].pairs) {
    pairs_[pair].apart_until = pairs_[pair].near_until = -std::numeric_limits<double>::infinity();
  }
}

void ScenePairs::clear() {
  pairs_.clear();
  table_.clear();
  roles_.clear();
  seekers_.clear();
  set_tags_.clear();
}

}  // namespace hapticell::collision
