// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision/queries/freeing_shift.h"
#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/holding/constraint_builder.h"
#include "manipulation/holding/free_motion.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/manipulators/moved_by.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::haptic {
struct SolverRow;
}

namespace hapticell::manipulation {

class ContactSearch;

/// Where every entity stands that does not stand as in the document.
using Placements = std::map<workcell::EntityId, EntityConfiguration>;

/// Choices of the user that override the entity's own.
struct HoldOptions {
  MovedBy moved_by;
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  workcell::ForceClass force_class = workcell::ForceClass::kContact;
};

/// A part that moves with the held entity: its own, one of what hangs on it, or one of an external axis.
struct MovedPart {
  const ScenePart* part = nullptr;
  workcell::EntityId owner = 0;  ///< The entity that it is a part of.
  int link = -1;                 ///< Of the model that the manipulator moves; -1: a solid moves as a whole.
  Pose X_LP;
};

/// A pair of a moved part with something at rest, or with another moved part, as users know it.
struct HeldPair {
  workcell::EntityId other = 0;
  workcell::EntityId owner = 0;  ///< Whose part moves: the held entity, something that hangs on it, or an axis.
  std::string moved_part;        ///< Link names; empty for solids.
  std::string other_part;
  double safety_distance = 0.0;  ///< m, felt as the boundary.
  double near_miss = 0.0;        ///< m, shown.
  workcell::OnContact on_contact = workcell::OnContact::kSlide;
  PairFeel feel;
};

/// The entity in the user's hand: where it was accepted last, what it may meet and how it follows.
///
/// The accepted configuration never enters anything that the entity did not already touch or intersect when it was
/// taken. Manipulation thread only.
class HeldEntity {
 public:
  ~HeldEntity();
  /// Takes an entity as it stands. Errors: it is locked, has no such frame, cannot be moved in this way.
  static Expected<std::unique_ptr<HeldEntity>> take(std::shared_ptr<const PreparedScene> scene,
                                                    workcell::EntityId entity, const Placements& placements,
                                                    const HoldOptions& options,
                                                    const config::Configuration& configuration);

  workcell::EntityId id() const { return id_; }
  const Manipulator& manipulator() const { return *manipulator_; }
  /// What the manipulator moves; with external axes their joints come first, the robot's last.
  const EntityConfiguration& accepted() const { return accepted_; }
  /// Where the entity itself stands.
  EntityConfiguration standing() const;
  Pose movedFrame() const { return manipulator_->movedFrame(accepted_); }
  /// What goes with it, where it stands now: what hangs on it (a gripped part, and what hangs on that), the external
  /// axes it stands on, and what hangs on these.
  std::vector<std::pair<workcell::EntityId, EntityConfiguration>> carried() const;
  /// Of these the external axes, the one at the bottom first.
  std::vector<std::pair<workcell::EntityId, EntityConfiguration>> axes() const;
  /// Where the moved frame is when every entity stands as `placed` says.
  Pose movedFrameWhen(const std::function<EntityConfiguration(workcell::EntityId)>& placed) const;
  /// A joint that the manipulator tells (MotionLimit::joint) among the entity's own; -1 for an external axis and none.
  int ownJoint(int joint) const;
  /// Its name; the joint exists (contract).
  const std::string& jointName(int joint) const;
  const std::vector<HeldPair>& pairs() const { return pairs_; }
  /// Everything that moves, in the order of Manipulator::partPoses() and of MotionPair::part. The only list of a held
  /// entity's parts: whoever moves the manipulator (checks, pictures, searches) takes the parts from here.
  const std::vector<MovedPart>& movedParts() const { return moved_parts_; }
  /// What the parts may meet, in the order of MotionPair::obstacle.
  const std::vector<const ScenePart*>& obstacleParts() const { return obstacle_parts_; }
  /// Parts, obstacles and pairs as the exact check knows them; pairs in the order of pairs().
  const FreeMotion& motion() const { return *motion_; }
  /// "robot/link_3", or "gripper" for a solid.
  std::string nameOf(const ScenePart& part) const;
  /// What was noticed when it was taken: links that touch each other at rest and so are not checked; what it starts
  /// inside of and which way it comes free.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Of the notes the one about links that touch at rest; empty: there are none.
  const std::string& leftOutNote() const { return left_out_note_; }
  /// The newest set is a plain one (the nearest points of each pair), since no complete one would be of use here.
  bool isPlain() const { return crowded_; }

  /// Goes towards what the stylus (or proxy) at X_DP means, as far as it is free, and along what stands in the way
  /// where that pair slides. `built` is the newest set, or null. No joint goes further than its greatest speed allows
  /// in `duration_s`, all slides taken together.
  struct FollowResult {
    bool blocked = false;    ///< Something stood in the way of the straight motion.
    bool stopped = false;    ///< By a pair that stops.
    int hurried_joint = -1;  ///< One that went as fast as it may while there is way left; -1: none did.
  };
  FollowResult follow(const Pose& X_DP, const MotionMapping& mapping, const BuiltConstraints* built,
                      double duration_s = std::numeric_limits<double>::infinity());

  /// Goes straight from the accepted configuration to another one, in small steps, until something stands in the way.
  struct WayResult {
    double share = 1.0;  ///< Of the way that was gone.
    bool blocked = false;
    std::uint32_t pair = 0;  ///< Where blocked: the index of what stood in the way.
  };
  WayResult goTo(const EntityConfiguration& target);

  /// The constraint set about the accepted configuration.
  struct SetWish {
    double zone_radius = haptic::kWantedZoneRadius;  ///< m of hand.
    double least_radius = 0.003;  ///< m of hand: a complete set that is good for less holds the hand back in free air.
    double turn_ahead = 0.1;      ///< rad.
    bool anew = false;            ///< What was asked for before is not wanted any more (another mapping, say).
    bool may_wait = false;        ///< The last set is good yet: while the next is worked out only `pending` is told.
    double needed_radius = 0.0;   ///< m of hand: what it may go until the set after this one; a set that is only plain
                                  ///< is given for so far, so that its edge is not met in free air.
  };
  /// `pending`: the contacts are not known yet and another call goes on with it; meanwhile the set is a plain one.
  BuiltConstraints constraints(const MotionMapping& mapping, const Pose& X_DProxy, const SetWish& wish);

  /// From now on contacts are looked for by `search`, which outlives this object (null: in constraints() itself).
  void searchWith(ContactSearch* search);
  /// What was asked for is known: constraints() has a set at once.
  bool hasAnswer() const;

  /// Keeps the nearest points to `other` at `offset` (m): an equality over the moved frame's xi in the cell, flat at
  /// the nearest point. None where it is farther than half a metre, touches, or is not checked against this entity.
  std::optional<haptic::Constraint> surfaceConstraint(workcell::EntityId other, double offset);

  /// Dry friction of a mechanism's joints as the hand feels it, N, in steps of 0.05; 0 for everything else.
  double jointFriction() const { return joint_friction_; }

  /// Something that goes by itself is `way_W` (m) farther than before. What is held gives way where it would be hit,
  /// as far as it can; where it cannot the obstacle waits: the share of its way that it went (a machine's own guard).
  double moveOther(workcell::EntityId other, const dvec3& way_W);

  /// Something that another hand moves stands elsewhere now; its way was free of what is held here.
  void placeOther(workcell::EntityId other, const EntityConfiguration& at);

  /// Exact distances of the pairs nearer than `limit` (m) at the accepted configuration, those of `pass` too.
  void distances(double limit, std::vector<FreeMotion::PairDistance>& near);

 private:
  /// m: least boundary, so that the exact check has room to work in.
  static constexpr double kSkin = 20e-6;
  HeldEntity();
  void gatherMovedParts(const Placements& placements);
  void standOnAxes(const Placements& placements);
  bool isMember(workcell::EntityId id) const;
  Expected<void> makeManipulator(const workcell::Entity& entity, const HoldOptions& options,
                                 const config::Configuration& configuration);
  void gatherFriction();
  void gatherPairs(const workcell::Entity& entity, const Placements& placements, const HoldOptions& options,
                   const config::Configuration& configuration);
  void gatherOwnPairs(const workcell::Entity& entity, const HoldOptions& options,
                      const config::Configuration& configuration);
  std::vector<Pose> restPoses(const workcell::Entity& entity) const;
  haptic::Constraint contactOf(const MotionPair& pair, const collision::DistanceResult& found) const;
  void updateJointFriction();
  void noteTurned();
  void startBoundaries();
  void raiseBoundaries();
  void findWaysOut();
  void noteWayOut(std::uint32_t pair, const collision::FreeingShift& shift);
  void updateWaysOut();
  BuiltConstraints plainConstraints(ConstraintInputs inputs);
  ConstraintDraft draft(ConstraintInputs& inputs);
  bool ask(ConstraintInputs& inputs, double least_radius);
  std::optional<BuiltConstraints> takeAnswer(const MotionMapping& mapping, const Pose& X_DProxy);
  BuiltConstraints judged(BuiltConstraints built, ConstraintInputs& inputs, double least_radius);
  BuiltConstraints waiting(ConstraintInputs& inputs, const SetWish& wish);
  struct Rows;
  struct Way;
  void addSoftRows(const BuiltConstraints* built, const MotionMapping& mapping, Rows& rows) const;
  haptic::SolverRow contactRow(const MotionAnswer& answer, const MotionMapping& mapping, double rest) const;
  bool recall(const MotionMapping& mapping, const Pose& X_WWanted);

  std::shared_ptr<const PreparedScene> scene_;
  workcell::EntityId id_ = 0;
  /// What is moved: the entity; with external axes (MovedBy::with_axes) all of them in one model.
  workcell::Entity form_;
  /// One of the entities that `form_` is made of: the external axes from the bottom, the entity last.
  struct Member {
    workcell::EntityId id = 0;
    int first_link = 0, first_joint = 0;
    std::size_t first_variable = 0;
  };
  std::vector<Member> members_;
  EntityConfiguration accepted_;
  std::unique_ptr<Manipulator> manipulator_;
  std::vector<double> friction_;  ///< Of a mechanism's variables, N m or N.
  double joint_friction_ = 0.0;
  std::unique_ptr<FreeMotion> motion_;
  /// An entity that hangs on a link of the held one (-1: on a solid), directly or by others.
  struct Carried {
    workcell::EntityId id = 0;
    int link = -1;
    Pose X_LE;
    std::vector<double> joints;
  };
  std::vector<Carried> carried_;
  std::vector<MovedPart> moved_parts_;
  std::vector<const collision::ConvexPieces*> parts_;
  std::vector<const collision::SurfaceModel*> surfaces_;  ///< Of the parts.
  std::shared_ptr<collision::ContactFinder> finder_;      ///< Shared with a search that is under way.
  ContactSearch* search_ = nullptr;
  /// A draft that is answered meanwhile, and what its set has to be good for.
  struct Asked {
    ConstraintDraft draft;
    double least_radius;
  };
  /// A pair that intersected when the entity was taken: which way it comes out.
  struct WayOut {
    FreeingPlane plane;
    dvec3 p_PC{0.0};       ///< Of the part, that is watched.
    double reached = 0.0;  ///< m along the plane's normal: it goes no deeper again.
  };
  std::vector<WayOut> ways_out_;
  std::vector<FreeingPlane> freeing_;
  std::optional<Asked> asked_;  ///< A search is under way for it.
  std::vector<collision::ZonePart> obstacles_;
  std::vector<const ScenePart*> obstacle_parts_;  ///< In the order of the obstacles.
  std::vector<HeldPair> pairs_;
  std::vector<PairFeel> feel_;
  std::vector<MotionPair> motion_pairs_;
  std::uint32_t first_own_ = 0;  ///< Pairs from here on are of two moved parts.
  std::vector<std::string> notes_;
  std::string left_out_note_;
  std::unique_ptr<Way> way_;
  double needed_radius_ = 0.0;   ///< See SetWish.
  bool crowded_ = false;         ///< The last complete set was too small to be of use.
  double crowded_radius_ = 0.0;  ///< What it was good for, m of hand.
  Pose X_DCrowded_;              ///< Where that was.
  std::vector<double> gaps_;
  std::vector<FreeMotion::PairDistance> near_, own_;
};

}  // namespace hapticell::manipulation
