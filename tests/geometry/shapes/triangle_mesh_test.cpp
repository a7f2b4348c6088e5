// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/triangle_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "geometry/shapes/shapes.h"

namespace hapticell::geometry {
namespace {

TriangleMesh squareAsSoup() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 1e-9}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}};
}

TEST(Weld, MergesCornersOfASoup) {
  TriangleMesh mesh = squareAsSoup();
  const WeldReport report = weld(mesh, weldTolerance(mesh));
  EXPECT_EQ(report.merged_vertices, 2u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(Weld, MergesAcrossCellBorders) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1e-7, 0, 0}, {0, -1, 0}, {1, -1e-7, 0}},
                    {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(weld(mesh, 1e-6).merged_vertices, 2u);
}

TEST(Weld, WithoutToleranceMergesEqualCornersOnly) {
  TriangleMesh mesh{{{1e6, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e6, 0, 0}, {1, 1e-12, 0}, {0, -1, 0}},
                    {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(weld(mesh, 0.0).merged_vertices, 1u);
}

// The grid against all pairs: every vertex stays within tolerance of where it was, and no two kept ones are that near.
RC_GTEST_PROP(Weld, AgreesWithAllPairs, ()) {
  TriangleMesh mesh;
  const auto count = *rc::gen::inRange<std::uint32_t>(1, 40);
  for (std::uint32_t t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k) {
      dvec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = 0.1 * *rc::gen::inRange(-40, 40);
      mesh.vertices.push_back(p);
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const std::vector<dvec3> before = mesh.vertices;
  const double tolerance = 0.26;
  weld(mesh, tolerance);
  for (const dvec3& kept : mesh.vertices) {
    RC_ASSERT(std::any_of(before.begin(), before.end(), [&](const dvec3& p) { return p == kept; }));
    RC_ASSERT(std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                            [&](const dvec3& p) { return glm::distance(p, kept) <= tolerance; }) == 1);
  }
}

TEST(Weld, CountsDegenerateAndDuplicateTriangles) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}},
                    {{0, 1, 2}, {1, 2, 0}, {0, 1, 1}, {0, 1, 3}, {0, 2, 1}}};
  const WeldReport report = weld(mesh, 1e-9);
  EXPECT_EQ(report.degenerate_triangles, 2u);
  EXPECT_EQ(report.duplicate_triangles, 1u);
  EXPECT_EQ(mesh.triangles.size(), 2u) << "the turned triangle is the back of a thin wall and stays";
  EXPECT_EQ(mesh.vertices.size(), 3u) << "unused vertices go";
}

TEST(TriangleMesh, AppendPlacesThePart) {
  TriangleMesh whole = squareAsSoup();
  append(whole, squareAsSoup(), Pose::translation({0, 0, 2}));
  EXPECT_EQ(whole.triangles.size(), 4u);
  EXPECT_EQ(whole.corner(2, 0), dvec3(0, 0, 2));
  EXPECT_EQ(whole.bounds().max.z, 2.0 + 1e-9);
}

TEST(TriangleMesh, WeldsAsFinelyFarFromTheOrigin) {
  TriangleMesh mesh = makeBox(dvec3(0.1));
  const std::size_t triangles = mesh.triangles.size();
  for (dvec3& vertex : mesh.vertices) vertex += dvec3(5e5, 0.0, 0.0);
  EXPECT_LT(weldTolerance(mesh), 2e-7);
  const WeldReport report = weld(mesh, weldTolerance(mesh));
  EXPECT_EQ(report.merged_vertices, 0u);
  EXPECT_EQ(mesh.triangles.size(), triangles);
}

TEST(TriangleMesh, EmptyMeshHasEmptyBounds) {
  EXPECT_TRUE(TriangleMesh{}.bounds().isEmpty());
  EXPECT_EQ(weldTolerance(TriangleMesh{}), 0.0);
}

}  // namespace
}  // namespace hapticell::geometry
