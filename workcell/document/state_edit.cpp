// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/state_edit.h"

#include <algorithm>

#include "workcell/document/command.h"
#include "workcell/document/command_checks.h"

namespace hapticell::workcell {

Expected<const Entity*> StateEdit::existing(EntityId id) const {
  const Entity* entity = state_.find(id);
  if (!entity)
    return makeError({.found = Text("no entity has the number %1", id), .expected = "an entity of the document"});
  return entity;
}

Expected<const Entity*> StateEdit::movable(EntityId id) const {
  const auto entity = existing(id);
  if (entity && (*entity)->locked) {
    return makeError(
        {.place = quotedName((*entity)->name), .found = "the entity is locked", .fix = "Unlock it first."});
  }
  return entity;
}

EntityId StateEdit::change(EntityId id, const Change& edit) {
  for (auto& entity : state_.entities) {
    if (entity->id != id) continue;
    auto changed = std::make_shared<Entity>(*entity);
    edit(*changed);
    entity = std::move(changed);
  }
  return id;
}

EntityId StateEdit::move(EntityId id, const Change& edit) {
  change(id, edit);
  const Entity& moved = *state_.find(id);
  if (const Entity* carrier = state_.findByName(moved.attachment.to)) {
    const Pose X_LE = carrierPose(*carrier, moved.attachment.link).inverse() * moved.X_WE;
    change(id, [&](Entity& changed) { changed.attachment.X_LE = X_LE; });
  }
  carryAll(id);
  return id;
}

void StateEdit::carryAll(EntityId id) {
  const std::shared_ptr<const Entity> carrier = *std::find_if(state_.entities.begin(), state_.entities.end(),
                                                              [&](const auto& entity) { return entity->id == id; });
  for (const auto& carried : std::vector(state_.entities)) {
    if (carried->attachment.to != carrier->name) continue;
    const Pose X_WE = carrierPose(*carrier, carried->attachment.link) * carried->attachment.X_LE;
    change(carried->id, [&](Entity& changed) { changed.X_WE = X_WE; });
    carryAll(carried->id);
  }
}

EntityId StateEdit::moveFamily(const Entity& entity, const Change& edit) {
  const EntityId id = entity.id;
  const Pose X_OldW = entity.X_WE.inverse();
  const bool assembly = entity.kind() == EntityKind::kAssembly;
  move(id, edit);
  if (!assembly) return id;
  const Pose X_WNew_WOld = state_.find(id)->X_WE * X_OldW;
  for (EntityId below : familyOf(state_, id)) {
    if (below == id) continue;
    change(below, [&](Entity& changed) { changed.X_WE = X_WNew_WOld * changed.X_WE; });
    carryAll(below);
  }
  return id;
}

void StateEdit::releaseAllFrom(const std::string& name) {
  for (const auto& carried : std::vector(state_.entities)) {
    if (carried->attachment.to == name) change(carried->id, [](Entity& changed) { changed.attachment = {}; });
  }
}

void StateEdit::dropFromPairSets(const std::string& name) {
  std::erase_if(state_.pair_sets, [&](PairSet& set) {
    const bool first_emptied = std::erase(set.first, name) > 0 && set.first.empty();
    const bool second_emptied = std::erase(set.second, name) > 0 && set.second.empty();
    return first_emptied || second_emptied;
  });
}

void StateEdit::takeOut(EntityId id, const std::string& into) {
  const std::string name = state_.find(id)->name;
  for (PairSet& set : state_.pair_sets) {
    for (auto* side : {&set.first, &set.second}) {
      const bool there = std::find(side->begin(), side->end(), into) != side->end();
      if (there) std::erase(*side, name);
      std::replace(side->begin(), side->end(), name, into);
    }
  }
  std::erase_if(state_.pair_rules, [&](const PairRule& r) { return r.first == name || r.second == name; });
  releaseAllFrom(name);
  std::erase_if(state_.entities, [&](const auto& other) { return other->id == id; });
}

}  // namespace hapticell::workcell
