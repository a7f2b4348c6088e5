// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_care.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <unordered_map>

#include "collision/pieces/convex_hull.h"
#include "collision/queries/mesh_search.h"
#include "collision/surfaces/mesh_facing.h"
#include "collision/trees/mesh_collider.h"

namespace hapticell::workcell {

namespace {

using geometry::Triangle;
using geometry::TriangleMesh;

double farthest(const TriangleMesh& from, const collision::MeshCollider& to) {
  double most = 0.0;
  const auto measure = [&](const dvec3& p) {
    const collision::NearestPoint nearest = collision::nearestPoint(to, p);
    if (nearest.found) most = std::max(most, nearest.distance);
  };
  for (std::uint32_t t = 0; t < from.triangles.size(); ++t) {
    const dvec3 a = from.corner(t, 0), b = from.corner(t, 1), c = from.corner(t, 2);
    for (const dvec3& p : {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0}) measure(p);
  }
  return most;
}

/// One run of the library, which knows floats: about the middle of the mesh.
TriangleMesh simplifiedOnce(const TriangleMesh& mesh, double tolerance) {
  const dvec3 center = mesh.bounds().center();
  std::vector<float> positions;
  positions.reserve(3 * mesh.vertices.size());
  for (const dvec3& vertex : mesh.vertices) {
    const dvec3 p = vertex - center;
    for (double value : {p.x, p.y, p.z}) positions.push_back(static_cast<float>(value));
  }
  std::vector<unsigned> indices;
  indices.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  const std::size_t stride = 3 * sizeof(float);
  const double scale = static_cast<double>(meshopt_simplifyScale(positions.data(), mesh.vertices.size(), stride));
  std::vector<unsigned> fewer(indices.size());
  fewer.resize(meshopt_simplify(fewer.data(), indices.data(), indices.size(), positions.data(), mesh.vertices.size(),
                                stride, 0, static_cast<float>(tolerance / scale), 0, nullptr));
  TriangleMesh result;
  std::unordered_map<unsigned, std::uint32_t> places;
  for (std::size_t k = 0; k + 2 < fewer.size(); k += 3) {
    Triangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [place, is_new] =
          places.try_emplace(fewer[k + corner], static_cast<std::uint32_t>(result.vertices.size()));
      if (is_new) result.vertices.push_back(mesh.vertices[fewer[k + corner]]);
      triangle[corner] = place->second;
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

/// Each face of the hull as a fan about its first corner, outside to the front.
TriangleMesh meshOfHull(const collision::ConvexHull& hull, double tolerance) {
  TriangleMesh mesh;
  mesh.vertices = hull.vertices;
  for (const collision::HullPlane& plane : hull.planes) {
    std::vector<std::uint32_t> ring;
    dvec3 middle(0.0);
    for (std::uint32_t k = 0; k < hull.vertices.size(); ++k) {
      if (std::abs(glm::dot(plane.nhat, hull.vertices[k]) - plane.offset) > tolerance) continue;
      ring.push_back(k);
      middle += hull.vertices[k];
    }
    if (ring.size() < 3) continue;
    middle /= static_cast<double>(ring.size());
    const dvec3 x = glm::normalize(hull.vertices[ring[0]] - middle), y = glm::cross(plane.nhat, x);
    const auto angle = [&](std::uint32_t k) {
      const dvec3 d = hull.vertices[k] - middle;
      return std::atan2(glm::dot(d, y), glm::dot(d, x));
    };
    std::sort(ring.begin(), ring.end(), [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
    for (std::size_t k = 2; k < ring.size(); ++k) mesh.triangles.push_back({ring[0], ring[k - 1], ring[k]});
  }
  return mesh;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct EdgeUse {
  std::uint32_t triangle;
  bool forward;  // From the smaller index to the larger.
};

std::map<Edge, std::vector<EdgeUse>> edgesOf(const TriangleMesh& mesh) {
  std::map<Edge, std::vector<EdgeUse>> edges;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      edges[std::minmax(a, b)].push_back({t, a < b});
    }
  }
  return edges;
}

/// The triangles of one piece in the order they were reached, and which of them must turn to face as the first does.
struct Piece {
  std::vector<std::uint32_t> triangles;
  bool closed = true;
};

class Orienter {
 public:
  explicit Orienter(TriangleMesh& mesh) : mesh_(mesh), edges_(edgesOf(mesh)) {}

  std::size_t run() {
    turned_.assign(mesh_.triangles.size(), -1);
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (turned_[t] >= 0) continue;
      const Piece piece = gather(t);
      const auto turns =
          std::count_if(piece.triangles.begin(), piece.triangles.end(), [&](auto k) { return turned_[k] == 1; });
      const bool majority = 2 * static_cast<std::size_t>(turns) > piece.triangles.size();
      const bool other_way = piece.closed ? volume(piece) < 0.0 : majority;
      for (const std::uint32_t k : piece.triangles) {
        if ((turned_[k] == 1) == other_way) continue;
        std::swap(mesh_.triangles[k][1], mesh_.triangles[k][2]);
        ++count;
      }
    }
    return count;
  }

 private:
  Piece gather(std::uint32_t first) {
    Piece piece;
    piece.triangles = {first};
    turned_[first] = 0;
    for (std::size_t at = 0; at < piece.triangles.size(); ++at) {
      const std::uint32_t t = piece.triangles[at];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        const std::vector<EdgeUse>& uses = edges_.at(std::minmax(a, b));
        if (uses.size() != 2) {
          piece.closed = false;
          continue;
        }
        const EdgeUse& other = uses[0].triangle == t ? uses[1] : uses[0];
        if (turned_[other.triangle] >= 0) continue;
        const bool same_way = other.forward == (a < b);  // Neighbours run along their edge in opposite directions.
        turned_[other.triangle] = same_way ? 1 - turned_[t] : turned_[t];
        piece.triangles.push_back(other.triangle);
      }
    }
    return piece;
  }

  double volume(const Piece& piece) const {
    double sum = 0.0;
    const dvec3 origin = mesh_.corner(piece.triangles[0], 0);
    for (const std::uint32_t t : piece.triangles) {
      const dvec3 a = mesh_.corner(t, 0) - origin, b = mesh_.corner(t, 1) - origin, c = mesh_.corner(t, 2) - origin;
      const double part = glm::dot(a, glm::cross(b, c));
      sum += turned_[t] == 1 ? -part : part;
    }
    return sum;
  }

  TriangleMesh& mesh_;
  std::map<Edge, std::vector<EdgeUse>> edges_;
  std::vector<int> turned_;  // -1: not reached yet.
};

Error withoutVolume() {
  return {.found = "a mesh without volume", .expected = "a body with thickness"};
}

}  // namespace

double deviation(const TriangleMesh& a, const TriangleMesh& b) {
  const auto collider_a = collision::MeshCollider::build(a), collider_b = collision::MeshCollider::build(b);
  return std::max(farthest(a, *collider_b), farthest(b, *collider_a));
}

Expected<MadeMesh> simplify(const TriangleMesh& mesh, double tolerance) {
  if (!(tolerance > 0.0) || !std::isfinite(tolerance)) {
    return makeError({.found = "an invalid tolerance", .expected = "metres, above 0"});
  }
  // Tries, each with half of what the library may deviate, as it measures less exactly than deviation(). Half: fewer
  // meshes keep their tolerance and are refused; twice: time.
  constexpr int kTries = 5;
  double allowed = tolerance;
  for (int k = 0; k < kTries; ++k, allowed *= 0.5) {
    TriangleMesh fewer = simplifiedOnce(mesh, allowed);
    if (fewer.triangles.empty()) continue;
    const double apart = deviation(mesh, fewer);
    if (apart <= tolerance) return MadeMesh{std::move(fewer), apart};
  }
  return MadeMesh{mesh, 0.0};
}

Expected<MadeMesh> convexMesh(const TriangleMesh& mesh) {
  const double size = mesh.bounds().radius();
  const double tolerance = 1e-7 * size;
  const auto hull = collision::convexHull(mesh.vertices, tolerance);
  if (!hull) return makeError(withoutVolume());
  MadeMesh made;
  made.mesh = meshOfHull(*hull, 10.0 * tolerance);
  geometry::weld(made.mesh, 0.0);
  if (made.mesh.triangles.empty()) return makeError(withoutVolume());
  made.deviation = deviation(mesh, made.mesh);
  return made;
}

Expected<CollisionProxy> makeProxy(const TriangleMesh& mesh, CollisionProxy::Kind kind, double tolerance) {
  CollisionProxy proxy;
  if (kind == CollisionProxy::Kind::kNone) return proxy;
  Expected<MadeMesh> made = kind == CollisionProxy::Kind::kConvex ? convexMesh(mesh) : simplify(mesh, tolerance);
  HAPTICELL_TRY(made);
  proxy.kind = kind;
  proxy.tolerance = kind == CollisionProxy::Kind::kCoarse ? tolerance : 0.0;
  proxy.deviation = made->deviation;
  proxy.mesh = std::make_shared<const TriangleMesh>(std::move(made->mesh));
  return proxy;
}

MeshHealth healthOf(const TriangleMesh& mesh) {
  MeshHealth health;
  for (const auto& [edge, uses] : edgesOf(mesh)) {
    if (uses.size() == 1) ++health.border_edges;
    if (uses.size() > 2) ++health.non_manifold_edges;
    if (uses.size() == 2 && uses[0].forward == uses[1].forward) ++health.flipped_edges;
  }
  return health;
}

std::size_t orient(TriangleMesh& mesh) {
  return Orienter(mesh).run();
}

void FacingNote::look(const geometry::TriangleMesh& mesh) {
  inward_ += collision::facingOf(mesh).bodies_turned;
}

void FacingNote::tell(Diagnostics& diagnostics) const {
  if (inward_ == 0) return;
  diagnostics.warn(inward_ == 1
                       ? Text("the triangles face inward; they are treated as facing outward")
                       : Text("the triangles of %1 bodies face inward; they are treated as facing outward", inward_));
}

}  // namespace hapticell::workcell
