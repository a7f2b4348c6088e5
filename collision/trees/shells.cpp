// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "collision/trees/ray.h"

namespace hapticell::collision {

namespace {

/// Disjoint sets with path halving.
class Unions {
 public:
  explicit Unions(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// For each vertex one that stands for all joined to it by steps of at most `tolerance`. Sorted along an oblique line,
/// so that even the vertices of flat plates have few neighbours to be compared with.
Unions joinVertices(const std::vector<dvec3>& vertices, double tolerance) {
  const dvec3 oblique = glm::normalize(dvec3(0.5773, 0.7071, 0.4082));
  std::vector<std::pair<double, std::uint32_t>> sorted(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) sorted[i] = {glm::dot(vertices[i], oblique), i};
  std::sort(sorted.begin(), sorted.end());
  Unions unions(vertices.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].first - sorted[i].first <= tolerance; ++j) {
      if (glm::distance(vertices[sorted[i].second], vertices[sorted[j].second]) <= tolerance) {
        unions.join(sorted[i].second, sorted[j].second);
      }
    }
  }
  return unions;
}

struct Edge {
  std::uint32_t low = 0, high = 0, piece = 0;
  int turn = 0;  ///< +1 from low to high, -1 back.
};

std::vector<Edge> sortedEdges(const std::vector<geometry::Triangle>& joined, const std::vector<std::uint32_t>& pieces) {
  std::vector<Edge> edges;
  edges.reserve(3 * joined.size());
  for (std::size_t t = 0; t < joined.size(); ++t) {
    const auto& v = joined[t];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = v[i], to = v[(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), pieces[t], from < to ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
  return edges;
}

/// Crossings of one ray with the closed pieces.
struct Crossings {
  Crossings(const Shells& of, const BoxTree& its_tree, const geometry::TriangleMesh& its_mesh, const Ray& along)
      : shells(of), tree(its_tree), mesh(its_mesh), ray(along) {}

  const Shells& shells;
  const BoxTree& tree;
  const geometry::TriangleMesh& mesh;
  Ray ray;
  int turns = 0;
  bool odd = false;
  bool grazed = false;

  /// Follows the ray to where it is out of the closed pieces. As a box without width it is compared with eight boxes at
  /// once: where their bound is above 0 it surely passes them by.
  void run() {
    const geometry::Bounds& box = shells.closedBounds();
    const dvec3 along = glm::normalize(ray.direction);
    const double half = 0.5 * glm::length(box.size());
    middle_ = ray.origin + half * along;
    const dvec3 across = glm::normalize(glm::cross(along, std::abs(along.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const dvec3 axes[3] = {along, across, glm::cross(along, across)};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) query_.axis[i][k] = static_cast<float>(axes[i][k]);
    }
    query_.half[0] = static_cast<float>(half);
    query_.half[1] = query_.half[2] = 0.0F;
    visit(tree.child(BoxTree::kRoot));
  }

  void visit(std::uint32_t child) {
    if (grazed) return;
    if (BoxTree::isLeaf(child)) {
      const LeafBlock& leaf = tree.leaf(child);
      for (std::uint32_t i = 0; i < leaf.count; ++i) count(leaf.triangle[i]);
      return;
    }
    const BoxNode& node = tree.node(child);
    for (int i = 0; i < 3; ++i) query_.center[i] = static_cast<float>(middle_[i] - double{node.origin[i]});
    alignas(32) float bounds[kTreeWidth];
    proximityKernels().boxBounds(node, query_, 0.0F, bounds);
    for (std::uint32_t lane = 0; lane < node.count; ++lane) {
      if (!(bounds[lane] > 0.0F)) visit(node.child[lane]);
    }
  }

  void count(std::uint32_t triangle) {
    const Shells::Kind kind = shells.kind(triangle);
    if (kind == Shells::Kind::kOpen) return;
    const RayCrossing crossing = meetTriangle(ray, mesh.corners(triangle));
    grazed |= crossing.grazes;
    if (!crossing.meets) return;
    if (kind == Shells::Kind::kOriented)
      turns += crossing.leaving ? 1 : -1;
    else
      odd = !odd;
  }

 private:
  dvec3 middle_{0.0};
  QueryBox query_;
};

bool isInsideByWinding(const Shells& shells, const geometry::TriangleMesh& mesh, const dvec3& p) {
  double sum = 0.0;
  const auto count = static_cast<std::uint32_t>(shells.triangleCount());
  for (std::uint32_t t = 0; t < count; ++t) {
    if (shells.kind(t) != Shells::Kind::kOriented) continue;
    const double angle = solidAngle(mesh.corners(t), p);
    if (std::isfinite(angle)) sum += angle;
  }
  return std::abs(sum) > 2.0 * std::numbers::pi;
}

}  // namespace

double solidAngle(const Corners& corners, const dvec3& p) {
  const dvec3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double above = glm::dot(a, glm::cross(b, c));
  const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(above, below);
}

Shells::Shells(const geometry::TriangleMesh& mesh) {
  Unions vertices = joinVertices(mesh.vertices, geometry::weldTolerance(mesh));
  std::vector<geometry::Triangle> joined(mesh.triangles.size());
  Unions pieces(mesh.vertices.size());
  for (std::size_t t = 0; t < joined.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) joined[t][i] = vertices.find(mesh.triangles[t][i]);
    pieces.join(joined[t][0], joined[t][1]);
    pieces.join(joined[t][1], joined[t][2]);
  }
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  piece_of_triangle_.resize(joined.size());
  for (std::size_t t = 0; t < joined.size(); ++t) {
    std::uint32_t& piece = number[pieces.find(joined[t][0])];
    if (piece == kNone) {
      piece = static_cast<std::uint32_t>(point_of_piece_.size());
      point_of_piece_.push_back(mesh.vertices[mesh.triangles[t][0]]);
    }
    piece_of_triangle_[t] = piece;
  }
  classify(sortedEdges(joined, piece_of_triangle_));
  for (std::size_t t = 0; t < joined.size(); ++t) {
    if (kind_of_piece_[piece_of_triangle_[t]] == Kind::kOpen) continue;
    for (const std::uint32_t vertex : mesh.triangles[t]) closed_bounds_.add(mesh.vertices[vertex]);
  }
}

template <typename Edges>
void Shells::classify(const Edges& edges) {
  std::vector<bool> has_edges(point_of_piece_.size(), false);
  kind_of_piece_.assign(point_of_piece_.size(), Kind::kOriented);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first;
    int turns = 0;
    while (last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high) {
      turns += edges[last++].turn;
    }
    Kind& kind = kind_of_piece_[edges[first].piece];
    has_edges[edges[first].piece] = true;
    if ((last - first) % 2 != 0)
      kind = Kind::kOpen;
    else if (turns != 0 && kind == Kind::kOriented)
      kind = Kind::kUnoriented;
    first = last;
  }
  for (std::size_t i = 0; i < has_edges.size(); ++i) {
    if (!has_edges[i]) kind_of_piece_[i] = Kind::kOpen;
    if (kind_of_piece_[i] == Kind::kOpen) ++open_pieces_;
  }
}

bool isInside(const Shells& shells, const BoxTree& tree, const geometry::TriangleMesh& mesh, const dvec3& p_MQ) {
  if (!shells.anyClosed()) return false;
  const geometry::Bounds& box = shells.closedBounds();
  if (glm::any(glm::lessThan(p_MQ, box.min)) || glm::any(glm::greaterThan(p_MQ, box.max))) return false;
  dvec3 direction(0.36218, 0.51263, 0.77841);
  for (int attempt = 0; attempt < 8; ++attempt) {
    Crossings crossings(shells, tree, mesh, {p_MQ, direction});
    crossings.run();
    if (!crossings.grazed) return crossings.turns != 0 || crossings.odd;
    direction = dvec3(direction.y - 0.2137 * direction.z, direction.z + 0.1311, -direction.x);
  }
  return isInsideByWinding(shells, mesh, p_MQ);
}

}  // namespace hapticell::collision
