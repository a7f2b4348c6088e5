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

/// What one stylus holds of the cell and how, by the user's choices; and what another one holds meanwhile. The
/// manipulation thread's.
class StylusGrip {
 public:
  /// Both outlive it.
  StylusGrip(CellState& cell, ResultLog& log) : cell_(cell), log_(log) {}

  /// From now on contacts are looked for in a thread of their own.
  void searchInThread();

  HeldEntity* held() { return held_.get(); }
  const HeldEntity* held() const { return held_.get(); }
  bool holds(workcell::EntityId id) const { return held_ && held_->id() == id; }
  /// It is held, or goes with what is.
  bool moves(workcell::EntityId id) const;
  /// Where an entity stands as this stylus has it: of what is held, where it was accepted last. It exists (contract).
  EntityConfiguration placement(workcell::EntityId id) const;

  workcell::EntityId chosen() const { return chosen_; }
  /// Forgets the choices that were for the one before.
  void choose(workcell::EntityId entity);
  /// It is gone; the choices for the one that is held stay.
  void dropChosen() { chosen_ = 0; }
  const MovedBy& movedBy() const { return moved_by_; }
  /// These count when something is taken (anew).
  void setMovedBy(const MovedBy& moved_by) { moved_by_ = moved_by; }
  void setOnContact(workcell::OnContact on_contact) { on_contact_ = on_contact; }
  void setForceClass(workcell::ForceClass force_class) { force_class_ = force_class; }
  workcell::ForceClass forceClassOf(const workcell::Entity& entity) const {
    return force_class_.value_or(entity.force_class);
  }

  /// Takes an entity, where nothing is held; what cannot be is told. True where it is held now.
  bool take(workcell::EntityId entity);
  /// Lets go; the cell has it where it stands. Something is held (contract).
  void putDown();
  /// Where what is held stands, as the document is told when it is let go.
  result::Moved whereHeld() const;
  /// Somebody else moves the joints of what is held: while this is set it is taken so that they may.
  bool jointsMove() const { return joints_move_; }
  void setJointsMove(bool move) { joints_move_ = move; }

  /// What may be taken and is nearest to a point, nearer than `reach` (m); 0: nothing.
  workcell::EntityId entityAt(const Pose& X_WTip, double reach) const;

  /// What another stylus holds in the same cell, and how; 0: nothing.
  void setOther(workcell::EntityId held, const MovedBy& moved_by);
  workcell::EntityId otherHeld() const { return other_held_; }
  /// Why an entity may not be taken while the other stylus holds what it holds; empty: it may.
  Text heldElsewhere(workcell::EntityId wanted) const;
  /// Something that another hand moves stands there now, its way was free. True where that is news here.
  bool placeOther(workcell::EntityId id, const EntityConfiguration& at);

 private:
  CellState& cell_;
  ResultLog& log_;
  std::unique_ptr<ContactSearch> search_;  // Outlives what is held.
  std::unique_ptr<HeldEntity> held_;
  workcell::EntityId chosen_ = 0;
  MovedBy moved_by_;
  std::optional<workcell::OnContact> on_contact_;
  std::optional<workcell::ForceClass> force_class_;
  bool joints_move_ = false;
  workcell::EntityId other_held_ = 0;
  MovedBy other_moved_by_;
  Placements told_;  ///< Where others' things stood when what is held here was told last.
};

}  // namespace hapticell::manipulation
