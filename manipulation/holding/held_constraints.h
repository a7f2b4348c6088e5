// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "manipulation/holding/held_boundaries.h"
#include "manipulation/holding/joint_friction.h"

namespace hapticell::manipulation {

class ContactSearch;

/// Makes the constraint sets of a held entity, at once or with the search in another thread. Manipulation thread only.
class HeldConstraints {
 public:
  /// Requirements on a set.
  struct Wish {
    double zone_radius = haptic::kWantedZoneRadius;  ///< m of hand motion.
    double least_radius = 0.003;  ///< m of hand motion: a complete set with a smaller zone would stop the hand in free
                                  ///< space.
    double turn_ahead = 0.1;      ///< rad.
    bool anew = false;            ///< Discard the running search (for example after a change of the mapping).
    bool may_wait = false;        ///< The last set is still valid: until the next one is ready, return only `pending`.
    double needed_radius = 0.0;   ///< m of hand motion until the set after this one; a plain set gets this zone, so
                                  ///< that the hand does not meet its edge in free space.
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
  /// Of the newest set, N.
  double jointFriction() const { return friction_.felt(); }

 private:
  /// The draft of the running search, and the requirements on its set.
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
  std::shared_ptr<collision::ContactFinder> finder_;  ///< Shared with a running search.
  ContactSearch* search_ = nullptr;                   ///< Outlives this; null: contacts are searched here.
  std::optional<Asked> asked_;                        ///< The draft of the running search.
  double needed_radius_ = 0.0;                        ///< See Wish.
  bool crowded_ = false;                              ///< The last complete set was too small to be useful.
  double crowded_radius_ = 0.0;                       ///< Its zone, m of hand motion.
  Pose X_DCrowded_;                                   ///< Its reference.
  std::vector<FreeMotion::PairDistance> near_, own_;  // Scratch.
};

}  // namespace hapticell::manipulation
