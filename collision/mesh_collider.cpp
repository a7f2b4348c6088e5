// SPDX-License-Identifier: Apache-2.0
#include "collision/mesh_collider.h"

#include <algorithm>
#include <numeric>

#include "geometry/assertion.h"

namespace hapticell::collision {

std::shared_ptr<const MeshCollider> MeshCollider::build(const geometry::TriangleMesh& mesh) {
  for (const geometry::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) HAPTICELL_DEMAND(vertex < mesh.vertices.size());
  }
  std::shared_ptr<MeshCollider> collider(new MeshCollider);
  collider->mesh_ = mesh;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) collider->bounds_.add(mesh.corner(t, i));
  }
  if (!collider->isEmpty()) collider->center_ = collider->bounds_.center();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      collider->radius_ = std::max(collider->radius_, glm::distance(mesh.corner(t, i), collider->center_));
    }
  }
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  collider->tree_ = BoxTree(mesh, std::move(all));
  collider->shells_ = Shells(mesh);
  return collider;
}

std::size_t MeshCollider::memory() const {
  return sizeof(*this) + mesh_.vertices.capacity() * sizeof(dvec3) +
         mesh_.triangles.capacity() * sizeof(geometry::Triangle) + tree_.memory() + shells_.memory();
}

bool MeshCollider::contains(const dvec3& p_MQ) const {
  return isInside(shells_, tree_, mesh_, p_MQ);
}

}  // namespace hapticell::collision
