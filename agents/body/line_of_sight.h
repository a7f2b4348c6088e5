// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "agents/body/clearances.h"

namespace hapticell::agents {

/// Straight lines through the obstacles of a cell, for eyes and for a hand that looks for its way. Borrows them.
class LineOfSight {
 public:
  /// `ignored` is no obstacle: what is looked at. 0: nothing is ignored.
  explicit LineOfSight(std::span<const Clearances::Obstacle> obstacles, workcell::EntityId ignored = 0)
      : obstacles_(obstacles), ignored_(ignored) {}

  /// True if nothing is met between the two points (m, world).
  bool isFree(const dvec3& p_WFrom, const dvec3& p_WTo) const;
  /// True if a ball of this radius (m) goes straight from one to the other without meeting anything; looked at every
  /// half radius.
  bool isFreeFor(double radius, const dvec3& p_WFrom, const dvec3& p_WTo) const;
  /// The middle of an entity's parts among the obstacles; empty: it has none.
  std::optional<dvec3> middleOf(workcell::EntityId entity) const;

 private:
  std::span<const Clearances::Obstacle> obstacles_;
  workcell::EntityId ignored_;
};

}  // namespace hapticell::agents
