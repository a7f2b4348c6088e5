// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hapticell::collision {
namespace {

/// Cosine, 26 deg: a facet that is seen edge-on does not belong to the plane, though its corners are within tolerance.
/// Half (63 deg): slivers of steep faces join; nearer to 1: noisy slivers stay single.
constexpr double kSameWay = 0.9;

struct EdgeUse {
  std::uint64_t key;
  std::uint32_t user;  ///< 3 * triangle + k.
  bool operator<(const EdgeUse& other) const { return key != other.key ? key < other.key : user < other.user; }
};

void dropFlat(geometry::TriangleMesh& mesh, double size) {
  std::vector<geometry::Triangle> kept;
  kept.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (areaOf(mesh, i) > 0.5e-14 * size * size) kept.push_back(mesh.triangles[i]);
  }
  mesh.triangles = std::move(kept);
}

void connect(RecognisedSurface& surface) {
  const auto& triangles = surface.mesh.triangles;
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[i][k], triangles[i][(k + 1) % 3]);
      uses.push_back({(std::uint64_t{low} << 32) | high, 3 * i + k});
    }
  }
  std::sort(uses.begin(), uses.end());
  surface.neighbour.assign(triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
  surface.closed = !triangles.empty();
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i;
    while (end < uses.size() && uses[end].key == uses[i].key) ++end;
    const auto a = uses[i].user, b = uses[end - 1].user;
    const bool opposite = triangles[a / 3][a % 3] != triangles[b / 3][b % 3];
    if (end - i == 2 && opposite) {
      surface.neighbour[a / 3][a % 3] = b / 3;
      surface.neighbour[b / 3][b % 3] = a / 3;
    } else {
      surface.closed = false;
    }
    i = end;
  }
}

void label(RecognisedSurface& surface) {
  std::vector<std::uint32_t> parent(surface.mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : surface.mesh.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::vector<std::uint32_t> name(parent.size(), kNoIndex);
  surface.component.resize(surface.mesh.triangles.size());
  for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i) {
    auto& own = name[root(surface.mesh.triangles[i][0])];
    if (own == kNoIndex) own = surface.components++;
    surface.component[i] = own;
  }
}

}  // namespace

double areaOf(const geometry::TriangleMesh& mesh, std::uint32_t t) {
  const dvec3 a = mesh.corner(t, 0);
  return 0.5 * glm::length(glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a));
}

dvec3 middleOf(const geometry::TriangleMesh& mesh, std::uint32_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
}

RecognisedSurface connectedSurface(const geometry::TriangleMesh& mesh) {
  RecognisedSurface surface;
  surface.mesh = mesh;
  const geometry::Bounds box = mesh.bounds();
  const double size = mesh.triangles.empty() ? 0.0 : glm::length(box.size());
  geometry::weld(surface.mesh, std::max(1e-12, geometry::weldTolerance(mesh)));
  dropFlat(surface.mesh, size);
  connect(surface);
  label(surface);
  surface.normals.reserve(surface.mesh.triangles.size());
  for (std::uint32_t i = 0; i < surface.mesh.triangles.size(); ++i) {
    const dvec3 a = surface.mesh.corner(i, 0);
    surface.normals.push_back(glm::normalize(glm::cross(surface.mesh.corner(i, 1) - a, surface.mesh.corner(i, 2) - a)));
  }
  return surface;
}

PlanarClusters planarClusters(const RecognisedSurface& surface, double tolerance) {
  const auto& mesh = surface.mesh;
  const std::size_t count = mesh.triangles.size();
  std::vector<double> area(count);
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i) area[i] = areaOf(mesh, i);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return area[a] > area[b]; });
  PlanarClusters result;
  result.cluster_of.assign(count, kNoIndex);
  for (const auto first : order) {
    if (result.cluster_of[first] != kNoIndex) continue;
    const auto name = static_cast<std::uint32_t>(result.triangles.size());
    const dvec3 n = surface.normals[first], origin = middleOf(mesh, first);
    std::vector<std::uint32_t> members{first};
    result.cluster_of[first] = name;
    double sum = 0.0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      sum += area[members[i]];
      for (const auto other : surface.neighbour[members[i]]) {
        if (other == kNoIndex || result.cluster_of[other] != kNoIndex) continue;
        if (glm::dot(n, surface.normals[other]) < kSameWay) continue;
        bool flat = true;
        for (int k = 0; k < 3; ++k) flat = flat && std::abs(glm::dot(n, mesh.corner(other, k) - origin)) <= tolerance;
        if (!flat) continue;
        result.cluster_of[other] = name;
        members.push_back(other);
      }
    }
    result.triangles.push_back(std::move(members));
    result.areas.push_back(sum);
  }
  return result;
}

}  // namespace hapticell::collision
