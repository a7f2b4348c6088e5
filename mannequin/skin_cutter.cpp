// SPDX-License-Identifier: Apache-2.0
#include "mannequin/skin_cutter.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hapticell::mannequin {

namespace {

std::size_t nearestOf(const GroupDistances& distances) {
  return static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
}

/// Cuts a mesh into its colours where two of them are equally near.
class Cutter {
 public:
  Cutter(const geometry::TriangleMesh& mesh, const std::vector<GroupDistances>& distances)
      : mesh_(mesh), distances_(distances), parts_(kMostGroups) {}

  std::vector<geometry::TriangleMesh> cut() {
    for (const geometry::Triangle& triangle : mesh_.triangles) add(triangle);
    return std::move(parts_);
  }

 private:
  /// A corner of the mesh (`b` as `a`), or the place between two where both
  /// colours are equally near.
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  using Corners = std::array<Key, 3>;
  static Key at(std::uint32_t vertex) { return {vertex, vertex}; }

  void add(const geometry::Triangle& t) {
    std::array<std::size_t, 3> own{};
    for (std::size_t i = 0; i < 3; ++i) own[i] = nearestOf(distances_[t[i]]);
    if (own[0] == own[1] && own[1] == own[2]) return take(own[0], Corners{at(t[0]), at(t[1]), at(t[2])});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (own[j] != own[k] || own[i] == own[j]) continue;  // i stands alone.
      const Key ij = between(t[i], t[j]), ik = between(t[i], t[k]);
      take(own[i], Corners{at(t[i]), ij, ik});
      take(own[j], Corners{ij, at(t[j]), at(t[k])});
      take(own[j], Corners{ij, at(t[k]), ik});
      return;
    }
    centres_.push_back((mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]) / 3.0);
    const Key centre = at(static_cast<std::uint32_t>(mesh_.vertices.size() + centres_.size() - 1));
    for (std::size_t i = 0; i < 3; ++i) {  // Three colours meet: each corner keeps what is about it.
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      take(own[i], Corners{at(t[i]), between(t[i], t[j]), centre});
      take(own[i], Corners{at(t[i]), centre, between(t[i], t[k])});
    }
  }

  static Key between(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

  void take(std::size_t group, const Corners& corners) {
    geometry::TriangleMesh& part = parts_[group];
    geometry::Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [known, is_new] =
          known_[group].try_emplace(corners[i], static_cast<std::uint32_t>(part.vertices.size()));
      if (is_new) part.vertices.push_back(placeOf(corners[i]));
      triangle[i] = known->second;
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      part.triangles.push_back(triangle);
  }

  dvec3 placeOf(const Key& corner) const {
    const auto [a, b] = corner;
    if (a >= mesh_.vertices.size()) return centres_[a - mesh_.vertices.size()];
    if (a == b) return mesh_.vertices[a];
    const std::size_t of_a = nearestOf(distances_[a]), of_b = nearestOf(distances_[b]);
    const double at_a = distances_[a][of_a] - distances_[a][of_b], at_b = distances_[b][of_a] - distances_[b][of_b];
    const double t = at_b - at_a > 1e-12 ? std::clamp(-at_a / (at_b - at_a), 0.02, 0.98) : 0.5;
    return mesh_.vertices[a] + t * (mesh_.vertices[b] - mesh_.vertices[a]);
  }

  const geometry::TriangleMesh& mesh_;
  const std::vector<GroupDistances>& distances_;
  std::vector<geometry::TriangleMesh> parts_;
  std::vector<dvec3> centres_;  ///< Of triangles in which three colours meet.
  std::array<std::map<Key, std::uint32_t>, kMostGroups> known_;
};

}  // namespace

std::vector<geometry::TriangleMesh> cutByGroups(const geometry::TriangleMesh& mesh,
                                                const std::vector<GroupDistances>& distances) {
  return Cutter(mesh, distances).cut();
}

}  // namespace hapticell::mannequin
