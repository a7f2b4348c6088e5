// SPDX-License-Identifier: Apache-2.0
#include "agents/body/line_of_sight.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/mesh_search.h"
#include "geometry/shapes/bounds.h"

namespace hapticell::agents {

bool LineOfSight::isFree(const dvec3& p_WFrom, const dvec3& p_WTo) const {
  return std::all_of(obstacles_.begin(), obstacles_.end(), [&](const Clearances::Obstacle& one) {
    if (one.entity == ignored_) return true;
    const Pose X_OW = one.X_WO.inverse();
    const collision::RayHit hit = collision::castRay(*one.collider, X_OW * p_WFrom, X_OW.rotate(p_WTo - p_WFrom));
    return !hit.found || hit.along >= 1.0;
  });
}

bool LineOfSight::isFreeFor(double radius, const dvec3& p_WFrom, const dvec3& p_WTo) const {
  if (!isFree(p_WFrom, p_WTo)) return false;
  const double length = glm::length(p_WTo - p_WFrom);
  const int places = static_cast<int>(std::ceil(length / (0.5 * radius)));
  for (const Clearances::Obstacle& one : obstacles_) {
    if (one.entity == ignored_) continue;
    const Pose X_OW = one.X_WO.inverse();
    const dvec3 p_OFrom = X_OW * p_WFrom, p_OTo = X_OW * p_WTo;
    for (int i = 1; i <= places; ++i) {
      const dvec3 p_O = p_OFrom + (static_cast<double>(i) / places) * (p_OTo - p_OFrom);
      if (collision::nearestPoint(*one.collider, p_O, radius).found) return false;
    }
  }
  return true;
}

std::optional<dvec3> LineOfSight::middleOf(workcell::EntityId entity) const {
  geometry::Bounds bounds;
  for (const Clearances::Obstacle& one : obstacles_) {
    if (one.entity == entity) bounds.add(geometry::transformed(one.X_WO, one.collider->bounds()));
  }
  if (bounds.isEmpty()) return std::nullopt;
  return bounds.center();
}

}  // namespace hapticell::agents
