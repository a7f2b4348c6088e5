// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/hollows.h"

#include <limits>
#include <numeric>

namespace hapticell::geometry {

namespace {

/// Which surface each vertex belongs to, by one of its vertices.
class Surfaces {
 public:
  explicit Surfaces(const TriangleMesh& mesh) : parent_(mesh.vertices.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (const Triangle& t : mesh.triangles) {
      parent_[of(t[0])] = of(t[1]);
      parent_[of(t[1])] = of(t[2]);
    }
  }
  std::uint32_t of(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

TriangleMesh withoutHollows(const TriangleMesh& mesh) {
  Surfaces surfaces(mesh);
  std::vector<double> volumes(mesh.vertices.size(), 0.0);  // m^3, times six.
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    volumes[surfaces.of(mesh.triangles[t][0])] +=
        glm::dot(mesh.corner(t, 0), glm::cross(mesh.corner(t, 1), mesh.corner(t, 2)));
  }
  constexpr auto kDropped = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.vertices.size(), kDropped);
  TriangleMesh result;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (volumes[surfaces.of(v)] < 0.0) continue;
    place[v] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    if (place[t[0]] != kDropped) result.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
  }
  return result;
}

}  // namespace hapticell::geometry
