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

/// The entity in the user's hand: its last accepted configuration, its pairs and how it follows.
///
/// The accepted configuration never enters anything that the entity did not already touch or intersect when it was
/// taken. Manipulation thread only.
class HeldEntity {
 public:
  using FollowResult = HeldWay::Followed;
  using WayResult = HeldWay::Gone;
  using SetWish = HeldConstraints::Wish;

  /// Takes an entity at its present placement. Errors: it is locked, has no such frame, cannot be moved in this way.
  static Expected<std::unique_ptr<HeldEntity>> take(std::shared_ptr<const PreparedScene> scene,
                                                    workcell::EntityId entity, const Placements& placements,
                                                    const HoldOptions& options,
                                                    const config::Configuration& configuration);

  workcell::EntityId id() const { return state_.model.id(); }
  const Manipulator& manipulator() const { return *state_.manipulator; }
  /// What the manipulator moves; with external axes their joints come first, the robot's last.
  const EntityConfiguration& accepted() const { return state_.accepted; }
  /// The entity's own placement and joints.
  EntityConfiguration standing() const { return state_.model.standing(state_.accepted); }
  Pose movedFrame() const { return state_.movedFrame(); }
  /// The one hand by which a mannequin is moved with nothing locked and no steps allowed; empty: all others.
  const std::optional<mannequin::Side>& hand() const { return state_.hand; }
  /// Entities that move with it, at their present placements: those attached to it, directly or through others (a
  /// gripped part), its external axes, and those attached to these.
  HeldModel::Standing carried() const { return state_.model.carried(state_.accepted); }
  /// Of these the external axes, the bottom one first.
  HeldModel::Standing axes() const { return state_.model.axes(state_.accepted); }
  /// The moved frame if every entity is at its placement in `placed`.
  Pose movedFrameWhen(const std::function<EntityConfiguration(workcell::EntityId)>& placed) const;
  /// Converts a joint index of the manipulator (MotionLimit::joint) to one of the entity; -1 for an external axis and
  /// for "no joint".
  int ownJoint(int joint) const { return state_.model.ownJoint(joint); }
  /// Its name; the joint exists (contract).
  const std::string& jointName(int joint) const { return state_.model.jointName(joint); }
  const std::vector<HeldPair>& pairs() const { return state_.pairs.all(); }
  /// Everything that moves, in the order of Manipulator::partPoses() and of MotionPair::part. The only list of a held
  /// entity's parts: all code that moves the manipulator (checks, drawing, searches) uses it.
  const std::vector<MovedPart>& movedParts() const { return state_.model.parts(); }
  /// What the parts may meet, in the order of MotionPair::obstacle.
  const std::vector<const ScenePart*>& obstacleParts() const { return state_.pairs.obstacleParts(); }
  /// Parts, obstacles and pairs of the exact check; pairs in the order of pairs().
  const FreeMotion& motion() const { return state_.motion; }
  /// "robot/link_3", or "gripper" for a solid.
  std::string nameOf(const ScenePart& part) const { return state_.model.nameOf(part); }
  /// Notes from the taking: links that touch each other at rest and are therefore not checked; what it starts inside,
  /// and in which direction it comes free.
  const std::vector<Text>& notes() const { return state_.notes; }
  /// The note about links that touch at rest; empty: no such links.
  const Text& leftOutNote() const { return state_.pairs.leftOutNote(); }

  /// Moves towards the target of the stylus (or proxy) at X_DP as far as the way is free, and slides along obstacles
  /// whose pair is in mode *Slide*. `built` is the newest set, or null. No joint moves further than its greatest speed
  /// allows in `duration_s`, including all sliding.
  FollowResult follow(const Pose& X_DP, const MotionMapping& mapping, const BuiltConstraints* built,
                      double duration_s = std::numeric_limits<double>::infinity()) {
    return way_.follow(X_DP, mapping, built, duration_s);
  }
  /// Moves straight from the accepted configuration to another one, in small steps, until something blocks it.
  WayResult goTo(const EntityConfiguration& target) { return way_.goTo(target); }
  /// Moves a scripted obstacle by `way_W` (m). The held entity gives way where it would be hit, as far as it can; if it
  /// cannot, the obstacle waits, as with a machine's guard. Returns the share of the motion that the obstacle made.
  double moveOther(workcell::EntityId other, const dvec3& way_W) { return way_.moveOther(other, way_W); }
  /// An entity moved by another hand has a new placement; its way did not collide with the held entity.
  void placeOther(workcell::EntityId other, const EntityConfiguration& at) { way_.placeOther(other, at); }

  /// The constraint set around the accepted configuration. `pending`: the contacts are not known yet and another call
  /// continues the search; until then the set is a plain one.
  BuiltConstraints constraints(const MotionMapping& mapping, const Pose& X_DProxy, const SetWish& wish) {
    return constraints_.make(mapping, X_DProxy, wish);
  }
  /// Whether the newest set is a plain one (the nearest points of each pair), because a complete one would be too small
  /// to be useful here.
  bool isPlain() const { return constraints_.isPlain(); }
  /// From now on `search` finds the contacts; it outlives this object (null: constraints() finds them itself).
  void searchWith(ContactSearch* search) { constraints_.searchWith(search); }
  /// True if the search is finished, so constraints() returns a set at once.
  bool hasAnswer() const { return constraints_.hasAnswer(); }
  /// Keeps the nearest points to `other` at `offset` (m): an equality over the moved frame's xi in the cell, flat at
  /// the nearest point. Empty if `other` is farther than half a metre, touches, or is not checked against this entity.
  std::optional<haptic::Constraint> surfaceConstraint(workcell::EntityId other, double offset) {
    return constraints_.surface(other, offset);
  }
  /// Dry friction of a mechanism's joints as the hand feels it, N, in steps of 0.05; 0 for other entities.
  double jointFriction() const { return constraints_.jointFriction(); }

  /// Exact distances of the pairs nearer than `limit` (m) at the accepted configuration, including pairs in mode
  /// *Pass*.
  void distances(double limit, std::vector<FreeMotion::PairDistance>& near) { state_.motion.distances(limit, near); }

 private:
  explicit HeldEntity(HeldState state);

  HeldState state_;
  HeldConstraints constraints_;
  HeldWay way_;
};

}  // namespace hapticell::manipulation
