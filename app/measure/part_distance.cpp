// SPDX-License-Identifier: Apache-2.0
#include "app/measure/part_distance.h"

#include <limits>

#include "collision/queries/proximity_query.h"

namespace hapticell::app {

std::vector<PlacedMesh> placedMeshes(const SceneModel& scene, workcell::EntityId entity) {
  std::vector<PlacedMesh> meshes;
  for (const RenderItem& item : scene.items({}))
    if (item.entity == entity && item.ghost == Ghost::kNone && item.mesh && !item.mesh->triangles.empty())
      meshes.push_back({item.mesh, item.X_WM});
  return meshes;
}

std::optional<collision::DistanceResult> partDistance(const std::vector<PlacedMesh>& a,
                                                      const std::vector<PlacedMesh>& b, ColliderCache& cache,
                                                      const std::function<bool()>& cancelled) {
  const auto colliderOf = [&](const PlacedMesh& placed) {
    auto& collider = cache[placed.mesh];
    if (!collider) collider = collision::MeshCollider::build(*placed.mesh);
    return collider;
  };
  std::optional<collision::DistanceResult> least;
  for (const PlacedMesh& one : a)
    for (const PlacedMesh& other : b) {
      if (cancelled && cancelled()) return std::nullopt;
      collision::ProximityQuery query(colliderOf(one), colliderOf(other));
      const double limit = least ? least->distance : std::numeric_limits<double>::infinity();
      const auto found = query.distance(one.X_WM, other.X_WM, limit);
      if (!least || (!found.beyond_limit && found.distance < least->distance)) least = found;
      if (least->colliding) return least;
    }
  return least;
}

}  // namespace hapticell::app
