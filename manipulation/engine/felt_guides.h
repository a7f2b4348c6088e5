// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/engine/cell_state.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/holding/motion_mapping.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

/// The guides that one stylus feels while what they bind is held. The manipulation thread's.
class FeltGuides {
 public:
  /// `cell` outlives it.
  explicit FeltGuides(const CellState& cell) : cell_(cell) {}

  void set(std::vector<workcell::Guide> guides) { guides_ = std::move(guides); }

  /// The largest dry friction of those that bind `held`, N.
  double friction(const HeldEntity& held) const;
  /// How far the entity turns while the hand goes `radius` (m), where a guide turns it by its place; else 0. rad.
  double turnWithin(double radius, const HeldEntity& held, const MotionMapping& mapping) const;
  /// The nearest pose on what the guides fix, so that what is shown is on them though the rows are made of old sets.
  Pose onGuides(const Pose& X_DP, const HeldEntity& held, const MotionMapping& mapping) const;
  /// Adds their rows to a set, with the proxy at X_DP; they go before contacts that are far away.
  void addTo(BuiltConstraints& built, HeldEntity& held, const MotionMapping& mapping, const Pose& X_DP) const;

 private:
  std::vector<const workcell::Guide*> binding(const HeldEntity& held) const;
  Pose atRest(const HeldEntity& held) const;
  void slaveSet(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping, const Pose& X_DP) const;

  const CellState& cell_;
  std::vector<workcell::Guide> guides_;
};

}  // namespace hapticell::manipulation
