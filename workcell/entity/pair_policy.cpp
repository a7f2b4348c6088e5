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
class Tree {
 public:
  explicit Tree(std::span<const Entity> entities) {
    for (const Entity& entity : entities) by_name_.emplace(entity.name, &entity);
  }

  Names namesOf(const Entity& entity) const {
    Names names{entity.name};
    // No more steps than entities: documents that were read may stand in circles.
    for (std::string_view parent = entity.parent; !parent.empty() && names.size() <= by_name_.size() + 1;) {
      if (parent == entity.name) break;
      names.emplace_back(parent);
      const auto above = by_name_.find(parent);
      parent = above == by_name_.end() ? std::string_view() : std::string_view(above->second->parent);
    }
    return names;
  }

 private:
  std::unordered_map<std::string_view, const Entity*> by_name_;
};

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

std::optional<EffectivePair> pairOf(const Entity& moved, const Names& moved_names, const Entity& other,
                                    const Names& other_names, std::span<const PairSet> sets) {
  std::optional<EffectivePair> pair;
  for (const PairSet& set : sets) {
    if (!set.enabled || !joins(set, moved_names, other_names)) continue;
    if (!pair) pair = EffectivePair{moved.id, other.id, 0.0, 0.0, moved.contact.on_contact};
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
  const Tree tree(entities);
  const Names first_names = tree.namesOf(*first), second_names = tree.namesOf(*second);
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
                                          EntityId moved, const PairDefaults& defaults) {
  std::vector<EffectivePair> pairs;
  const auto held = std::find_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.id == moved; });
  if (held == entities.end() || !held->checked || held->kind() == EntityKind::kFrame) return pairs;
  const Tree tree(entities);
  const Names held_names = tree.namesOf(*held);
  const std::set<std::string_view> family = familyNames(entities, *held);
  for (const Entity& other : entities) {
    if (other.id == moved || !other.checked) continue;
    if (other.kind() == EntityKind::kFrame) continue;
    if (other.kind() == EntityKind::kAssembly && !other.mesh()) continue;  // It has no shape: its parts are there.
    if (family.contains(other.parent)) continue;                       // It goes along with the held assembly.
    if (sets.empty()) {
      pairs.push_back({moved, other.id, defaults.safety_distance, defaults.near_miss, held->contact.on_contact});
    } else if (const auto pair = pairOf(*held, held_names, other, tree.namesOf(other), sets)) {
      pairs.push_back(*pair);
    }
  }
  return pairs;
}

}  // namespace hapticell::workcell
