// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/viewport/scene/scene_model.h"
#include "collision/queries/distance_result.h"
#include "collision/trees/mesh_collider.h"

namespace hapticell::app {

/// A mesh at its present pose.
struct PlacedMesh {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  Pose X_WM;
};

/// The meshes of an entity as the scene shows it now.
std::vector<PlacedMesh> placedMeshes(const SceneModel& scene, workcell::EntityId entity);

/// Search trees of meshes measured before, which make later measurements quick. One thread at a time.
using ColliderCache =
    std::map<std::shared_ptr<const geometry::TriangleMesh>, std::shared_ptr<const collision::MeshCollider>>;

/// The exact smallest distance of two parts; empty if one has no mesh or `cancelled` returns true. Builds the trees
/// that `cache` lacks, so call it in a separate thread.
std::optional<collision::DistanceResult> partDistance(const std::vector<PlacedMesh>& a,
                                                      const std::vector<PlacedMesh>& b, ColliderCache& cache,
                                                      const std::function<bool()>& cancelled = {});

}  // namespace hapticell::app
