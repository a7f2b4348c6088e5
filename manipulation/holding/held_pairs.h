// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/text.h"
#include "manipulation/holding/constraint_builder.h"
#include "manipulation/holding/free_motion.h"
#include "manipulation/holding/held_model.h"
#include "manipulation/holding/hold_options.h"

namespace hapticell::manipulation {

/// A pair of a moved part with an obstacle, or with another moved part, in the user's terms.
struct HeldPair {
  workcell::EntityId other = 0;
  workcell::EntityId owner = 0;  ///< Owner of the moved part: the held entity, one attached to it, or an axis.
  std::string moved_part;        ///< Link names; empty for solids.
  std::string other_part;
  double safety_distance = 0.0;  ///< m, felt as the boundary.
  double near_miss = 0.0;        ///< m, shown.
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  PairFeel feel;
};

/// What a held entity is checked against: the obstacles, and the pairs of its parts with these and among each other.
/// The feet of a mannequin that is moved by a hand or its head are not checked against what they stand on.
/// One thread.
class HeldPairs {
 public:
  /// `manipulator` moves the model.
  HeldPairs(const HeldModel& model, const Manipulator& manipulator, const Placements& placements,
            const HoldOptions& options, const config::Configuration& configuration);

  const std::vector<HeldPair>& all() const { return pairs_; }
  const HeldPair& operator[](std::size_t pair) const { return pairs_[pair]; }
  std::size_t size() const { return pairs_.size(); }
  /// The same pairs for the exact check.
  const std::vector<MotionPair>& motionPairs() const { return motion_pairs_; }
  /// Pairs from this index on have two moved parts.
  std::uint32_t firstOwn() const { return first_own_; }

  /// How each pair is felt now; HeldBoundaries changes it.
  const std::vector<PairFeel>& feel() const { return feel_; }
  std::vector<PairFeel>& feel() { return feel_; }

  /// What the parts may meet, in the order of MotionPair::obstacle: present pose and identity.
  const std::vector<collision::ZonePart>& obstacles() const { return obstacles_; }
  const std::vector<const ScenePart*>& obstacleParts() const { return obstacle_parts_; }
  void moveObstacle(std::size_t obstacle, const Pose& X_W) { obstacles_[obstacle].X_W = X_W; }

  /// A motion check against all of these; call its reset() before use.
  FreeMotion motionCheck(const HeldModel& model) const;

  /// The note about what is not checked: links that touch at rest, feet that stand on something. Empty: nothing of that
  /// kind.
  const Text& leftOutNote() const { return left_out_note_; }

 private:
  void gatherObstacles(const HeldModel& model, const Manipulator& manipulator, const Placements& placements,
                       const HoldOptions& options, const config::Configuration& configuration);
  void gatherOwn(const HeldModel& model, const Manipulator& manipulator, const HoldOptions& options,
                 double safety_distance);
  void add(const MotionPair& motion_pair, HeldPair pair);

  std::vector<HeldPair> pairs_;
  std::vector<PairFeel> feel_;
  std::vector<MotionPair> motion_pairs_;
  std::uint32_t first_own_ = 0;
  std::vector<collision::ZonePart> obstacles_;
  std::vector<const ScenePart*> obstacle_parts_;
  Text left_out_note_;
};

}  // namespace hapticell::manipulation
