// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>

#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/stylus_grip.h"

namespace hapticell::manipulation {

/// The entities of a cell that go by themselves (workcell::ScriptedMotion). The manipulation thread's.
class ScriptedEntities {
 public:
  /// Where one is on its way: it waits where what is held cannot give way.
  struct OnItsWay {
    double t = 0.0;         ///< s of its script.
    dvec3 velocity_W{0.0};  ///< m/s.
  };

  /// `cell` outlives it.
  explicit ScriptedEntities(CellState& cell) : cell_(cell) {}

  /// Moves them to the cell's time. What `grips` hold gives way, and is not moved itself. `leapt` is called where one
  /// began its way anew. True where a speed is no longer what sets foresee.
  bool move(std::span<StylusGrip* const> grips, const std::function<void()>& leapt);

  /// By entity, all that have moved.
  const std::map<workcell::EntityId, OnItsWay>& onTheirWay() const { return on_their_way_; }
  /// The greatest of their speeds now, m/s.
  double fastest() const;
  /// To the velocities of a set's obstacles, as motions of the stylus: those that go by themselves, and all where the
  /// mapping drifts by `drift_D` (m/s).
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
