// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/freeing_shift.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "collision/queries/mesh_search.h"

namespace hapticell::collision {

namespace {

/// Pairs of triangles whose normals are looked at: two meshes of thousands that overlap widely. Half: a good direction
/// may be missing; twice: up to twice the time when a part is taken.
constexpr std::size_t kMostPairsFreed = 4096;
/// Normals nearer than this to one another (cosine, 11 deg) are one direction. Half (0.5, 60 deg): few directions,
/// longer ways out; nearer to 1: kMostNormals are used up by one round face.
constexpr double kSameDirection = 0.98;
/// Directions tried, the largest first; each takes tens of queries. Half: a longer way out may be offered; twice: twice
/// the time.
constexpr std::size_t kMostNormals = 24;
/// m: what just touches is free after it, and growing by 1.6 it is at 0.1 m in 20 steps. Half: one step more; twice: a
/// step less.
constexpr double kFirstShift = 1e-5;
/// Of the depth, to which it is narrowed down: less than a hand can follow. Half: one query more; twice: one less.
constexpr double kAccuracy = 1e-3;
/// Points of a mesh's pieces that are looked up in the other's winding number, in their order. Half: a loose part
/// inside may be missed; twice: twice the time, which goes with the triangles.
constexpr std::size_t kMostPoints = 8;

struct Candidate {
  double depth;
  dvec3 direction_W;
};

class Search {
 public:
  Search(ProximityQuery& query, const Pose& X_WA, const Pose& X_WB) : query_(query), X_WA_(X_WA), X_WB_(X_WB) {}

  FreeingShift run() {
    for (const dvec3& direction : directions()) consider(direction);
    // Once free, the line of the nearest points is a better guess than any face's normal.
    for (int i = 0; i < 3 && !candidates_.empty(); ++i) {
      const Candidate best = *std::min_element(candidates_.begin(), candidates_.end(), isShallower);
      const DistanceResult there = query_.distance(shifted(best.depth, best.direction_W), X_WB_);
      if (there.colliding || there.distance <= 0.0) break;
      consider(there.nhat_BA_W);
    }
    std::sort(candidates_.begin(), candidates_.end(), isShallower);
    FreeingShift result;
    result.by_winding = !query_.a().isClosed() || !query_.b().isClosed();
    if (!candidates_.empty()) result.surface_depth = candidates_.front().depth;
    for (const Candidate& candidate : candidates_) {
      if (result.by_winding && isWoundAbout(shifted(candidate.depth, candidate.direction_W))) continue;
      result.found = true;
      result.depth = candidate.depth;
      result.direction_W = candidate.direction_W;
      break;
    }
    return result;
  }

 private:
  static bool isShallower(const Candidate& a, const Candidate& b) { return a.depth < b.depth; }

  Pose shifted(double depth, const dvec3& direction_W) const { return {X_WA_.p + depth * direction_W, X_WA_.q}; }

  bool isFree(double depth, const dvec3& direction_W) {
    return !query_.within(shifted(depth, direction_W), X_WB_, 0.5 * kFreeGap);
  }

  /// The first place along the direction that is free, looked for in growing steps and then narrowed down.
  void consider(const dvec3& direction_W) {
    const double most = bound();
    double blocked = 0.0, free = kFirstShift;
    while (!isFree(free, direction_W)) {
      blocked = free;
      if (free >= most) return;
      free = std::min(most, 1.6 * free);
    }
    while (free - blocked > kAccuracy * free && free - blocked > 0.1 * kFreeGap) {
      const double middle = 0.5 * (blocked + free);
      (isFree(middle, direction_W) ? free : blocked) = middle;
    }
    candidates_.push_back({free + 0.5 * kFreeGap, direction_W});
  }

  /// Farther than this nothing is in the way any more.
  double bound() const {
    const MeshCollider &a = query_.a(), &b = query_.b();
    return 1.01 * (glm::distance(X_WA_ * a.center(), X_WB_ * b.center()) + a.radius() + b.radius()) + kFirstShift;
  }

  std::vector<dvec3> directions() const {
    const MeshCollider &a = query_.a(), &b = query_.b();
    std::vector<TrianglePair> pairs;
    trianglePairsWithin(a, b, X_WA_.inverse() * X_WB_, 0.0, pairs, kMostPairsFreed);
    std::vector<std::pair<double, dvec3>> normals;
    dvec3 sum(0.0);
    for (const TrianglePair& pair : pairs) {
      const dvec3 of_b = X_WB_.rotate(areaVector(b.mesh(), pair.triangle_b));
      const dvec3 of_a = -X_WA_.rotate(areaVector(a.mesh(), pair.triangle_a));
      sum += of_b + of_a;
      add(of_b, normals);
      add(of_a, normals);
    }
    std::sort(normals.begin(), normals.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
    std::vector<dvec3> result;
    for (std::size_t i = 0; i < std::min(normals.size(), kMostNormals); ++i) result.push_back(normals[i].second);
    for (const dvec3& other : {sum, X_WA_ * a.center() - X_WB_ * b.center()}) {
      if (glm::length(other) > 1e-12) result.push_back(glm::normalize(other));
    }
    for (int i = 0; i < 3; ++i) {
      dvec3 axis(0.0);
      axis[i] = 1.0;
      result.push_back(axis);
      result.push_back(-axis);
    }
    return result;
  }

  static dvec3 areaVector(const geometry::TriangleMesh& mesh, std::uint32_t t) {
    return 0.5 * glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
  }

  static void add(const dvec3& area, std::vector<std::pair<double, dvec3>>& normals) {
    const double size = glm::length(area);
    if (!(size > 0.0)) return;
    for (auto& [weight, normal] : normals) {
      if (glm::dot(normal, area) < kSameDirection * size) continue;
      weight += size;
      return;
    }
    normals.emplace_back(size, area / size);
  }

  /// A point of one is inside the other by its winding number.
  bool isWoundAbout(const Pose& X_WA) const {
    const Pose X_AB = X_WA.inverse() * X_WB_;
    const auto isIn = [](const MeshCollider& inner, const MeshCollider& outer, const Pose& X_OuterInner) {
      const std::vector<dvec3>& points = inner.shells().points();
      for (std::size_t i = 0; i < std::min(points.size(), kMostPoints); ++i) {
        const dvec3 p = X_OuterInner * points[i];
        if (std::abs(windingNumber(outer.mesh(), p)) > 0.5) return true;
      }
      return false;
    };
    return isIn(query_.a(), query_.b(), X_AB.inverse()) || isIn(query_.b(), query_.a(), X_AB);
  }

  ProximityQuery& query_;
  Pose X_WA_;
  Pose X_WB_;
  std::vector<Candidate> candidates_;
};

}  // namespace

FreeingShift freeingShift(ProximityQuery& query, const Pose& X_WA, const Pose& X_WB) {
  if (!query.collides(X_WA, X_WB)) return {};
  return Search(query, X_WA, X_WB).run();
}

double windingNumber(const geometry::TriangleMesh& mesh, const dvec3& p_MQ) {
  double sum = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const double angle = solidAngle(mesh.corners(t), p_MQ);
    if (std::isfinite(angle)) sum += angle;
  }
  return sum / (4.0 * std::numbers::pi);
}

}  // namespace hapticell::collision
