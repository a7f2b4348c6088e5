// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>

#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/stylus_grip.h"

namespace hapticell::manipulation {

/// The entities of a cell that move by a script (workcell::ScriptedMotion). Manipulation thread only.
class ScriptedEntities {
 public:
  /// State of one scripted motion; it waits if a held entity cannot give way.
  struct OnItsWay {
    double t = 0.0;         ///< Time in its script, s.
    dvec3 velocity_W{0.0};  ///< m/s.
  };

  /// `cell` outlives it.
  explicit ScriptedEntities(CellState& cell) : cell_(cell) {}

  /// Moves them to the cell's time. Entities held by `grips` give way and are not moved by their scripts. `leapt` is
  /// called when one restarts its script. Returns true if a speed differs from that assumed in the sets.
  bool move(std::span<StylusGrip* const> grips, const std::function<void()>& leapt);

  /// All that have moved, by entity.
  const std::map<workcell::EntityId, OnItsWay>& onTheirWay() const { return on_their_way_; }
  /// Their greatest present speed, m/s.
  double fastest() const;
  /// Adds velocities to a set's obstacles, as motions of the stylus: to scripted ones, and to all if the mapping drifts
  /// by `drift_D` (m/s).
  void addVelocities(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping,
                     const dvec3& drift_D) const;

 private:
  bool moveOne(const workcell::Entity& entity, double dt, std::span<StylusGrip* const> grips,
               const std::function<void()>& leapt);

  CellState& cell_;
  std::map<workcell::EntityId, OnItsWay> on_their_way_;
  std::int64_t moved_ns_ = -1;
};

}  // namespace hapticell::manipulation
