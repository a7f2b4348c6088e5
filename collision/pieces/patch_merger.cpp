// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/patch_merger.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "collision/pieces/convex_hull.h"
#include "collision/queries/mesh_search.h"

namespace hapticell::collision {
namespace {

/// Of one merged patch: pairs of larger ones have many directions (kFewVertices). Half: round bodies are more pieces;
/// twice: slower pairs, fewer of them.
constexpr std::size_t kMostVertices = 150;
/// Passes over all edges; most merge in the first, and what failed may fit a grown one. Half: more pieces; twice:
/// nothing more is found, as it ends when nothing changes.
constexpr int kPasses = 3;
/// Cosine: 2.6 deg, within which a triangle is on a face of the hull if its corners are too. Half of it: noisy faces
/// are not real ones; twice: flat chamfers may be.
constexpr double kSameFace = 0.999;

struct MergeEdge {
  std::uint32_t triangle_a = 0, triangle_b = 0;
  bool flat = false;
  double cosine = 1.0;
  double length = 0.0;
};

/// What is known of a growing patch.
struct Growing {
  Patch patch;
  std::vector<HullPlane> faces;  ///< Planes of its triangles, equal ones once.
  geometry::Bounds bounds;
  double area = 0.0;
};

/// Of the front rim of a prism (convexPrism), its first vertices.
double rimArea(const ConvexHull& prism) {
  dvec3 sum(0.0);
  const std::size_t count = prism.vertices.size() / 2;
  for (std::size_t i = 2; i < count; ++i) {
    sum += glm::cross(prism.vertices[i - 1] - prism.vertices[0], prism.vertices[i] - prism.vertices[0]);
  }
  return 0.5 * glm::length(sum);
}

/// What of a triangle lies behind all planes, each moved inwards by `depth`, is more than nothing.
bool reachesInside(const ConvexHull& hull, const std::array<dvec3, 3>& corners, double depth) {
  // Most triangles lie beyond one plane, and are done without being cut.
  for (const HullPlane& plane : hull.planes) {
    const double limit = plane.offset - depth;
    if (glm::dot(plane.nhat, corners[0]) >= limit && glm::dot(plane.nhat, corners[1]) >= limit &&
        glm::dot(plane.nhat, corners[2]) >= limit) {
      return false;
    }
  }
  std::vector<dvec3> polygon(corners.begin(), corners.end());
  std::vector<dvec3> kept;
  for (const HullPlane& plane : hull.planes) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const dvec3& p = polygon[i];
      const dvec3& q = polygon[(i + 1) % polygon.size()];
      const double above_p = glm::dot(plane.nhat, p) - plane.offset + depth;
      const double above_q = glm::dot(plane.nhat, q) - plane.offset + depth;
      if (above_p < 0.0) kept.push_back(p);
      if ((above_p < 0.0) != (above_q < 0.0)) kept.push_back(p + above_p / (above_p - above_q) * (q - p));
    }
    std::swap(polygon, kept);
    if (polygon.empty()) return false;
  }
  return true;
}

class PatchMerger {
 public:
  PatchMerger(const SurfaceGraph& graph, const MeshCollider& collider);
  std::vector<Patch> run(const Patch& component);

 private:
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  std::vector<MergeEdge> edges() const;
  bool isBehind(const Growing& faces, const Growing& points) const;
  bool isHollow(const ConvexHull& hull, std::uint32_t a, std::uint32_t b);
  bool merge(std::uint32_t a, std::uint32_t b);

  bool isMember(std::uint32_t triangle) const {
    return place_[triangle] < component_.size() && component_[place_[triangle]] == triangle;
  }
  Growing& growing(std::uint32_t triangle) { return growing_[place_[triangle]]; }
  void start(const Patch& component);

  const SurfaceGraph& graph_;
  const MeshCollider& collider_;
  std::vector<std::uint32_t> component_;
  std::vector<std::uint32_t> parent_;  // by triangle of the graph
  std::vector<std::uint32_t> place_;   // of a triangle in the component, by triangle of the graph
  std::vector<Growing> growing_;       // by place
  std::vector<std::uint32_t> near_;
};

PatchMerger::PatchMerger(const SurfaceGraph& graph, const MeshCollider& collider) : graph_(graph), collider_(collider) {
  parent_.resize(graph.mesh().triangles.size());
  std::iota(parent_.begin(), parent_.end(), 0u);
  place_.resize(parent_.size());
}

void PatchMerger::start(const Patch& component) {
  component_ = component.triangles;
  growing_.clear();
  growing_.resize(component_.size());
  for (std::uint32_t i = 0; i < component_.size(); ++i) {
    const std::uint32_t triangle = component_[i];
    place_[triangle] = i;
    Growing& growing = growing_[i];
    growing.patch = graph_.patchOf({triangle});
    growing.faces = {{graph_.normal(triangle), glm::dot(graph_.normal(triangle), graph_.mesh().corner(triangle, 0))}};
    growing.area = graph_.area(triangle);
    for (int k = 0; k < 3; ++k) growing.bounds.add(graph_.mesh().corner(triangle, k));
  }
}

std::vector<MergeEdge> PatchMerger::edges() const {
  std::vector<MergeEdge> result;
  for (const auto triangle : component_) {
    for (int k = 0; k < 3; ++k) {
      const auto other = graph_.neighbour(triangle, k);
      if (other == SurfaceGraph::kNone || other < triangle || !isMember(other)) continue;
      if (!graph_.isConvexAcross(triangle, k)) continue;
      MergeEdge edge{triangle, other, false, glm::dot(graph_.normal(triangle), graph_.normal(other)), 0.0};
      edge.flat = graph_.isFlat(graph_.patchOf({triangle, other}));
      edge.length = glm::length(graph_.mesh().corner(triangle, k) - graph_.mesh().corner(triangle, (k + 1) % 3));
      result.push_back(edge);
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const MergeEdge& a, const MergeEdge& b) {
    if (a.flat != b.flat) return a.flat;
    if (!a.flat && std::abs(a.cosine - b.cosine) > 1e-3) return a.cosine < b.cosine;
    return a.length > b.length;
  });
  return result;
}

bool PatchMerger::isBehind(const Growing& faces, const Growing& points) const {
  return std::all_of(faces.faces.begin(), faces.faces.end(), [&](const HullPlane& plane) {
    return std::all_of(points.patch.vertices.begin(), points.patch.vertices.end(), [&](auto vertex) {
      return glm::dot(plane.nhat, graph_.mesh().vertices[vertex]) <= plane.offset + graph_.tolerance();
    });
  });
}

bool PatchMerger::isHollow(const ConvexHull& hull, std::uint32_t a, std::uint32_t b) {
  near_.clear();
  trianglesWithin(collider_, geometry::boundsOf(hull.vertices), 0.0, near_);
  return std::none_of(near_.begin(), near_.end(), [&](auto triangle) {
    const auto owner = root(triangle);
    if (owner == a || owner == b) return false;
    const auto& mesh = graph_.mesh();
    return reachesInside(hull, mesh.corners(triangle), graph_.tolerance());
  });
}

bool PatchMerger::merge(std::uint32_t a, std::uint32_t b) {
  Growing& first = growing(a);
  Growing& second = growing(b);
  if (first.patch.vertices.size() + second.patch.vertices.size() > kMostVertices) return false;
  if (!isBehind(first, second) || !isBehind(second, first)) return false;
  Patch both;
  both.triangles = first.patch.triangles;
  both.triangles.insert(both.triangles.end(), second.patch.triangles.begin(), second.patch.triangles.end());
  std::set_union(first.patch.vertices.begin(), first.patch.vertices.end(), second.patch.vertices.begin(),
                 second.patch.vertices.end(), std::back_inserter(both.vertices));
  const auto hull = hullOfPatch(graph_, both);
  if (!hull) return false;
  // A flat patch without a gap covers nothing that its two parts did not.
  const double area = first.area + second.area;
  const bool covered = graph_.isFlat(both) && rimArea(*hull) <= area * (1.0 + 1e-6);
  if (!covered && !isHollow(*hull, a, b)) return false;
  first.patch = std::move(both);
  first.bounds.add(second.bounds);
  first.area = area;
  for (const HullPlane& plane : second.faces) {
    const bool known = std::any_of(first.faces.begin(), first.faces.end(), [&](const HullPlane& other) {
      return glm::dot(other.nhat, plane.nhat) > 1.0 - 1e-12 && std::abs(other.offset - plane.offset) < 1e-9;
    });
    if (!known) first.faces.push_back(plane);
  }
  second = {};
  parent_[b] = a;
  return true;
}

std::vector<Patch> PatchMerger::run(const Patch& component) {
  start(component);
  const std::vector<MergeEdge> all = edges();
  std::set<std::array<std::size_t, 4>> failed;
  for (int pass = 0; pass < kPasses; ++pass) {
    bool changed = false;
    for (const MergeEdge& edge : all) {
      auto a = root(edge.triangle_a);
      auto b = root(edge.triangle_b);
      if (a == b) continue;
      if (growing(a).patch.triangles.size() < growing(b).patch.triangles.size()) std::swap(a, b);
      const std::array<std::size_t, 4> attempt{a, growing(a).patch.triangles.size(), b,
                                               growing(b).patch.triangles.size()};
      if (failed.count(attempt) != 0) continue;
      if (merge(a, b)) {
        changed = true;
      } else {
        failed.insert(attempt);
      }
    }
    if (!changed) break;
  }
  std::vector<Patch> patches;
  for (const auto triangle : component_) {
    if (root(triangle) == triangle) patches.push_back(std::move(growing(triangle).patch));
  }
  return patches;
}

}  // namespace

bool isConvexSurface(const SurfaceGraph& graph, const Patch& patch) {
  const double tolerance = graph.tolerance();
  for (const auto triangle : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (graph.neighbour(triangle, k) != SurfaceGraph::kNone && !graph.isConvexAcross(triangle, k)) return false;
    }
  }
  for (const auto triangle : patch.triangles) {
    const dvec3& nhat = graph.normal(triangle);
    const double offset = glm::dot(nhat, graph.mesh().corner(triangle, 0));
    for (const auto vertex : patch.vertices) {
      if (glm::dot(nhat, graph.mesh().vertices[vertex]) > offset + tolerance) return false;
    }
  }
  return true;
}

std::optional<ConvexHull> hullOfPatch(const SurfaceGraph& graph, const Patch& patch) {
  std::vector<dvec3> points;
  for (const auto vertex : patch.vertices) points.push_back(graph.mesh().vertices[vertex]);
  if (!graph.isFlat(patch)) {
    if (auto hull = convexHull(points, 0.01 * graph.tolerance())) return hull;
    return std::nullopt;
  }
  // A flat patch becomes a thin shell inside the material.
  return convexPrism(points, graph.normal(patch.triangles.front()), 4.0 * graph.tolerance());
}

std::optional<ConvexHull> hullOfConvexSurface(const SurfaceGraph& graph, const Patch& patch) {
  const auto& mesh = graph.mesh();
  ConvexHull hull;
  std::map<std::uint32_t, std::uint32_t> vertex_of;
  for (const auto vertex : patch.vertices) {
    vertex_of[vertex] = static_cast<std::uint32_t>(hull.vertices.size());
    hull.vertices.push_back(mesh.vertices[vertex]);
  }
  std::vector<std::uint32_t> by_area = patch.triangles;
  std::stable_sort(by_area.begin(), by_area.end(), [&](auto a, auto b) { return graph.area(a) > graph.area(b); });
  std::map<std::uint32_t, std::uint32_t> plane_of;
  for (const auto triangle : by_area) {
    std::uint32_t plane = 0;
    for (; plane < hull.planes.size(); ++plane) {
      const HullPlane& known = hull.planes[plane];
      if (glm::dot(known.nhat, graph.normal(triangle)) < kSameFace) continue;
      bool same = true;
      for (int k = 0; k < 3; ++k) {
        same =
            same && std::abs(glm::dot(known.nhat, mesh.corner(triangle, k)) - known.offset) <= 0.5 * graph.tolerance();
      }
      if (same) break;
    }
    if (plane == hull.planes.size()) {
      hull.planes.push_back({graph.normal(triangle), glm::dot(graph.normal(triangle), mesh.corner(triangle, 0))});
    }
    plane_of[triangle] = plane;
  }
  for (const auto triangle : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto other = graph.neighbour(triangle, k);
      if (other == SurfaceGraph::kNone) return std::nullopt;
      if (other < triangle || plane_of[other] == plane_of[triangle]) continue;
      const auto& corners = mesh.triangles[triangle];
      const auto from = vertex_of[corners[static_cast<std::size_t>(k)]];
      const auto to = vertex_of[corners[static_cast<std::size_t>((k + 1) % 3)]];
      hull.edges.push_back({{from, to}, {plane_of[triangle], plane_of[other]}});
    }
  }
  for (HullPlane& plane : hull.planes) {
    for (const dvec3& p : hull.vertices) plane.offset = std::max(plane.offset, glm::dot(plane.nhat, p));
  }
  return hull.planes.size() < 4 ? std::nullopt : std::optional(std::move(hull));
}

std::vector<Patch> mergedPatches(const SurfaceGraph& graph, std::span<const Patch> components,
                                 const MeshCollider& collider) {
  PatchMerger merger(graph, collider);
  std::vector<Patch> patches;
  for (const Patch& component : components) {
    for (Patch& patch : merger.run(component)) patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace hapticell::collision
