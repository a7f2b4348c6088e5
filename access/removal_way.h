// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "access/removal_scene.h"
#include "collision/queries/scene.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::access {

/// A way of a unit, free of contact: straight between the poses of its entity (geometry's interpolate()).
struct RemovalWay {
  enum class Kind { kStraight, kBent, kPlanned, kShown };
  Kind kind = Kind::kStraight;
  std::vector<Pose> X_WE;  ///< Where it stands first, out of the box last.

  double length() const;  ///< m, of the entity's origin.
  /// X_WE after `share` (0 .. 1) of the length.
  Pose at(double share) const;
};

/// "straight", "bent", "planned", "shown".
const char* toString(RemovalWay::Kind kind);

/// A unit among the others that are not gone, for exact motion checks with its thinned parts. One thread.
class UnitMotion {
 public:
  /// `clearance`: m that other units keep; parts that begin nearer only keep the distance that they have.
  UnitMotion(const RemovalScene& scene, std::size_t unit, UnitSet gone, double clearance = 0.0);

  /// How far (share, 0 .. 1) it gets on the motion of its entity from one pose to the other.
  double advance(const Pose& X_WFrom, const Pose& X_WTo);
  /// The unit that stopped the last motion; empty: none did.
  const std::optional<std::size_t>& stoppedBy() const { return stopped_by_; }
  /// Whether it overlaps anything by more than the tolerance there.
  bool collidesAt(const Pose& X_WE);

 private:
  std::vector<collision::MovedPart> motionOf(const Pose& X_WFrom, const Pose& X_WTo) const;

  collision::Scene scene_;
  Pose X_EW_;                         ///< Of the entity at rest, inverted.
  std::vector<Pose> X_WP_;            ///< Of its parts at rest; parts 0 to n - 1 of scene_.
  std::vector<std::size_t> unit_of_;  ///< Unit of each part of scene_.
  double clearance_ = 0.0;
  std::optional<std::size_t> stopped_by_;
};

/// A part's motion while its entity goes from one pose to the other; `X_WP0` is the part's at the first. `radius` (m):
/// no point of it is farther from its origin.
collision::PartMotion rigidMotion(const Pose& X_WFrom, const Pose& X_WTo, const Pose& X_WP0, double radius);

/// A straight way as a RemovalWay.
RemovalWay straightAsWay(const RemovalScene& scene, std::size_t unit, const dvec3& direction_W, double length);

/// A way out by up to three straight pieces without turns, when `gone` have gone; breadth first, so of the fewest
/// pieces. Nothing: none was found within the search's bounds, which proves nothing.
std::optional<RemovalWay> bentWay(const RemovalScene& scene, std::size_t unit, UnitSet gone);

/// Whether a given way of the unit (a recording by hand) is free where `gone` have gone, begins where it stands (1 mm,
/// 1 deg) and ends out of the box. Errors say what is wrong.
Expected<RemovalWay> checkedWay(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                const trajectory::Trajectory& shown);

/// The way at `speed` (m/s; turning at most 45 deg/s), as a motion of the entity by its own frame.
trajectory::Trajectory trajectoryOf(const RemovalScene& scene, std::size_t unit, const RemovalWay& way, double speed);

/// How near a unit comes to a neighbour on its way.
struct NeighbourClearance {
  std::string name;
  bool touches_at_rest = false;
  double slides_m = 0.0;  ///< Way (m) on which it touches the neighbour without a break from the start.
  /// m, the least distance. A neighbour that it touches at rest and leaves at once counts from where the unit has left
  /// it; infinite: never near again. 0 where it slides along.
  double least_m = std::numeric_limits<double>::infinity();
  double at_m = 0.0;  ///< Way until there.
};

/// For each neighbour that comes nearer than a metre, nearest first, measured on the full meshes every 2 mm.
std::vector<NeighbourClearance> clearances(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                           const RemovalWay& way);

}  // namespace hapticell::access
