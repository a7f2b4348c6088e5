// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/pair_policy.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hapticell::workcell {

namespace {

/// An entity's name and those of the assemblies it stands in: a set that names one of them means it.
using Names = std::vector<std::string>;

/// Looked up without a walk over all entities for each of them.
using ByName = std::unordered_map<std::string_view, const Entity*>;

ByName byName(std::span<const Entity> entities) {
  ByName by_name;
  for (const Entity& entity : entities) by_name.emplace(entity.name, &entity);
  return by_name;
}

Names namesOf(const ByName& by_name, const Entity& entity) {
  Names names{entity.name};
  // No more steps than entities: documents that were read may stand in circles.
  for (std::string_view parent = entity.parent; !parent.empty() && names.size() <= by_name.size() + 1;) {
    if (parent == entity.name) break;
    names.emplace_back(parent);
    const auto above = by_name.find(parent);
    parent = above == by_name.end() ? std::string_view() : std::string_view(above->second->parent);
  }
  return names;
}

bool takesPart(const Entity& entity) {
  if (!entity.checked || entity.kind() == EntityKind::kFrame) return false;
  return entity.kind() != EntityKind::kAssembly || entity.mesh();  // It has no shape: its parts are there.
}

/// The names of an assembly and of all that stands below it; nothing for others. Parents may come behind their
/// children.
std::set<std::string_view> familyNames(std::span<const Entity> entities, const Entity& top) {
  std::set<std::string_view> family;
  if (top.kind() != EntityKind::kAssembly) return family;
  family.insert(top.name);
  std::unordered_map<std::string_view, std::vector<std::string_view>> below;
  for (const Entity& entity : entities) {
    if (!entity.parent.empty()) below[entity.parent].push_back(entity.name);
  }
  std::vector<std::string_view> open{top.name};
  while (!open.empty()) {
    const auto children = below.find(open.back());
    open.pop_back();
    if (children == below.end()) continue;
    for (const std::string_view child : children->second) {
      if (family.insert(child).second) open.push_back(child);
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

/// The moved entity, as the pairs know it.
struct Moved {
  EntityId id;
  Names names;
  OnContact on_contact;
};

std::optional<EffectivePair> pairOf(const Moved& moved, const Entity& other, const ByName& by_name,
                                    std::span<const PairSet> sets, const PairDefaults& defaults) {
  if (sets.empty())
    return EffectivePair{moved.id, other.id, defaults.safety_distance, defaults.near_miss, moved.on_contact};
  const Names other_names = namesOf(by_name, other);
  std::optional<EffectivePair> pair;
  for (const PairSet& set : sets) {
    if (!set.enabled || !joins(set, moved.names, other_names)) continue;
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
  if (part.empty()) return 1;
  return part == side.part ? 2 : 0;
}

}  // namespace

const PairSet* lastSetFor(std::span<const Entity> entities, std::span<const PairSet> sets, EntityId a, EntityId b) {
  const auto find = [&](EntityId id) {
    return std::find_if(entities.begin(), entities.end(), [id](const Entity& e) { return e.id == id; });
  };
  const auto first = find(a), second = find(b);
  if (sets.empty() || first == entities.end() || second == entities.end()) return nullptr;
  const ByName by_name = byName(entities);
  const Names first_names = namesOf(by_name, *first), second_names = namesOf(by_name, *second);
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
    if (at->robot()) {
      const std::vector<int> bodies = kinematics::rigidBodies(*at->robot());
      link = bodies[static_cast<std::size_t>(std::max(0, link))];
      base = bodies.front();
    } else {
      link = 0;
    }
    if (link != base || at->attachment.to.empty()) break;
    const auto carrier =
        std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.name == at->attachment.to; });
    if (carrier == entities.end()) break;
    link = carrier->robot() ? carrier->robot()->findLink(at->attachment.link) : -1;
    at = &*carrier;
  }
  return {at->id, link};
}

std::vector<EffectivePair> effectivePairs(std::span<const Entity> entities, std::span<const PairSet> sets,
                                          EntityId moved, const PairDefaults& defaults,
                                          std::optional<OnContact> on_contact) {
  std::vector<EffectivePair> pairs;
  const auto held = std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id == moved; });
  if (held == entities.end() || !held->checked || held->kind() == EntityKind::kFrame) return pairs;
  const ByName by_name = sets.empty() ? ByName() : byName(entities);
  const Moved held_one{moved, namesOf(by_name, *held), on_contact.value_or(held->contact.on_contact)};
  const std::set<std::string_view> family = familyNames(entities, *held);
  for (const Entity& other : entities) {
    if (other.id == moved || !takesPart(other)) continue;
    if (!family.empty() && family.contains(other.parent)) continue;  // It goes along with the held assembly.
    if (const auto pair = pairOf(held_one, other, by_name, sets, defaults)) pairs.push_back(*pair);
  }
  return pairs;
}

PairFinder::PairFinder(std::span<const Entity> entities, std::span<const PairSet> sets, const PairDefaults& defaults)
    : sets_(sets), defaults_(defaults), by_name_(byName(entities)) {}

std::optional<EffectivePair> PairFinder::pairOf(const Entity& moved, const Entity& other) const {
  if (moved.id == other.id || !moved.checked || moved.kind() == EntityKind::kFrame || !takesPart(other)) return {};
  if (moved.kind() == EntityKind::kAssembly) {
    const Names above = namesOf(by_name_, other);
    if (std::find(above.begin() + 1, above.end(), moved.name) != above.end()) return {};
  }
  const Names names = sets_.empty() ? Names{} : namesOf(by_name_, moved);
  return workcell::pairOf({moved.id, names, moved.contact.on_contact}, other, by_name_, sets_, defaults_);
}

}  // namespace hapticell::workcell
