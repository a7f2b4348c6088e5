// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "haptic/transport/haptic_link.h"
#include "manipulation/engine/felt_guides.h"
#include "manipulation/engine/hand_mapping.h"
#include "manipulation/engine/scripted_entities.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

/// Decides when one stylus gets a new constraint set and how far that must be good for, has it made and sends it. The
/// manipulation thread's.
class SetScheduler {
 public:
  /// What a set is made of, as it is in this step.
  struct Inputs {
    HeldEntity* held = nullptr;  ///< Null while nothing is held, or the hand moves without it.
    const HandMapping& hand;
    const haptic::HapticState& state;
    const FeltGuides& guides;
    const ScriptedEntities& scripted;
    std::int64_t now_ns;
  };

  /// `zone_radius`: m of hand that a set is good for where nothing asks for more.
  explicit SetScheduler(double zone_radius) : configured_radius_(zone_radius) {}

  /// The last one is not true any more: one is made at the next step.
  void want() { wanted_ = true; }
  /// Others moved: what is felt is not true any more. Not at every step, a set costs time.
  void wantForOthers(std::int64_t now_ns);
  /// Nothing is felt of the last set.
  void forget() { built_ = {}; }
  /// Makes and sends one where it is time for one.
  void update(const Inputs& inputs, haptic::HapticLink& link);

  /// The newest.
  const BuiltConstraints& built() const { return built_; }
  /// Sequence of the newest that was sent; 0 before the first.
  std::uint64_t sent() const { return sequence_; }

 private:
  bool isDue(const Inputs& inputs) const;
  bool holdsStill(const Inputs& inputs) const;
  /// False where it is still being worked out and the last one goes on.
  bool make(const Inputs& inputs, bool changed);
  HeldEntity::SetWish wish(const Inputs& inputs, bool changed);
  void wishZone(const Inputs& inputs, HeldEntity::SetWish& wish);
  void addLagRow(const Inputs& inputs);
  double moved(const Inputs& inputs) const;

  const double configured_radius_;
  bool wanted_ = true;
  BuiltConstraints built_;
  std::uint64_t sequence_ = 0;
  std::int64_t set_ns_ = 0;
  std::int64_t last_set_ns_ = 0;
  std::int64_t adopted_ns_ = 0;  ///< When the set was made that the newest state was rendered with.
  std::deque<std::pair<std::uint64_t, std::int64_t>> on_their_way_;  ///< Sets not seen adopted: number, when made.
  double speed_ = 0.0;                                               ///< Of the hand lately, m/s.
  std::int64_t speed_ns_ = 0;
  Pose X_DSeen_;  ///< The stylus at the set before.
  Pose X_DLag_;   ///< Reference of the set before.
  std::vector<double> gaps_;
};

}  // namespace hapticell::manipulation
