// SPDX-License-Identifier: Apache-2.0
// What convex pieces are cut with, and how two of them stand to each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "collision/pieces/convex_pieces.h"
#include "collision/pieces/feature_blocks.h"
#include "collision/pieces/patch_merger.h"
#include "collision/pieces/separating_directions.h"
#include "collision/pieces/surface_patches.h"
#include "collision/trees/triangle_distance.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::collision {
namespace {

/// An L of two arms, 0.3 m long and 0.1 m thick: concave along one edge.
geometry::TriangleMesh ellMesh() {
  const std::vector<glm::dvec2> outline{{0, 0}, {0.3, 0}, {0.3, 0.1}, {0.1, 0.1}, {0.1, 0.3}, {0, 0.3}};
  return geometry::makePrism(outline, 0.1);
}

double depthIn(const ConvexHull& hull, const dvec3& p) {
  double depth = 1e9;
  for (const HullPlane& plane : hull.planes) depth = std::min(depth, plane.offset - glm::dot(plane.nhat, p));
  return depth;
}

Patch wholePatch(const SurfaceGraph& graph) {
  std::vector<std::uint32_t> all(graph.mesh().triangles.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  return graph.patchOf(all);
}

TEST(SurfaceGraph, NeighboursOfAClosedSolidAreMutualAndShareTheEdge) {
  const SurfaceGraph graph(ellMesh(), 1e-6);
  const geometry::TriangleMesh& mesh = graph.mesh();
  double area = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    area += graph.area(t);
    EXPECT_NEAR(glm::length(graph.normal(t)), 1.0, 1e-12);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t other = graph.neighbour(t, k);
      ASSERT_NE(other, SurfaceGraph::kNone);
      const std::uint32_t from = mesh.triangles[t][static_cast<std::size_t>(k)];
      const std::uint32_t to = mesh.triangles[t][static_cast<std::size_t>((k + 1) % 3)];
      bool is_mutual = false;
      for (int j = 0; j < 3; ++j) {
        const auto at = static_cast<std::size_t>(j);
        is_mutual = is_mutual || (graph.neighbour(other, j) == t && mesh.triangles[other][at] == to &&
                                  mesh.triangles[other][(at + 1) % 3] == from);
      }
      EXPECT_TRUE(is_mutual);
    }
  }
  EXPECT_NEAR(area, 2.0 * 0.05 + 1.2 * 0.1, 1e-12);
  EXPECT_NEAR(graph.size(), std::sqrt(0.3 * 0.3 + 0.3 * 0.3 + 0.1 * 0.1), 1e-12);
}

TEST(SurfaceGraph, OnlyTheInnerEdgeOfAnLIsConcave) {
  const SurfaceGraph graph(ellMesh(), 1e-6);
  std::set<std::pair<double, double>> concave;
  for (std::uint32_t t = 0; t < graph.mesh().triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (graph.isConvexAcross(t, k)) continue;
      const dvec3 a = graph.mesh().corner(t, k), b = graph.mesh().corner(t, (k + 1) % 3);
      concave.insert({a.x, a.y});
      concave.insert({b.x, b.y});
    }
  }
  EXPECT_EQ(concave, (std::set<std::pair<double, double>>{{0.1, 0.1}}));
}

TEST(SurfaceGraph, WhatThreeTrianglesShareIsABorderAndFlatOnesAreDropped) {
  geometry::TriangleMesh fan;
  fan.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};
  fan.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 5}, {0, 1, 4}};
  const SurfaceGraph graph(fan, 1e-6);
  ASSERT_EQ(graph.mesh().triangles.size(), 3u) << "one has no area";
  EXPECT_EQ(graph.originalTriangle(2), 3u);
  for (std::uint32_t t = 0; t < 3; ++t) EXPECT_EQ(graph.neighbour(t, 0), SurfaceGraph::kNone);
  EXPECT_EQ(graph.components().size(), 1u) << "connected by shared vertices";
}

TEST(SurfaceGraph, PatchesKnowTheirPlaneAndWhatIsBeyondTheirBorder) {
  const SurfaceGraph graph(geometry::makeBox(dvec3(0.2)), 1e-6);
  std::vector<std::uint32_t> top;
  for (std::uint32_t t = 0; t < graph.mesh().triangles.size(); ++t) {
    if (graph.normal(t).z > 0.9) top.push_back(t);
  }
  const Patch patch = graph.patchOf(top);
  EXPECT_EQ(patch.vertices.size(), 4u);
  EXPECT_TRUE(graph.isFlat(patch));
  const std::vector<dvec3> beyond = graph.normalsBeyond(patch);
  EXPECT_EQ(beyond.size(), 4u) << "the four sides, each once";
  for (const dvec3& nhat : beyond) EXPECT_NEAR(nhat.z, 0.0, 1e-12);
  EXPECT_FALSE(graph.isFlat(wholePatch(graph)));
  EXPECT_TRUE(graph.normalsBeyond(wholePatch(graph)).empty()) << "no border";
}

TEST(PatchMerger, AConvexSolidIsConvexAndItsHullIsItself) {
  for (const geometry::TriangleMesh& mesh : {geometry::makeBox(dvec3(0.1, 0.2, 0.3)), geometry::makeSphere(0.1, 24)}) {
    const SurfaceGraph graph(mesh, 1e-7);
    const Patch patch = wholePatch(graph);
    EXPECT_TRUE(isConvexSurface(graph, patch));
    const auto by_points = hullOfPatch(graph, patch), by_triangles = hullOfConvexSurface(graph, patch);
    ASSERT_TRUE(by_points && by_triangles);
    EXPECT_EQ(by_points->vertices.size(), mesh.vertices.size());
    EXPECT_EQ(by_triangles->vertices.size(), mesh.vertices.size());
    for (const ConvexHull* hull : {&*by_points, &*by_triangles}) {
      EXPECT_EQ(hull->vertices.size() + hull->planes.size(), hull->edges.size() + 2) << "Euler";
      for (const dvec3& v : mesh.vertices) EXPECT_NEAR(depthIn(*hull, v), 0.0, 1e-6);
    }
  }
}

TEST(PatchMerger, AnOpenOrAHollowSurfaceIsNot) {
  const SurfaceGraph ell(ellMesh(), 1e-7);
  EXPECT_FALSE(isConvexSurface(ell, wholePatch(ell)));
  geometry::TriangleMesh open = geometry::makeBox(dvec3(0.1));
  open.triangles.pop_back();
  const SurfaceGraph graph(open, 1e-7);
  EXPECT_FALSE(hullOfConvexSurface(graph, wholePatch(graph))) << "it has a border";
}

TEST(PatchMerger, AnLIsCutIntoPatchesWhoseHullsHoldNoOtherSurface) {
  const SurfaceGraph graph(ellMesh(), 1e-6);
  const auto collider = MeshCollider::build(graph.mesh());
  const std::vector<Patch> components{wholePatch(graph)};
  for (const std::vector<Patch>& patches :
       {mergedPatches(graph, components, *collider), convexPatches(graph, *collider)}) {
    EXPECT_GE(patches.size(), 2u);
    EXPECT_LE(patches.size(), 6u) << "not one a triangle";
    std::vector<int> times(graph.mesh().triangles.size(), 0);
    for (const Patch& patch : patches) {
      for (const std::uint32_t t : patch.triangles) {
        ++times[t];
        for (const std::uint32_t vertex : patch.vertices) {
          const dvec3 off = graph.mesh().vertices[vertex] - graph.mesh().corner(t, 0);
          EXPECT_LE(glm::dot(graph.normal(t), off), 1e-6) << "all of the patch is behind each of its triangles";
        }
      }
      const auto hull = hullOfPatch(graph, patch);
      ASSERT_TRUE(hull);
      for (std::uint32_t t = 0; t < graph.mesh().triangles.size(); ++t) {
        for (int k = 0; k < 7; ++k) {
          const auto [u, v] = std::array<std::pair<double, double>, 7>{
              {{0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}, {0.3, 0.3}, {0.1, 0.8}, {0.8, 0.1}}}[static_cast<std::size_t>(k)];
          const dvec3 p = graph.mesh().corner(t, 0) + u * (graph.mesh().corner(t, 1) - graph.mesh().corner(t, 0)) +
                          v * (graph.mesh().corner(t, 2) - graph.mesh().corner(t, 0));
          EXPECT_LE(depthIn(*hull, p), 5e-6);
        }
      }
    }
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; })) << "each triangle in one patch";
  }
}

TEST(FeatureBlocks, CoverEachPlaneAndEdgeOnceAndBoxThem) {
  ConvexPiece piece = ConvexPieces::build(geometry::makeSphere(0.1, 20))->pieces().front();
  const ConvexHull before = piece.hull;
  piece.plane_blocks.clear();
  piece.edge_blocks.clear();
  std::reverse(piece.hull.edges.begin(), piece.hull.edges.end());
  sortIntoBlocks(piece);
  const ConvexHull& hull = piece.hull;
  ASSERT_EQ(hull.planes.size(), before.planes.size());
  ASSERT_EQ(hull.edges.size(), before.edges.size());
  EXPECT_EQ(piece.real_plane.size(), hull.planes.size());
  std::uint32_t next = 0;
  for (const FeatureBlock& block : piece.plane_blocks) {
    EXPECT_EQ(block.first, next);
    EXPECT_GT(block.end, block.first);
    next = block.end;
  }
  EXPECT_EQ(next, hull.planes.size());
  next = 0;
  for (const FeatureBlock& block : piece.edge_blocks) {
    EXPECT_EQ(block.first, next);
    next = block.end;
    for (std::uint32_t i = block.first; i < block.end; ++i) {
      for (const std::uint32_t vertex : hull.edges[i].vertices) {
        const dvec3& v = hull.vertices[vertex];
        EXPECT_TRUE(glm::all(glm::lessThanEqual(block.bounds.min, v)) &&
                    glm::all(glm::lessThanEqual(v, block.bounds.max)));
        for (const std::uint32_t plane : hull.edges[i].planes) {
          EXPECT_NEAR(glm::dot(hull.planes[plane].nhat, v), hull.planes[plane].offset, 1e-9)
              << "its planes moved along";
        }
      }
    }
  }
  EXPECT_EQ(next, hull.edges.size());
}

/// Two convex solids and their placed pieces.
class TwoPieces : public testing::Test {
 protected:
  struct Solid {
    explicit Solid(const geometry::TriangleMesh& made) : mesh(made), pieces(ConvexPieces::build(made)) {}
    geometry::TriangleMesh mesh;
    std::shared_ptr<const ConvexPieces> pieces;
  };
  PlacedPiece place(const Solid& solid, const Pose& X_W) const { return placed(solid.pieces->pieces().front(), X_W); }
  /// By all pairs of triangles; 0 where they meet or one holds the other.
  double distanceByTriangles(const Solid& a, const Pose& X_WA, const Solid& b, const Pose& X_WB) const {
    NearestPair best;
    for (std::uint32_t i = 0; i < a.mesh.triangles.size(); ++i) {
      for (std::uint32_t j = 0; j < b.mesh.triangles.size(); ++j) {
        const auto corners = [](const Solid& s, std::uint32_t t, const Pose& X) {
          return Corners{X * s.mesh.corner(t, 0), X * s.mesh.corner(t, 1), X * s.mesh.corner(t, 2)};
        };
        improveTriangleDistance(corners(a, i, X_WA), corners(b, j, X_WB), best);
      }
    }
    const bool is_held = depthIn(a.pieces->pieces().front().hull, X_WA.inverse() * (X_WB * b.mesh.vertices[0])) > 0.0 ||
                         depthIn(b.pieces->pieces().front().hull, X_WB.inverse() * (X_WA * a.mesh.vertices[0])) > 0.0;
    return is_held ? 0.0 : std::sqrt(best.squared);
  }
  double uniform(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  Pose pose(double reach) {
    return {dvec3(uniform(reach), uniform(reach), uniform(reach)),
            quaternionFromRotationVector(dvec3(uniform(2.0), uniform(2.0), uniform(2.0)))};
  }
  std::mt19937 random_{31};
  Solid box_{geometry::makeBox(dvec3(0.1, 0.06, 0.04))}, cone_{geometry::makeCone(0.05, 0.08, 7)};
};

TEST_F(TwoPieces, ATranslationPartsThemExactlyWhereADirectionSaysSo) {
  int apart = 0, together = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Pose X_WA = pose(0.08), X_WB = pose(0.02);
    const PlacedPiece a = place(box_, X_WA), b = place(cone_, X_WB);
    const DirectionLimits limits{.reach = 0.3, .max_rotation = 0.0};
    const auto directions = separatingDirections(a, b, limits);
    if (directions.empty()) continue;
    EXPECT_TRUE(std::is_sorted(directions.begin(), directions.end(),
                               [](const auto& l, const auto& r) { return l.gap > r.gap; }));
    for (const SeparatingDirection& direction : directions) {
      double least_a = 1e9, most_b = -1e9;
      for (const dvec3& v : box_.mesh.vertices) least_a = std::min(least_a, glm::dot(direction.nhat_W, X_WA * v));
      for (const dvec3& v : cone_.mesh.vertices) most_b = std::max(most_b, glm::dot(direction.nhat_W, X_WB * v));
      EXPECT_NEAR(direction.gap, least_a - most_b, 1e-9) << "sound";
      EXPECT_NEAR(glm::length(direction.nhat_W), 1.0, 1e-9);
    }
    for (int shift = 0; shift < 30; ++shift) {
      const dvec3 d(uniform(0.12), uniform(0.12), uniform(0.12));
      double separation = -1e9;
      for (const SeparatingDirection& direction : directions) {
        separation = std::max(separation, direction.gap + glm::dot(direction.nhat_W, d));
      }
      if (std::abs(separation) < 1e-6) continue;
      Pose X_moved = X_WA;
      X_moved.p += d;
      const bool is_apart = distanceByTriangles(box_, X_moved, cone_, X_WB) > 0.0;
      EXPECT_EQ(separation > 0.0, is_apart) << separation;
      ++(is_apart ? apart : together);
    }
  }
  EXPECT_GT(apart, 30);
  EXPECT_GT(together, 30);
}

TEST_F(TwoPieces, TheNearestDirectionIsNearlyTheDistanceAndNeverMore) {
  for (int trial = 0; trial < 60; ++trial) {
    const Pose X_WA = pose(0.2), X_WB = pose(0.05);
    const double distance = distanceByTriangles(box_, X_WA, cone_, X_WB);
    const PlacedPiece a = place(box_, X_WA), b = place(cone_, X_WB);
    const SeparatingDirection nearest = nearestDirection(a, b, 1e9);
    EXPECT_EQ(nearest.rank, DirectionRank::kVirtual);
    if (distance <= 0.0) {
      EXPECT_LE(nearest.gap, 1e-9);
      continue;
    }
    EXPECT_LE(nearest.gap, distance + 1e-9);
    EXPECT_GE(nearest.gap, 0.9 * distance - 1e-6);
    EXPECT_TRUE(mayMeet(a, b, distance + 1e-6)) << "what can meet is not left out";
  }
}

TEST_F(TwoPieces, FarApartTheyCannotMeet) {
  const Solid ball{geometry::makeSphere(0.05, 24)};
  const PlacedPiece a = place(ball, Pose::translation({2, 0, 0})), b = place(ball, {});
  EXPECT_FALSE(mayMeet(a, b, 0.1));
  EXPECT_FALSE(isInside(a, b));
  EXPECT_TRUE(mayMeet(a, b, 1.95));
}

TEST_F(TwoPieces, OneInsideTheOtherIsSeen) {
  const Solid large{geometry::makeBox(dvec3(1.0))}, small{geometry::makeSphere(0.05, 12)};
  const PlacedPiece outer = place(large, {}), inner = place(small, Pose::translation({0.2, 0.1, 0.0}));
  EXPECT_TRUE(isInside(inner, outer));
  EXPECT_TRUE(isInside(outer, inner));
  EXPECT_TRUE(mayMeet(inner, outer, 0.01));
}

TEST_F(TwoPieces, SupportsAreCornersOfTheFaceAndThinningKeepsTheFirstAndTheFarthest) {
  const Solid base{geometry::makeBox(dvec3(1.0))};
  const PlacedPiece a = place(box_, Pose::translation({0.0, 0.0, 0.53})), b = place(base, {});
  const DirectionLimits limits{.reach = 0.05, .max_rotation = 0.3};
  auto directions = separatingDirections(a, b, limits);
  ASSERT_FALSE(directions.empty());
  SeparatingDirection& up = directions.front();
  EXPECT_NEAR(up.nhat_W.z, 1.0, 1e-12);
  EXPECT_NEAR(up.gap, 0.01, 1e-12);
  completeSupports(up, a, b, limits);
  ASSERT_GE(up.supports.size(), 4u) << "the lower face's corners";
  for (const SupportPoint& support : up.supports) {
    EXPECT_NEAR(support.gap, up.gap, 1e-9);
    EXPECT_NEAR(support.p_W.z, 0.51, 1e-9);
  }
  std::vector<SupportPoint> row;
  for (const double x : {0.0, 0.1, 0.2, 0.3, 1.0}) row.push_back({.p_W = dvec3(x, 0, 0)});
  thinOut(row, 2);
  ASSERT_EQ(row.size(), 2u);
  EXPECT_EQ(row[0].p_W.x, 0.0);
  EXPECT_EQ(row[1].p_W.x, 1.0);
  thinOut(row, 5);
  EXPECT_EQ(row.size(), 2u);
}

}  // namespace
}  // namespace hapticell::collision
