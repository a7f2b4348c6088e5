// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "geometry/system/text.h"
#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/result_log.h"
#include "manipulation/holding/contact_search.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

/// What one stylus holds and how, by the user's choices, and what another one holds. Manipulation thread only.
class StylusGrip {
 public:
  /// Both outlive it.
  StylusGrip(CellState& cell, ResultLog& log) : cell_(cell), log_(log) {}

  /// Moves the search for contacts to a separate thread.
  void searchInThread();

  HeldEntity* held() { return held_.get(); }
  const HeldEntity* held() const { return held_.get(); }
  bool holds(workcell::EntityId id) const { return held_ && held_->id() == id; }
  /// Whether the entity is held or moves with the held one.
  bool moves(workcell::EntityId id) const;
  /// An entity's placement for this stylus: for held ones the last accepted one. Contract: it exists.
  EntityConfiguration placement(workcell::EntityId id) const;

  workcell::EntityId chosen() const { return chosen_; }
  /// Chooses an entity; forgets the choices for the previous one.
  void choose(workcell::EntityId entity);
  /// The chosen entity no longer exists; the choices for the held one stay.
  void dropChosen() { chosen_ = 0; }
  const MovedBy& movedBy() const { return moved_by_; }
  /// These take effect when an entity is taken (again).
  void setMovedBy(const MovedBy& moved_by) { moved_by_ = moved_by; }
  void setOnContact(workcell::OnContact on_contact) { on_contact_ = on_contact; }
  void setForceClass(workcell::ForceClass force_class) { force_class_ = force_class; }
  workcell::ForceClass forceClassOf(const workcell::Entity& entity) const {
    return force_class_.value_or(entity.contact.force_class);
  }

  /// Takes an entity if nothing is held; reports if that is impossible. Returns true if it is held now.
  bool take(workcell::EntityId entity);
  /// Releases the entity; the cell keeps its present placement. Contract: something is held.
  void putDown();
  /// The held entity's placement, as reported to the document on release.
  result::Moved whereHeld() const;
  /// Something else moves the held entity's joints: if set, the entity is taken in a way that allows this.
  bool jointsMove() const { return joints_move_; }
  void setJointsMove(bool move) { joints_move_ = move; }

  /// The entity that may be taken and is nearest to a point, within `reach` (m); 0: no entity.
  workcell::EntityId entityAt(const Pose& X_WTip, double reach) const;

  /// Sets what another stylus holds in the same cell, and how; 0: nothing.
  void setOther(workcell::EntityId held, const MovedBy& moved_by);
  workcell::EntityId otherHeld() const { return other_held_; }
  /// Why an entity may not be taken because of what the other stylus holds; empty: it may.
  Text heldElsewhere(workcell::EntityId wanted) const;
  /// An entity moved by another hand has a new placement; its way was free. Returns true if that changes something
  /// here.
  bool placeOther(workcell::EntityId id, const EntityConfiguration& at);

 private:
  CellState& cell_;
  ResultLog& log_;
  std::unique_ptr<ContactSearch> search_;  // Outlives the held entity.
  std::unique_ptr<HeldEntity> held_;
  workcell::EntityId chosen_ = 0;
  MovedBy moved_by_;
  std::optional<workcell::OnContact> on_contact_;
  std::optional<workcell::ForceClass> force_class_;
  bool joints_move_ = false;
  workcell::EntityId other_held_ = 0;
  MovedBy other_moved_by_;
  Placements told_;  ///< Placements of the others' entities when the held one last got them.
};

}  // namespace hapticell::manipulation
