// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/shapes/pose.h"
#include "manipulation/holding/held_model.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/scene/prepared_scene.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::manipulation {

/// A way to the goal that a planner found for the held entity. Immutable; any thread.
struct PlannedWay {
  std::uint64_t number = 0;   ///< Increases from way to way, from 1.
  std::uint64_t answers = 0;  ///< PlanView::insistences that this way takes into account.
  std::uint64_t hold = 0;     ///< PlanView::hold that it was worked out for; it is not used for another one.
  std::vector<Pose> X_WM;     ///< The moved frame, at least two poses, the last one at the goal. Straight between.
  /// Of a robot or mannequin: all of it, for each of X_WM; a solid: empty.
  std::vector<EntityConfiguration> postures = {};
  double clearance = 0.002;                      ///< m that it keeps from everything.
};

/// Where the entity went in the user's hand, in steps of a few millimetres; the last is the newest.
using Trail = std::vector<EntityConfiguration>;

/// Input of a planner in each step of the manipulation loop.
struct PlanView {
  std::int64_t time_ns = 0;  ///< Of the loop's clock.
  std::shared_ptr<const PreparedScene> scene;
  std::uint64_t hold = 0;             ///< Changes when something is taken, or is moved by another of its frames.
  workcell::EntityId entity = 0;      ///< The held entity.
  std::optional<mannequin::Side> hand = {};  ///< HeldEntity::hand().
  Placements placements;              ///< Where entities are that do not stand as in the scene.
  EntityConfiguration standing;       ///< Where it stands,
  Pose X_WM;                          ///< and its moved frame.
  std::shared_ptr<const Trail> trail;  ///< Since it was taken; never null.
  std::uint64_t insistences = 0;      ///< How often the hand has insisted on another way so far.
  dvec3 push_W{0.0};                  ///< m: where the hand pushes, from the way's nearest point, at the newest
                                      ///< insistence; zero before the first.
  std::uint64_t way_number = 0;       ///< The way that is felt now; 0: none.
  bool strayed = false;               ///< Something keeps the entity off that way.
  double way_left = 0.0;              ///< m of that way, and of its turning (0.1 m a radian), that are still to go.
};

/// A planner that works beside the hand: it gets the newest state and gives its newest way. The interface by which
/// manipulation uses planners without knowing them.
///
/// look(), newest() and isReached() are called by the manipulation thread only, and never wait for a search; a planner
/// in virtual time may search in look().
class PlanSource {
 public:
  virtual ~PlanSource() = default;
  /// Once in each step while the entity is held.
  virtual void look(const PlanView& view) = 0;
  /// The newest way; null: none (yet), or the last one is no longer free.
  virtual std::shared_ptr<const PlannedWay> newest() = 0;
  /// The entity is at the goal.
  virtual bool isReached(const PlanView& view) const = 0;
};

}  // namespace hapticell::manipulation
