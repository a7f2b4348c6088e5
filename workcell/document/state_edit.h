// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// The operations that commands consist of, on one state, which must outlive this object. Entities are replaced by
/// changed copies, so other holders of the state are not affected.
class StateEdit {
 public:
  /// `new_id` is the id for an added entity.
  StateEdit(DocumentState& state, EntityId new_id) : state_(state), new_id_(new_id) {}

  DocumentState& state() const { return state_; }
  EntityId newId() const { return new_id_; }

  /// Error: the id does not exist.
  Expected<const Entity*> existing(EntityId id) const;

  /// Like existing(); also an error for a locked entity.
  Expected<const Entity*> movable(EntityId id) const;

  using Change = std::function<void(Entity&)>;

  /// Changes properties that do not affect the entity's placement. Returns `id`.
  EntityId change(EntityId id, const Change& change);

  /// Changes an entity's placement: entities attached to it move with it, and it stays attached at its new placement.
  EntityId move(EntityId id, const Change& change);

  /// Like move(); everything below an assembly moves with it.
  EntityId moveFamily(const Entity& entity, const Change& change);

  /// Detaches all entities from the entity of that name; they stay where they are.
  void releaseAllFrom(const std::string& name);

  /// Removes a name from the pair sets. A side without names would mean "everything", so such a set is removed.
  void dropFromPairSets(const std::string& name);

  /// Removes a solid that becomes part of `into`, which replaces it in the pair sets.
  void takeOut(EntityId id, const std::string& into);

 private:
  void carryAll(EntityId id);

  DocumentState& state_;
  EntityId new_id_;
};

}  // namespace hapticell::workcell
