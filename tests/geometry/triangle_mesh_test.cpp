// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_mesh.h"

#include <gtest/gtest.h>

namespace hapticell::geometry {
namespace {

TriangleMesh squareAsSoup() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 1e-9}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}};
}

TEST(Weld, mergesCornersOfASoup) {
  TriangleMesh mesh = squareAsSoup();
  const WeldReport report = weld(mesh, weldTolerance(mesh));
  EXPECT_EQ(report.merged_vertices, 2u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(Weld, mergesAcrossCellBorders) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1e-7, 0, 0}, {0, -1, 0}, {1, -1e-7, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(weld(mesh, 1e-6).merged_vertices, 2u);
}

TEST(Weld, countsDegenerateAndDuplicateTriangles) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 2, 0}, {0, 1, 1}, {0, 1, 3}, {0, 2, 1}}};
  const WeldReport report = weld(mesh, 1e-9);
  EXPECT_EQ(report.degenerate_triangles, 2u);
  EXPECT_EQ(report.duplicate_triangles, 1u);
  EXPECT_EQ(mesh.triangles.size(), 2u) << "the turned triangle is the back of a thin wall and stays";
  EXPECT_EQ(mesh.vertices.size(), 3u) << "unused vertices go";
}

TEST(TriangleMesh, appendPlacesThePart) {
  TriangleMesh whole = squareAsSoup();
  append(whole, squareAsSoup(), Pose::translation({0, 0, 2}));
  EXPECT_EQ(whole.triangles.size(), 4u);
  EXPECT_EQ(whole.corner(2, 0), dvec3(0, 0, 2));
  EXPECT_EQ(whole.bounds().max.z, 2.0 + 1e-9);
}

TEST(TriangleMesh, emptyMeshHasEmptyBounds) {
  EXPECT_TRUE(TriangleMesh{}.bounds().isEmpty());
  EXPECT_EQ(weldTolerance(TriangleMesh{}), 0.0);
}

}  // namespace
}  // namespace hapticell::geometry
