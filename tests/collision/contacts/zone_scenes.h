// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision/contacts/contact_finder.h"
#include "collision/queries/proximity_query.h"
#include "collision/contacts/zone_contacts.h"
#include "geometry/shapes/pose.h"

namespace hapticell::test {

inline Pose at(double x, double y, double z, const dvec3& rotation = dvec3(0.0)) {
  return {dvec3(x, y, z), quaternionFromRotationVector(rotation)};
}

/// A moved mesh at some places near a fixed one; E is the fixed mesh's frame and the world.
struct ZoneScene {
  std::string name;
  geometry::TriangleMesh moving;
  geometry::TriangleMesh environment;
  std::vector<Pose> places;  ///< X_WM, all free of contact or touching.
  double radius = 0.060;
};

/// Scenes made of simple shapes, without any file.
std::vector<ZoneScene> simpleZoneScenes();

/// What comparing a set with exact geometry gave.
struct ZoneReport {
  std::string name;
  std::size_t entries = 0;    ///< Most of all places.
  std::uint32_t groups = 0;   ///< Most of all places.
  double least_radius = 1e9;  ///< Smallest kept, metres.
  double cold_ms = 0.0;       ///< Slowest query.
  double median_ms = 0.0;
  std::size_t pieces_moving = 0, pieces_environment = 0;
  bool complete = true;
  std::string places;         ///< Per place: entries/groups/radius in mm/ms.
  int free = 0, blocked = 0;  ///< Sampled places by exact geometry.
  int holes = 0;              ///< Translations: colliding but called free.
  double hole_depth = 0.0;    ///< Largest clearance claimed there, metres.
  int false_walls = 0;        ///< Translations: free but called blocked.
  double wall_depth = 0.0;    ///< Largest penetration claimed there, metres.
  int turned = 0;             ///< Translations with a rotation that were tried.
  int turned_holes = 0;
  double turned_hole_depth = 0.0;
  int turned_walls = 0;
};

/// One scene, prepared.
class ZoneBench {
 public:
  using Ways = collision::ContactFinder::Ways;
  enum class Cutting { kWhole, kOnDemand };
  explicit ZoneBench(ZoneScene scene, Ways ways = Ways::kFacets, Cutting cutting = Cutting::kWhole);
  /// Tries `count` random translations a place, and as many with a rotation of up to `rotation` rad (scaled down with
  /// the zone), against exact intersection. Fixed seed.
  ZoneReport compare(int count, double rotation);
  /// The query at a place.
  collision::ZoneContacts query(const Pose& X_WM);
  /// Exact: distance (m), 0 when colliding.
  collision::DistanceResult exact(const Pose& X_WM);
  const ZoneScene& scene() const { return scene_; }

 private:
  ZoneScene scene_;
  std::shared_ptr<const collision::ConvexPieces> moving_, environment_;
  collision::ProximityQuery proximity_;
  std::shared_ptr<const collision::SurfaceModel> moving_model_, environment_model_;  ///< Null for facets.
  collision::ContactFinder contacts_;
  double margin_ = 2e-6;  ///< m: of what surfaces and facets differ by.
};

/// min over groups of max over entries of the linearised gap after a motion of the moving part about X_WM.p.
double claimedClearance(const collision::ZoneContacts& set, const Pose& X_WM, const Twist& motion_W);

/// One line for the table of figures.
std::string line(const ZoneReport& report);

}  // namespace hapticell::test
