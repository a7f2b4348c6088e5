// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// The steps that commands are made of, on one state. It must not outlive the state. Entities are replaced by changed
/// copies, so other holders of the state see nothing of it.
class StateEdit {
 public:
  /// `new_id` is what an added entity is given.
  StateEdit(DocumentState& state, EntityId new_id) : state_(state), new_id_(new_id) {}

  DocumentState& state() const { return state_; }
  EntityId newId() const { return new_id_; }

  /// Refused: an id that is not there.
  Expected<const Entity*> existing(EntityId id) const;

  /// As existing(); a locked entity is refused as well.
  Expected<const Entity*> movable(EntityId id) const;

  using Change = std::function<void(Entity&)>;

  /// Changes properties that do not affect the entity's placement. Gives `id`.
  EntityId change(EntityId id, const Change& change);

  /// Changes an entity's placement: entities attached to it move with it, and it stays attached at its new place.
  EntityId move(EntityId id, const Change& change);

  /// As move(); below an assembly all goes with it.
  EntityId moveFamily(const Entity& entity, const Change& change);

  /// Entities attached to the entity of that name stay where they are.
  void releaseAllFrom(const std::string& name);

  /// Takes a name out of the pair sets. A side that loses its last name would mean "everything": such a set goes.
  void dropFromPairSets(const std::string& name);

  /// Removes a solid that becomes part of `into`, which takes its place in the pair sets.
  void takeOut(EntityId id, const std::string& into);

 private:
  void carryAll(EntityId id);

  DocumentState& state_;
  EntityId new_id_;
};

}  // namespace hapticell::workcell
