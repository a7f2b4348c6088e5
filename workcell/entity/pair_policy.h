// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// The distances that count where no pair set says otherwise, metres (hapticell.toml: manipulation.safety_distance,
/// near_miss).
struct PairDefaults {
  double safety_distance = 0.001;
  double near_miss = 0.010;
  bool operator==(const PairDefaults&) const = default;
};

/// One entity that is checked against the moved one.
struct EffectivePair {
  EntityId moved = 0;
  EntityId other = 0;
  double safety_distance = 0.0;              ///< Metres; felt as the boundary.
  double near_miss = 0.0;                    ///< Metres; shown and heard.
  OnContact on_contact = OnContact::kSlide;  ///< The set's choice, else the moved entity's.
};

/// What is checked against the entity `moved`, in the order of `entities`. Without pair sets everything is checked
/// against everything, with `defaults`; with sets only what the enabled ones name (either way round; an empty side
/// means everything, an assembly's name everything below it). Where several name a pair, its larger distances and the
/// later set's choice on contact count. Entities that are not `checked` take no part; neither does the moved one
/// against itself (the links of one robot are the manipulation loop's matter). Empty when there is no entity `moved`.
/// `on_contact`: instead of the moved entity's own choice.
std::vector<EffectivePair> effectivePairs(std::span<const Entity> entities, std::span<const PairSet> sets,
                                          EntityId moved, const PairDefaults& defaults = {},
                                          std::optional<OnContact> on_contact = {});

/// The same for two entities at a time, for who knows already which ones matter: a walk over all of them is made once.
/// Entities and sets must outlive it. Any thread.
class PairFinder {
 public:
  PairFinder(std::span<const Entity> entities, std::span<const PairSet> sets, const PairDefaults& defaults = {});
  /// What effectivePairs() of `moved` says of `other`; nothing where it does not name it. Both are of the entities.
  std::optional<EffectivePair> pairOf(const Entity& moved, const Entity& other) const;

 private:
  std::span<const PairSet> sets_;
  PairDefaults defaults_;
  std::unordered_map<std::string_view, const Entity*> by_name_;
};

/// The set whose choices count for these two: the last enabled one that joins them; null where none does.
const PairSet* lastSetFor(std::span<const Entity> entities, std::span<const PairSet> sets, EntityId a, EntityId b);

/// A rigid body of the cell: an entity and the first of the links that are one body with each other (0: a solid, or a
/// robot's base).
struct RigidBody {
  EntityId entity = 0;
  int link = 0;
  bool operator==(const RigidBody&) const = default;
};

/// The body that `link` of the entity (-1: a solid) belongs to. What is attached is one body with what it is attached
/// to, and so on down to an entity that is not attached; parts of one body cannot move against each other and are never
/// checked against each other. An attachment to an entity that does not exist counts as none.
RigidBody rigidBodyOf(std::span<const Entity> entities, const Entity& entity, int link);

/// One side of a pair: an entity and its link (empty: a solid, or a robot as a whole), by name.
struct PairSide {
  std::string_view entity, part;
};

/// The rule that counts for these two, either way round: one that names both links before one that names fewer, the
/// later before the earlier. Null where none does.
const PairRule* ruleFor(std::span<const PairRule> rules, const PairSide& a, const PairSide& b);

/// Both rules are about the same two sides.
bool samePair(const PairRule& a, const PairRule& b);

}  // namespace hapticell::workcell
