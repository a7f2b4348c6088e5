// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/mesh_collider.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

#include "collision/trees/tree_cache.h"
#include "collision/trees/triangle_census.h"
#include "geometry/system/assertion.h"

namespace hapticell::collision {

namespace {

/// The mesh with the triangles that are not kept shrunk to a point of the others; nothing where all are kept.
std::optional<geometry::TriangleMesh> soundMesh(const geometry::TriangleMesh& mesh,
                                                const std::vector<std::uint32_t>& kept) {
  if (kept.size() == mesh.triangles.size()) return std::nullopt;
  if (kept.empty()) return geometry::TriangleMesh{};
  geometry::TriangleMesh sound = mesh;
  const std::uint32_t somewhere = mesh.triangles[kept.front()][0];
  std::vector<bool> is_kept(mesh.triangles.size(), false);
  for (const std::uint32_t t : kept) is_kept[t] = true;
  for (std::size_t t = 0; t < is_kept.size(); ++t) {
    if (!is_kept[t]) sound.triangles[t] = {somewhere, somewhere, somewhere};
  }
  for (dvec3& vertex : sound.vertices) {
    if (!std::isfinite(vertex.x + vertex.y + vertex.z)) vertex = mesh.vertices[somewhere];
  }
  return sound;
}

BoxTree treeOf(const geometry::TriangleMesh& mesh, std::vector<std::uint32_t> triangles, const ColliderBuild& how) {
  const TreeCache cache(how.cache_folder);
  const ContentHash hash = how.cache_folder.empty() ? ContentHash{} : contentHash(mesh);
  if (auto kept = cache.load(mesh, hash)) {
    if (how.progress != nullptr) how.progress->triangles_done += triangles.size();
    return std::move(*kept);
  }
  BuildControl control;
  // Asked once: each time reads a file of the system, and a cell has thousands of small parts.
  static const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  control.threads = how.threads != 0 ? how.threads : cores;
  if (how.progress != nullptr) {
    control.done = &how.progress->triangles_done;
    control.cancelled = &how.progress->cancelled;
  }
  BoxTree tree(mesh, std::move(triangles), control);
  if (!tree.isEmpty()) cache.store(tree, hash);
  return tree;
}

}  // namespace

std::shared_ptr<const MeshCollider> MeshCollider::build(const geometry::TriangleMesh& mesh, const ColliderBuild& how) {
  for (const geometry::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) HAPTICELL_DEMAND(vertex < mesh.vertices.size());
  }
  std::shared_ptr<MeshCollider> collider(new MeshCollider);
  collider->mesh_ = shareVertices(mesh);
  collider->mesh_.vertices.shrink_to_fit();
  collider->mesh_.triangles.shrink_to_fit();
  CountedTriangles counted = countTriangles(collider->mesh_);
  collider->census_ = counted.census;
  collider->measure(counted.kept);
  const auto pieces = [&collider, pieces_of = soundMesh(collider->mesh_, counted.kept)] {
    collider->shells_ = Shells(pieces_of ? *pieces_of : collider->mesh_);
  };
  if (how.threads == 1) {
    pieces();
    collider->tree_ = treeOf(collider->mesh_, std::move(counted.kept), how);
  } else {
    std::thread aside(pieces);
    collider->tree_ = treeOf(collider->mesh_, std::move(counted.kept), how);
    aside.join();
  }
  if (how.progress != nullptr && how.progress->cancelled) return nullptr;
  return collider;
}

void MeshCollider::measure(const std::vector<std::uint32_t>& triangles) {
  for (const std::uint32_t t : triangles) {
    for (int i = 0; i < 3; ++i) bounds_.add(mesh_.corner(t, i));
  }
  if (triangles.empty()) return;
  center_ = bounds_.center();
  for (const std::uint32_t t : triangles) {
    for (int i = 0; i < 3; ++i) radius_ = std::max(radius_, glm::distance(mesh_.corner(t, i), center_));
  }
}

std::size_t MeshCollider::memory() const {
  return sizeof(*this) + mesh_.vertices.capacity() * sizeof(dvec3) +
         mesh_.triangles.capacity() * sizeof(geometry::Triangle) + tree_.memory() + shells_.memory();
}

bool MeshCollider::contains(const dvec3& p_MQ) const {
  return isInside(shells_, tree_, mesh_, p_MQ);
}

}  // namespace hapticell::collision
