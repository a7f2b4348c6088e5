// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "haptic/transport/haptic_link.h"
#include "manipulation/engine/felt_guides.h"
#include "manipulation/engine/felt_plan.h"
#include "manipulation/engine/hand_mapping.h"
#include "manipulation/engine/scripted_entities.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

/// Decides when one stylus needs a new constraint set and how large its zone must be, makes it and sends it.
/// Manipulation thread only.
class SetScheduler {
 public:
  /// The inputs of a set in this step.
  struct Inputs {
    HeldEntity* held = nullptr;  ///< Null if nothing is held, or the hand moves without it.
    const HandMapping& hand;
    const haptic::HapticState& state;
    const FeltGuides& guides;
    const FeltPlan& plan;
    const ScriptedEntities& scripted;
    std::int64_t now_ns;
  };

  /// `zone_radius`: default zone radius of a set, m of hand motion.
  explicit SetScheduler(double zone_radius) : configured_radius_(zone_radius) {}

  /// The last set is out of date: makes a new one at the next step.
  void want() { wanted_ = true; }
  /// Others moved, so the set is out of date. Does not make one at every step, because a set costs time.
  void wantForOthers(std::int64_t now_ns);
  /// What pulls has moved on, but what the last set says of contacts is still true: makes a set soon, without discarding
  /// a running search.
  void refresh() { refresh_ = true; }
  /// Forgets the last set.
  void forget() { built_ = {}; }
  /// Makes and sends a set if one is due.
  void update(const Inputs& inputs, haptic::HapticLink& link);

  /// The newest set.
  const BuiltConstraints& built() const { return built_; }
  /// Sequence of the newest set sent; 0 before the first.
  std::uint64_t sent() const { return sequence_; }

 private:
  bool isDue(const Inputs& inputs) const;
  bool holdsStill(const Inputs& inputs) const;
  /// False if it is not ready yet; the last set stays in use.
  bool make(const Inputs& inputs, bool changed);
  HeldEntity::SetWish wish(const Inputs& inputs, bool changed);
  void wishZone(const Inputs& inputs, HeldEntity::SetWish& wish);
  void addLagRow(const Inputs& inputs);
  double moved(const Inputs& inputs) const;

  const double configured_radius_;
  bool wanted_ = true;
  bool refresh_ = false;
  BuiltConstraints built_;
  std::uint64_t sequence_ = 0;
  std::int64_t set_ns_ = 0;
  std::int64_t last_set_ns_ = 0;
  std::int64_t adopted_ns_ = 0;  ///< When the set used by the newest state was made.
  std::deque<std::pair<std::uint64_t, std::int64_t>> on_their_way_;  ///< Sent sets whose adoption is not reported yet:
                                                                     ///< number, time made.
  double speed_ = 0.0;                                               ///< Recent speed of the hand, m/s.
  std::int64_t speed_ns_ = 0;
  Pose X_DSeen_;  ///< The stylus at the previous set.
  Pose X_DLag_;   ///< Reference of the previous set.
  std::vector<double> gaps_;
};

}  // namespace hapticell::manipulation
