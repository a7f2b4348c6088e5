// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/engine/cell_state.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/holding/motion_mapping.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

/// Makes room for so many rows in a set: the farthest contacts that are left out make it good for a smaller zone.
void makeRoom(BuiltConstraints& built, std::size_t rows);

/// The guides that one stylus feels while it holds their entity. Manipulation thread only.
class FeltGuides {
 public:
  /// `cell` outlives it.
  explicit FeltGuides(const CellState& cell) : cell_(cell) {}

  void set(std::vector<workcell::Guide> guides) { guides_ = std::move(guides); }

  /// The largest dry friction of the guides of `held`, N.
  double friction(const HeldEntity& held) const;
  /// How far (rad) the entity turns while the hand moves by `radius` (m), if a guide couples its rotation to its
  /// position; else 0.
  double turnWithin(double radius, const HeldEntity& held, const MotionMapping& mapping) const;
  /// The nearest pose that the guides allow, so that the shown pose is on them although the rows come from old sets.
  Pose onGuides(const Pose& X_DP, const HeldEntity& held, const MotionMapping& mapping) const;
  /// Adds the guides' rows to a set, with the proxy at X_DP, before distant contacts.
  void addTo(BuiltConstraints& built, HeldEntity& held, const MotionMapping& mapping, const Pose& X_DP) const;

 private:
  std::vector<const workcell::Guide*> binding(const HeldEntity& held) const;
  Pose atRest(const HeldEntity& held) const;
  void slaveSet(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping, const Pose& X_DP) const;

  const CellState& cell_;
  std::vector<workcell::Guide> guides_;
};

}  // namespace hapticell::manipulation
