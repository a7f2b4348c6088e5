// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "manipulation/holding/held_constraints.h"
#include "manipulation/holding/held_way.h"

namespace hapticell::manipulation {

/// The entity in the user's hand: where it was accepted last, what it may meet and how it follows.
///
/// The accepted configuration never enters anything that the entity did not already touch or intersect when it was
/// taken. Manipulation thread only.
class HeldEntity {
 public:
  using FollowResult = HeldWay::Followed;
  using WayResult = HeldWay::Gone;
  using SetWish = HeldConstraints::Wish;

  /// Takes an entity as it stands. Errors: it is locked, has no such frame, cannot be moved in this way.
  static Expected<std::unique_ptr<HeldEntity>> take(std::shared_ptr<const PreparedScene> scene,
                                                    workcell::EntityId entity, const Placements& placements,
                                                    const HoldOptions& options,
                                                    const config::Configuration& configuration);

  workcell::EntityId id() const { return state_.model.id(); }
  const Manipulator& manipulator() const { return *state_.manipulator; }
  /// What the manipulator moves; with external axes their joints come first, the robot's last.
  const EntityConfiguration& accepted() const { return state_.accepted; }
  /// Where the entity itself stands.
  EntityConfiguration standing() const { return state_.model.standing(state_.accepted); }
  Pose movedFrame() const { return state_.movedFrame(); }
  /// What goes with it, where it stands now: what hangs on it (a gripped part, and what hangs on that), the external
  /// axes it stands on, and what hangs on these.
  HeldModel::Standing carried() const { return state_.model.carried(state_.accepted); }
  /// Of these the external axes, the one at the bottom first.
  HeldModel::Standing axes() const { return state_.model.axes(state_.accepted); }
  /// Where the moved frame is when every entity stands as `placed` says.
  Pose movedFrameWhen(const std::function<EntityConfiguration(workcell::EntityId)>& placed) const;
  /// A joint that the manipulator tells (MotionLimit::joint) among the entity's own; -1 for an external axis and none.
  int ownJoint(int joint) const { return state_.model.ownJoint(joint); }
  /// Its name; the joint exists (contract).
  const std::string& jointName(int joint) const { return state_.model.jointName(joint); }
  const std::vector<HeldPair>& pairs() const { return state_.pairs.all(); }
  /// Everything that moves, in the order of Manipulator::partPoses() and of MotionPair::part. The only list of a held
  /// entity's parts: whoever moves the manipulator (checks, pictures, searches) takes the parts from here.
  const std::vector<MovedPart>& movedParts() const { return state_.model.parts(); }
  /// What the parts may meet, in the order of MotionPair::obstacle.
  const std::vector<const ScenePart*>& obstacleParts() const { return state_.pairs.obstacleParts(); }
  /// Parts, obstacles and pairs as the exact check knows them; pairs in the order of pairs().
  const FreeMotion& motion() const { return state_.motion; }
  /// "robot/link_3", or "gripper" for a solid.
  std::string nameOf(const ScenePart& part) const { return state_.model.nameOf(part); }
  /// What was noticed when it was taken: links that touch each other at rest and so are not checked; what it starts
  /// inside of and which way it comes free.
  const std::vector<Text>& notes() const { return state_.notes; }
  /// Of the notes the one about links that touch at rest; empty: there are none.
  const Text& leftOutNote() const { return state_.pairs.leftOutNote(); }

  /// Goes towards what the stylus (or proxy) at X_DP means, as far as it is free, and along what stands in the way
  /// where that pair slides. `built` is the newest set, or null. No joint goes further than its greatest speed allows
  /// in `duration_s`, all slides taken together.
  FollowResult follow(const Pose& X_DP, const MotionMapping& mapping, const BuiltConstraints* built,
                      double duration_s = std::numeric_limits<double>::infinity()) {
    return way_.follow(X_DP, mapping, built, duration_s);
  }
  /// Goes straight from the accepted configuration to another one, in small steps, until something stands in the way.
  WayResult goTo(const EntityConfiguration& target) { return way_.goTo(target); }
  /// Something that goes by itself is `way_W` (m) farther than before. What is held gives way where it would be hit,
  /// as far as it can; where it cannot the obstacle waits: the share of its way that it went (a machine's own guard).
  double moveOther(workcell::EntityId other, const dvec3& way_W) { return way_.moveOther(other, way_W); }
  /// Something that another hand moves stands elsewhere now; its way was free of what is held here.
  void placeOther(workcell::EntityId other, const EntityConfiguration& at) { way_.placeOther(other, at); }

  /// The constraint set about the accepted configuration. `pending`: the contacts are not known yet and another call
  /// goes on with it; meanwhile the set is a plain one.
  BuiltConstraints constraints(const MotionMapping& mapping, const Pose& X_DProxy, const SetWish& wish) {
    return constraints_.make(mapping, X_DProxy, wish);
  }
  /// The newest set is a plain one (the nearest points of each pair), since no complete one would be of use here.
  bool isPlain() const { return constraints_.isPlain(); }
  /// From now on contacts are looked for by `search`, which outlives this object (null: in constraints() itself).
  void searchWith(ContactSearch* search) { constraints_.searchWith(search); }
  /// What was asked for is known: constraints() has a set at once.
  bool hasAnswer() const { return constraints_.hasAnswer(); }
  /// Keeps the nearest points to `other` at `offset` (m): an equality over the moved frame's xi in the cell, flat at
  /// the nearest point. None where it is farther than half a metre, touches, or is not checked against this entity.
  std::optional<haptic::Constraint> surfaceConstraint(workcell::EntityId other, double offset) {
    return constraints_.surface(other, offset);
  }
  /// Dry friction of a mechanism's joints as the hand feels it, N, in steps of 0.05; 0 for everything else.
  double jointFriction() const { return constraints_.jointFriction(); }

  /// Exact distances of the pairs nearer than `limit` (m) at the accepted configuration, those of `pass` too.
  void distances(double limit, std::vector<FreeMotion::PairDistance>& near) { state_.motion.distances(limit, near); }

 private:
  explicit HeldEntity(HeldState state);

  HeldState state_;
  HeldConstraints constraints_;
  HeldWay way_;
};

}  // namespace hapticell::manipulation
