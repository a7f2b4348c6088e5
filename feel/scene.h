// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/devices/simulated_hand.h"
#include "haptic/rendering/constraint_set.h"

namespace hapticell::feel {

using haptic::Constraint;
using haptic::ConstraintKind;
using haptic::ConstraintSet;

/// What a point stylus feels, known exactly. Device frame, metres.
class FeelScene {
 public:
  virtual ~FeelScene() = default;
  virtual std::string name() const = 0;
  /// The exact set about a proxy at time `t` (seconds of the session): everything within the zone.
  virtual ConstraintSet setAt(const Pose& X_DP, double t) const = 0;
  /// How deep the proxy lies inside the obstacle (or off the guide), 0 outside; the second method for it.
  virtual double penetration(const Pose& X_DP, double t) const = 0;
  /// The same for a held body made of facets, computed as if it were exactly round; 0 without contact.
  virtual double roundPenetration(const Pose&, double) const { return 0.0; }
  /// Where the hand goes `t` seconds into the sliding, and for how long; `press` is the depth of the intended pose.
  virtual dvec3 handAt(double t, double press) const = 0;
  /// How fast everything drifts, m/s (an obstacle on a conveyor and the hand that goes with it).
  virtual dvec3 drift() const { return dvec3(0.0); }
  /// The hand for this path. To follow a sharp curve it must be stiff compared with how deep it presses.
  virtual haptic::HandOptions hand() const { return {}; }
  /// How the hand turns the stylus during the sliding.
  virtual dquat turnAt(double) const { return dquat(1.0, 0.0, 0.0, 0.0); }
  /// A free place near the path's beginning, with no force.
  virtual dvec3 start() const { return handAt(0.0, -0.004); }
  /// A place on the surface where a stylus of some weight stays.
  virtual dvec3 rest() const { return dvec3(0.0); }
  /// Where the hand presses at rest().
  virtual dvec3 pressDirection() const { return {0.0, 0.0, -1.0}; }
  double friction = 0.0;
};

std::unique_ptr<FeelScene> planeScene();
/// A cylinder along y whose top is the origin.
std::unique_ptr<FeelScene> cylinderScene(double radius);
/// The same, tessellated: flat facets of so many degrees each, all in one group.
std::unique_ptr<FeelScene> facetScene(double radius, double degrees);
/// A bore along y about the origin.
std::unique_ptr<FeelScene> boreScene(double radius);
/// The convex edge of a block (x < 0 and z < 0), along y.
std::unique_ptr<FeelScene> edgeScene();
/// Three planes, concave: the corner of a box at the origin.
std::unique_ptr<FeelScene> cornerScene();
/// A circle of 40 mm about the y axis that cannot be left, with a stop.
std::unique_ptr<FeelScene> hingeScene();

/// A 1 mm plate of 100 x 100 mm about the origin, normal z: six faces, one group.
std::unique_ptr<FeelScene> plateScene();
/// A box of 60 x 40 x 20 mm held by the middle of its top, flat on a plane and turned about all axes: eight corners.
std::unique_ptr<FeelScene> boxScene();
/// A peg, 30 mm long, in a hole with 0.05 mm of clearance and a bottom: planes in 8 directions at both rims.
std::unique_ptr<FeelScene> pegScene();

/// Obstacle and hand drift at `velocity` (m/s); the hand also follows the scene's own path. Lasts for `duration` (s) of
/// sliding, centred in the workspace.
std::unique_ptr<FeelScene> driftingScene(std::unique_ptr<FeelScene> scene, const dvec3& velocity, double duration);
/// `cell` felt through a motion scale of so many metres of the cell a metre of hand; the hand goes along the path of
/// `hand`, the same thing in its own size.
std::unique_ptr<FeelScene> scaledScene(std::unique_ptr<FeelScene> cell, std::unique_ptr<FeelScene> hand, double scale);

/// `scene` at full authority of a planner (manipulation/engine/felt_plan.h) whose way changes ten times a second, in
/// any direction.
std::unique_ptr<FeelScene> plannedScene(std::unique_ptr<FeelScene> scene);

/// The built-in robot dragged by its tool centre point against the upper limit of its third joint.
Expected<std::unique_ptr<FeelScene>> jointLimitScene();
/// The same robot whose forearm touches a wall and slides along it.
Expected<std::unique_ptr<FeelScene>> linkContactScene();

/// An empty set about the proxy, with the zone that is asked for.
ConstraintSet emptySet(const Pose& X_DP);
/// Appends an entry; there is room for it (contract).
void add(ConstraintSet& set, const Constraint& constraint);
/// Back and forth between -1 and 1 at constant speed; `rate` in strokes per second.
double triangleWave(double t, double rate);

/// A plane patch through `point` with the normal, as seen from X_DR: exact for a point stylus.
Constraint planeConstraint(const dvec3& point, const dvec3& normal, const Pose& X_DR, std::uint32_t group);

/// The plane's constraint on the point `p_SB` of a body held at the stylus, with the curvature of turning.
Constraint bodyPointConstraint(const dvec3& p_SB, double gap, const dvec3& normal, const Pose& X_DR);

/// f(w) = n.e + 1/2 e' M e with e = w - point, re-expanded about X_DR for a point stylus.
Constraint quadricConstraint(const dvec3& point, const dvec3& normal, const dmat3& M, const Pose& X_DR);

}  // namespace hapticell::feel
