// SPDX-License-Identifier: Apache-2.0
#include "workcell/pair_policy.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace hapticell::workcell {

namespace {

/// An entity's name and those of the assemblies it stands in: a set that names one of them means it.
using Names = std::vector<std::string>;

Names namesOf(std::span<const Entity> entities, const Entity& entity) {
  Names names{entity.name};
  for (std::string parent = entity.parent; !parent.empty();) {
    if (std::find(names.begin(), names.end(), parent) != names.end()) break;
    names.push_back(parent);
    const auto above =
        std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.name == parent; });
    parent = above == entities.end() ? "" : above->parent;
  }
  return names;
}

/// The names of an assembly and of all that stands below it; nothing for others. Parents may come behind their
/// children.
std::set<std::string_view> familyNames(std::span<const Entity> entities, const Entity& top) {
  std::set<std::string_view> family;
  if (top.kind != EntityKind::kAssembly) return family;
  family.insert(top.name);
  for (std::size_t before = 0; before != family.size();) {
    before = family.size();
    for (const Entity& entity : entities) {
      if (family.contains(entity.parent)) family.insert(entity.name);
    }
  }
  return family;
}

bool means(const std::vector<std::string>& side, const Names& names) {
  return side.empty() || std::find_first_of(side.begin(), side.end(), names.begin(), names.end()) != side.end();
}

bool joins(const PairSet& set, const Names& a, const Names& b) {
  return (means(set.first, a) && means(set.second, b)) || (means(set.first, b) && means(set.second, a));
}

std::optional<EffectivePair> pairOf(const Entity& moved, const Names& moved_names, const Entity& other,
                                    const Names& other_names, std::span<const PairSet> sets) {
  std::optional<EffectivePair> pair;
  for (const PairSet& set : sets) {
    if (!set.enabled || !joins(set, moved_names, other_names)) continue;
    if (!pair) pair = EffectivePair{moved.id, other.id, 0.0, 0.0, moved.on_contact};
    pair->safety_distance = std::max(pair->safety_distance, set.safety_distance);
    pair->near_miss = std::max(pair->near_miss, set.near_miss);
    if (set.on_contact) pair->on_contact = *set.on_contact;
  }
  return pair;
}

/// How closely the rule names the side: 0 not at all, 1 by the entity, 2 by the link.
int closeness(const std::string& entity, const std::string& part, const PairSide& side) {
  if (entity != side.entity) return 0;
  return part.empty() ? 1 : part == side.part ? 2 : 0;
}

}  // namespace

const PairSet* lastSetFor(std::span<const Entity> entities, std::span<const PairSet> sets, EntityId a, EntityId b) {
  const auto find = [&](EntityId id) {
    return std::find_if(entities.begin(), entities.end(), [id](const Entity& e) { return e.id == id; });
  };
  const auto first = find(a), second = find(b);
  if (sets.empty() || first == entities.end() || second == entities.end()) return nullptr;
  const Names first_names = namesOf(entities, *first), second_names = namesOf(entities, *second);
  const PairSet* last = nullptr;
  for (const PairSet& set : sets)
    if (set.enabled && joins(set, first_names, second_names)) last = &set;
  return last;
}

const PairRule* ruleFor(std::span<const PairRule> rules, const PairSide& a, const PairSide& b) {
  const PairRule* best = nullptr;
  int best_close = 0;
  for (const PairRule& rule : rules) {
    for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
      const int first = closeness(rule.first, rule.first_part, *one);
      const int second = closeness(rule.second, rule.second_part, *other);
      if (first == 0 || second == 0 || first + second < best_close) continue;
      best = &rule;
      best_close = first + second;
    }
  }
  return best;
}

bool samePair(const PairRule& a, const PairRule& b) {
  const auto side = [](const std::string& entity, const std::string& part) { return std::pair(entity, part); };
  const auto a1 = side(a.first, a.first_part), a2 = side(a.second, a.second_part);
  const auto b1 = side(b.first, b.first_part), b2 = side(b.second, b.second_part);
  return (a1 == b1 && a2 == b2) || (a1 == b2 && a2 == b1);
}

RigidBody rigidBodyOf(std::span<const Entity> entities, const Entity& entity, int link) {
  const Entity* at = &entity;
  for (std::size_t steps = 0; steps <= entities.size(); ++steps) {
    int base = 0;
    if (at->robot) {
      const std::vector<int> bodies = kinematics::rigidBodies(*at->robot);
      link = bodies[static_cast<std::size_t>(std::max(0, link))];
      base = bodies.front();
    } else {
      link = 0;
    }
    if (link != base || at->attachment.to.empty()) break;
    const auto carrier =
        std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.name == at->attachment.to; });
    if (carrier == entities.end()) break;
    link = carrier->robot ? carrier->robot->findLink(at->attachment.link) : -1;
    at = &*carrier;
  }
  return {at->id, link};
}

std::vector<EffectivePair> effectivePairs(std::span<const Entity> entities, std::span<const PairSet> sets,
                                          EntityId moved, const PairDefaults& defaults) {
  std::vector<EffectivePair> pairs;
  const auto held = std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id == moved; });
  if (held == entities.end() || !held->checked || held->kind == EntityKind::kFrame) return pairs;
  const Names held_names = namesOf(entities, *held);
  const std::set<std::string_view> family = familyNames(entities, *held);
  for (const Entity& other : entities) {
    if (other.id == moved || !other.checked) continue;
    if (other.kind == EntityKind::kFrame) continue;
    if (other.kind == EntityKind::kAssembly && !other.mesh) continue;  // It has no shape: its parts are there.
    if (family.contains(other.parent)) continue;                       // It goes along with the held assembly.
    if (sets.empty()) {
      pairs.push_back({moved, other.id, defaults.safety_distance, defaults.near_miss, held->on_contact});
    } else if (const auto pair = pairOf(*held, held_names, other, namesOf(entities, other), sets)) {
      pairs.push_back(*pair);
    }
  }
  return pairs;
}

}  // namespace hapticell::workcell
