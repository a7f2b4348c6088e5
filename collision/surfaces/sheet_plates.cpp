// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "collision/surfaces/mesh_facing.h"
#include "geometry/shapes/vertex_merge.h"

namespace hapticell::collision {

namespace {

/// m: a sheet is felt as a plate of at least kSkin (0.02 mm). Half: the proxy sees both sides within its tolerances;
/// twice: it is drawn entered by 0.02 mm.
constexpr double kThinnest = 20e-6;
/// Of the size. Five times what convex pieces are distinguished by. Half: some pieces of both sides merge; twice: a
/// sheet of 1 m is 0.1 mm thick.
constexpr double kThicknessOfSize = 5e-5;
/// Times half of the thickness, where a sheet is bent sharply: a fold of 29 deg inside. Half: thinner at folds under 60
/// deg; twice: spikes at sharp ones.
constexpr double kLongestMitre = 4.0;
/// Of the trace: the mean normal decides what the faces leave open, to 1e-9. Far above rounding (1e-15), far below a
/// face's part in a corner (1e-3). Half and twice as well.
constexpr double kDamping = 1e-9;

/// Makes plates of sheets, one corner of the welded sheet after the other.
class PlateMaker {
 public:
  PlateMaker(const MeshFacing& facing, double half) : facing_(facing), half_(half) {
    stands_for_ = geometry::mergedVertices(facing.mesh.vertices, geometry::weldTolerance(facing.mesh));
  }

  geometry::TriangleMesh run() {
    const auto& triangles = facing_.mesh.triangles;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) note(t);
    result_.vertices = facing_.mesh.vertices;
    for (auto& [who, corner] : corners_) place(who.second, corner);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      if (facing_.sheet_of[t] == MeshFacing::kNone) result_.triangles.push_back(triangles[t]);
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t) addSides(t);
    for (const auto& [edge, turns] : edges_) addWall(edge, turns);
    return std::move(result_);
  }

 private:
  struct Corner {
    dmat3 squares{0.0};
    dvec3 sum{0.0};
    std::uint32_t front = 0, back = 0;
  };
  using Key = std::pair<std::uint32_t, std::uint32_t>;  ///< Sheet, vertex.
  using EdgeKey = std::pair<Key, std::uint32_t>;        ///< Sheet and lower vertex, higher vertex.

  void note(std::uint32_t t) {
    const std::uint32_t sheet = facing_.sheet_of[t];
    if (sheet == MeshFacing::kNone) return;
    const auto [a, b, c] = facing_.mesh.corners(t);
    const dvec3 normal = glm::cross(b - a, c - a);
    const double size = glm::length(normal);
    if (size <= 0.0) return;
    const dvec3 n = normal / size;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = at(t, k), w = at(t, (k + 1) % 3);
      Corner& corner = corners_[{sheet, v}];
      corner.squares += glm::outerProduct(n, n);
      corner.sum += n;
      edges_[{{sheet, std::min(v, w)}, std::max(v, w)}] += v < w ? 1 : -1;
    }
  }

  /// Half the thickness off every triangle that meets here, by least squares: exact where up to three planes do.
  void place(std::uint32_t vertex, Corner& corner) {
    const double trace = corner.squares[0][0] + corner.squares[1][1] + corner.squares[2][2];
    const dvec3 mean = glm::length(corner.sum) > 0.0 ? glm::normalize(corner.sum) : dvec3(0, 0, 1);
    // The damping pulls towards the mean normal, which is the whole answer on a flat sheet.
    const dmat3 damped = corner.squares + kDamping * trace * dmat3(1.0);
    dvec3 off = glm::inverse(damped) * (half_ * (corner.sum + kDamping * trace * mean));
    const double length = glm::length(off);
    if (!(length > 0.0)) off = half_ * mean;
    if (length > kLongestMitre * half_) off *= kLongestMitre * half_ / length;
    corner.front = add(facing_.mesh.vertices[vertex] + off);
    corner.back = add(facing_.mesh.vertices[vertex] - off);
  }

  void addSides(std::uint32_t t) {
    const std::uint32_t sheet = facing_.sheet_of[t];
    if (sheet == MeshFacing::kNone) return;
    std::array<const Corner*, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = corners_.find({sheet, at(t, k)});
      if (found == corners_.end()) return;  // No area, and beside nothing that has.
      corner[k] = &found->second;
    }
    result_.triangles.push_back({corner[0]->front, corner[1]->front, corner[2]->front});
    result_.triangles.push_back({corner[0]->back, corner[2]->back, corner[1]->back});
  }

  /// Along what is no border the triangles of both sides cancel.
  void addWall(const EdgeKey& edge, int turns) {
    if (turns == 0) return;
    const auto& [first, high] = edge;
    const Corner* from = &corners_[first];
    const Corner* to = &corners_[{first.first, high}];
    if (turns < 0) std::swap(from, to);
    result_.triangles.push_back({from->front, from->back, to->back});
    result_.triangles.push_back({from->front, to->back, to->front});
  }

  std::uint32_t at(std::uint32_t t, std::size_t k) const { return stands_for_[facing_.mesh.triangles[t][k]]; }
  std::uint32_t add(const dvec3& p) {
    result_.vertices.push_back(p);
    return static_cast<std::uint32_t>(result_.vertices.size() - 1);
  }

  const MeshFacing& facing_;
  const double half_;
  std::vector<std::uint32_t> stands_for_;
  std::map<Key, Corner> corners_;
  std::map<EdgeKey, int> edges_;
  geometry::TriangleMesh result_;
};

}  // namespace

geometry::TriangleMesh withSheetsAsPlates(const MeshFacing& facing, double thickness) {
  if (facing.sheets == 0) return facing.mesh;
  const double size = glm::length(facing.mesh.bounds().size());
  const double wanted = thickness > 0.0 ? thickness : std::max(kThinnest, kThicknessOfSize * size);
  return PlateMaker(facing, 0.5 * wanted).run();
}

}  // namespace hapticell::collision
