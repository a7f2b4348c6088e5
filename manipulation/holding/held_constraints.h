// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "manipulation/holding/held_boundaries.h"
#include "manipulation/holding/joint_friction.h"

namespace hapticell::manipulation {

class ContactSearch;

/// The constraint sets of a held entity, made here and now or with the search in another thread. Manipulation thread
/// only.
class HeldConstraints {
 public:
  /// What a set has to be good for.
  struct Wish {
    double zone_radius = haptic::kWantedZoneRadius;  ///< m of hand.
    double least_radius = 0.003;  ///< m of hand: a complete set that is good for less holds the hand back in free air.
    double turn_ahead = 0.1;      ///< rad.
    bool anew = false;            ///< What was asked for before is not wanted any more (another mapping, say).
    bool may_wait = false;        ///< The last set is good yet: while the next is worked out only `pending` is told.
    double needed_radius = 0.0;   ///< m of hand: what it may go until the set after this one; a set that is only plain
                                  ///< is given for so far, so that its edge is not met in free air.
  };

  /// `state` outlives this.
  explicit HeldConstraints(HeldState& state);
  ~HeldConstraints();
  HeldConstraints(const HeldConstraints&) = delete;
  HeldConstraints& operator=(const HeldConstraints&) = delete;

  /// See HeldEntity::constraints().
  BuiltConstraints make(const MotionMapping& mapping, const Pose& X_DProxy, const Wish& wish);
  /// See HeldEntity::searchWith().
  void searchWith(ContactSearch* search) { search_ = search; }
  bool hasAnswer() const;
  /// See HeldEntity::isPlain().
  bool isPlain() const { return crowded_; }
  /// See HeldEntity::surfaceConstraint().
  std::optional<haptic::Constraint> surface(workcell::EntityId other, double offset);
  /// As it was with the newest set, N.
  double jointFriction() const { return friction_.felt(); }

 private:
  /// A draft that is answered meanwhile, and what its set has to be good for.
  struct Asked {
    ConstraintDraft draft;
    double least_radius;
  };
  BuiltConstraints plain(ConstraintInputs inputs);
  ConstraintDraft draft(ConstraintInputs& inputs);
  void ask(ConstraintInputs& inputs, double least_radius);
  std::optional<BuiltConstraints> takeAnswer(const MotionMapping& mapping, const Pose& X_DProxy);
  BuiltConstraints judged(BuiltConstraints built, ConstraintInputs& inputs, double least_radius);
  BuiltConstraints waiting(ConstraintInputs& inputs, const Wish& wish);
  void refresh();

  HeldState& state_;
  HeldBoundaries boundaries_;
  JointFriction friction_;
  std::shared_ptr<collision::ContactFinder> finder_;  ///< Shared with a search that is under way.
  ContactSearch* search_ = nullptr;                   ///< Outlives this; null: contacts are found here.
  std::optional<Asked> asked_;                        ///< A search is under way for it.
  double needed_radius_ = 0.0;                        ///< See Wish.
  bool crowded_ = false;                              ///< The last complete set was too small to be of use.
  double crowded_radius_ = 0.0;                       ///< What it was good for, m of hand.
  Pose X_DCrowded_;                                   ///< Where that was.
  std::vector<FreeMotion::PairDistance> near_, own_;  // Scratch.
};

}  // namespace hapticell::manipulation
