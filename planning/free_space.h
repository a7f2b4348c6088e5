// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision/queries/scene.h"
#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "manipulation/holding/held_model.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/manipulators/moved_by.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::planning {

struct CheckedPair;
class SpacePlan;
class StandingFigure;
struct Shortfall;
using manipulation::EntityConfiguration;

/// Two parts that come nearer than they may.
struct Blocker {
  std::string moved;             ///< "robot/link_4", or "bolt" for a solid.
  std::string met;               ///< "fixture", or the own link.
  workcell::EntityId other = 0;  ///< The entity of `met`; the moved one itself if it meets its own parts.
  Text text() const;             ///< "robot/link_4 would touch fixture"
};

/// A pair of a moved part with something of the cell, and how far apart it is.
struct PairGap {
  std::uint32_t pair = 0;  ///< For FreeSpace::gapOf() and setChecked().
  double gap = 0.0;        ///< m; below 0: a shift by so much frees them. -infinity: no shift that frees them is found.
  dvec3 open_W{0.0};       ///< Unit: where the moved part goes to come apart.
  Blocker who;
};

/// Where an entity (a robot or mechanism by its joints, a solid by its pose, a mannequin by one of its hands) may be and
/// move in a prepared cell: checks of configurations and of whole motions on the full meshes.
///
/// It moves what a hold of the entity moves (its parts, and what is attached to it) and checks what a hold checks; the
/// pair rules of the document count. Links against each other need only not touch. Left out are: pairs in contact mode
/// *Pass*, pairs that no joint moves against each other (a base on its table), and links that touch at rest. For a
/// robot, so is what it touches where it stands now and at joint positions all over its ranges too (a first link that
/// turns on the table, a door in its hinge); note() names it. What it only touches now is checked. A mannequin's feet
/// stay where they are and are not checked; a posture is free only if it stands too (StandingFigure).
///
/// One object belongs to one thread; fresh() makes one for another thread, and is cheap. Answers do not depend on what
/// was asked before.
class FreeSpace {
 public:
  /// Everything else stays where it is in the scene, or in `placements`. Errors: no such entity; one that is neither a
  /// solid nor has joints; a mannequin without `hand`, or `hand` with another entity. A locked entity may be checked.
  /// `with_axes`: a robot's external axes that are not locked move along; configurations then have the placement of the
  /// lowest axis, and the joints of all of them, the lowest first, the robot's own last.
  static Expected<FreeSpace> create(std::shared_ptr<const manipulation::PreparedScene> scene, workcell::EntityId entity,
                                    const config::Configuration& configuration,
                                    const manipulation::Placements& placements = {},
                                    const std::optional<mannequin::Side>& hand = {}, bool with_axes = false);
  /// The same space and clearance for another thread, without any answers known.
  FreeSpace fresh() const;

  /// The distance (m, 0 or more) that all pairs but the entity's own keep in every later question. At first 0: nothing
  /// touches.
  void setClearance(double clearance);
  double clearance() const { return clearance_; }
  /// Later questions are answered "not free" at once while *stop is true; null: never. It must outlive the object.
  void setStop(const std::atomic<bool>* stop) { stop_ = stop; }

  /// True if every pair is at least the clearance apart (own pairs: not touching) at this configuration.
  bool isFree(const EntityConfiguration& at);
  /// True if that holds everywhere on the motion between() from one to the other, proven continuously. Motions that
  /// keep the clearance by less than a tenth of it (at least 0.1 mm) may be called not free; never the reverse.
  bool isFree(const EntityConfiguration& from, const EntityConfiguration& to);
  /// What the last isFree() found in the way; empty after a free answer or a stop.
  const std::optional<Blocker>& blocker() const { return blocked_by_; }

  /// The least distance (m) of all pairs but the own ones, up to `limit`; 0 in contact.
  double clearanceAt(const EntityConfiguration& at, double limit);
  /// The pair of that distance; empty if nothing is nearer than `limit`.
  std::optional<Blocker> nearestAt(const EntityConfiguration& at, double limit);

  /// All pairs but the own ones that are nearer than `limit` (m), the nearest first. Milliseconds each in contact.
  std::vector<PairGap> gapsAt(const EntityConfiguration& at, double limit);
  /// PairGap::gap of one of them.
  double gapOf(std::uint32_t pair, const EntityConfiguration& at);
  /// Whether later questions but gapOf() heed these pairs; at first they do.
  void setChecked(const std::vector<PairGap>& pairs, bool checked);
  /// The configuration near `from` with the tool (a solid's frame) at X_WT, or as near to that as it can be.
  EntityConfiguration proposed(const EntityConfiguration& from, const Pose& X_WT) const;

  /// The configuration at `s` in [0, 1] of the motion that is checked: joints straight, or origin straight and rotation
  /// about a fixed axis; a mannequin's legs as its feet ask for.
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const;
  /// The longest path (m) of any point of the entity on that motion, as an upper bound.
  double pathBound(const EntityConfiguration& from, const EntityConfiguration& to) const;
  /// X_WT of a robot's tool centre point or of the grip of the moved hand, or X_WE of a solid.
  Pose toolAt(const EntityConfiguration& at) const;
  /// The box around all that the entity could meet (m, world); empty if there is nothing.
  const geometry::Bounds& obstacleBounds() const;
  /// The radius (m) of a sphere around the origin of its frame E that holds a solid and what it carries; meaningless
  /// for a robot.
  double radius() const;

  /// Of a mannequin; null: a robot or a solid.
  const StandingFigure* figure() const;
  /// Postures with the grip of the mannequin's moved hand at X_WT, by StandingFigure::posturesAt(). Contract: a figure.
  std::vector<EntityConfiguration> posturesAt(const Pose& X_WT, const EntityConfiguration& from,
                                              Shortfall* shortfall = nullptr) const;

  /// With external axes: all of them as one robot.
  const workcell::Entity& entity() const;
  const manipulation::PreparedScene& scene() const;
  /// The entity of the scene, without its axes.
  const workcell::Entity& ownEntity() const;
  /// Its placement and its own joints if all of it is at `all`.
  EntityConfiguration ownAt(const EntityConfiguration& all) const;
  /// Each external axis, the lowest first, if all of it is at `all`; empty: none moves along.
  manipulation::HeldModel::Standing axesAt(const EntityConfiguration& all) const;
  /// Variables of the external axes: the first of a configuration's joints.
  std::size_t axisVariables() const;
  bool hasJoints() const { return entity().robot() != nullptr; }
  /// Its configuration in the scene, or in `placements`.
  const EntityConfiguration& present() const;
  /// What is not checked, in a sentence; empty: everything is.
  const Text& note() const;
  /// Configurations and motions that were checked by this object.
  std::size_t checks() const { return checks_; }

 private:
  explicit FreeSpace(std::shared_ptr<const SpacePlan> plan);
  bool standsFree(const EntityConfiguration& at);
  bool isKnownFree(const EntityConfiguration& at) const;
  void setKnownFree(const EntityConfiguration& at);
  bool isMetOnTheWay(const EntityConfiguration& from, const EntityConfiguration& to);
  bool meetsNothing(bool moves);
  bool isProven(const EntityConfiguration& from, const EntityConfiguration& to);
  double ownWay(const CheckedPair& pair, const EntityConfiguration& from, const EntityConfiguration& to);
  bool keptApart(std::size_t own, const EntityConfiguration& at) const;
  bool ownPartsTouch(const EntityConfiguration& at);
  bool ownPartsTouch(const EntityConfiguration& from, const EntityConfiguration& to);
  PairGap gapFrom(const collision::PairDistance& found) const;
  void place(const EntityConfiguration& at);
  std::optional<collision::PairDistance> measure(const EntityConfiguration& at, double limit);

  std::shared_ptr<const SpacePlan> plan_;
  collision::Scene scene_;                      ///< The moved parts first, then the obstacles; pairs of the two.
  std::vector<collision::ProximityQuery> own_;  ///< Pairs of two moved parts.
  double clearance_ = 0.0;
  std::vector<double> clearances_;           ///< By tag: the pair's number.
  std::vector<collision::MovedPart> moved_;  ///< Scratch.
  std::vector<Pose> X_WP_;                   ///< Scratch.
  std::vector<double> bounds_, own_bounds_;  ///< Scratch.
  std::unordered_map<std::uint64_t, EntityConfiguration> known_free_;  ///< Ends of motions that were asked before.
  std::optional<Blocker> blocked_by_;
  const std::atomic<bool>* stop_ = nullptr;
  std::size_t checks_ = 0;
};

}  // namespace hapticell::planning
