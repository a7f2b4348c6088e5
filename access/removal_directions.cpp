// SPDX-License-Identifier: Apache-2.0
#include "access/removal_directions.h"

#include <algorithm>
#include <cmath>

#include "access/ordered.h"
#include "collision/queries/proximity_query.h"
#include "collision/surfaces/surface_model.h"

namespace hapticell::access {

namespace {

using collision::SurfaceRegion;
using collision::SurfaceType;

/// Cosine of directions that count as one: 1 deg. Half: more of the same are tried; twice: fits of 2 mm in 60 mm may
/// be missed.
constexpr double kSame = 0.99985;
constexpr std::size_t kMost = 60;  ///< Half: bores of rich castings are missed; twice: twice the time.
/// m: neighbours nearer than this guide the part. Half: loose fits do not; twice: more directions to try.
constexpr double kNear = 2e-3;
constexpr std::size_t kMostAxes = 6;  ///< Of the surfaces of one part, the largest first. Half and twice: as kMost.

class Directions {
 public:
  void addBoth(const dvec3& axis) {
    const double length = glm::length(axis);
    if (!(length > 1e-9)) return;  // Not a number neither: a mesh may have corners without a normal.
    add(axis / length);
    add(-axis / length);
  }
  std::vector<dvec3> all;

 private:
  void add(const dvec3& direction) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const dvec3& one) { return glm::dot(one, direction) > kSame; });
    if (!known && all.size() < kMost) all.push_back(direction);
  }
};

/// The axes of the largest surfaces that could guide it; `near` limits them to those about that place.
void addSurfaces(const RemovalUnit::Part& part, Directions& directions) {
  if (!part.part->mesh.surfaces) return;
  std::vector<const SurfaceRegion*> regions;
  for (const SurfaceRegion& region : part.part->mesh.surfaces->surface().regions) {
    const SurfaceType type = region.shape.type;
    if (type == SurfaceType::kPlane || type == SurfaceType::kCylinder || type == SurfaceType::kCone)
      regions.push_back(&region);
  }
  std::stable_sort(regions.begin(), regions.end(), [](const auto* a, const auto* b) { return a->area > b->area; });
  std::vector<dvec3> axes;
  for (const SurfaceRegion* region : regions) {
    const dvec3 axis = part.X_WP.rotate(region->shape.axis_M);
    const bool known = std::any_of(axes.begin(), axes.end(),
                                   [&](const dvec3& one) { return std::abs(glm::dot(one, axis)) > kSame; });
    if (!known) axes.push_back(axis);
    if (axes.size() == kMostAxes) break;
  }
  for (const dvec3& axis : axes) directions.addBoth(axis);
}

void addNeighbours(const RemovalScene& scene, const RemovalUnit& unit, Directions& directions) {
  for (const RemovalUnit& other : scene.units()) {
    if (&other == &unit) continue;
    for (const RemovalUnit::Part& a : unit.parts) {
      for (const RemovalUnit::Part& b : other.parts) {
        if (!scene.areChecked(a, b)) continue;
        const auto found = collision::distance(a.part->mesh.collider, a.X_WP, b.part->mesh.collider, b.X_WP, kNear);
        if (found.beyond_limit) continue;
        directions.addBoth(found.nhat_BA_W);
        addSurfaces(b, directions);
      }
    }
  }
}

}  // namespace

std::vector<dvec3> removalDirections(const RemovalScene& scene, std::size_t unit) {
  const RemovalUnit& own = scene.units()[unit];
  Directions directions;
  for (int i = 0; i < 3; ++i) {
    dvec3 axis(0.0);
    axis[i] = 1.0;
    directions.addBoth(axis);
  }
  for (const RemovalUnit::Part& part : own.parts) {
    const dmat3 R = part.X_WP.R();
    for (int i = 0; i < 3; ++i) directions.addBoth(R[i]);
    addSurfaces(part, directions);
  }
  addNeighbours(scene, own, directions);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x * x + y * y + z * z > 1) directions.addBoth(dvec3(x, y, z));
  // By micrometres of way.
  return ordered(std::move(directions.all),
                 [&](const dvec3& direction) { return std::lround(1e6 * scene.wayOut(unit, direction)); });
}

}  // namespace hapticell::access
