// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/convex_pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision/pieces/convex_hull.h"
#include "geometry/shapes/shapes.h"
#include "tests/collision/contacts/zone_scenes.h"

namespace hapticell::test {
namespace {

using collision::ConvexPieces;

double depthInside(const collision::ConvexHull& hull, const dvec3& p) {
  double depth = 1e9;
  for (const auto& plane : hull.planes) depth = std::min(depth, plane.offset - glm::dot(plane.nhat, p));
  return depth;
}

TEST(ConvexHull, OfABoxHasItsSixFacesAndTwelveEdges) {
  const auto box = geometry::makeBox(dvec3(1, 2, 3));
  auto points = box.vertices;
  points.push_back(dvec3(0.1, 0.2, 0.3));  // inside
  points.push_back(dvec3(0.5, 0.0, 0.0));  // on a face
  const auto hull = collision::convexHull(points, 1e-9);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->vertices.size(), 8u);
  EXPECT_EQ(hull->planes.size(), 6u);
  EXPECT_EQ(hull->edges.size(), 12u);
}

TEST(ConvexHull, OfFlatPointsIsNothingButTheirPrismIs) {
  const std::vector<dvec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}};
  EXPECT_FALSE(collision::convexHull(square, 1e-9));
  const auto prism = collision::convexPrism(square, dvec3(0, 0, 1), 0.1);
  ASSERT_TRUE(prism);
  EXPECT_EQ(prism->vertices.size(), 8u);
  EXPECT_EQ(prism->planes.size(), 6u);
  EXPECT_EQ(prism->edges.size(), 12u);
  EXPECT_NEAR(depthInside(*prism, dvec3(0.5, 0.5, -0.05)), 0.05, 1e-12);
}

RC_GTEST_PROP(ConvexHull, HoldsEveryPointAndItsCornersAreAmongThem, ()) {
  const auto numbers = *rc::gen::container<std::vector<int>>(*rc::gen::inRange(12, 120), rc::gen::inRange(-1000, 1000));
  std::vector<dvec3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.emplace_back(1e-3 * numbers[i], 1e-3 * numbers[i + 1], 1e-3 * numbers[i + 2]);
  }
  const auto hull = collision::convexHull(points, 1e-9);
  if (!hull) return;  // in one plane
  for (const dvec3& p : points) RC_ASSERT(depthInside(*hull, p) >= -1e-8);
  for (const dvec3& v : hull->vertices) {
    RC_ASSERT(std::any_of(points.begin(), points.end(), [&](const dvec3& p) { return p == v; }));
  }
}

TEST(ConvexPieces, AConvexSolidIsOnePiece) {
  for (const auto& mesh : {geometry::makeBox(dvec3(0.1)), geometry::makeCylinder(0.02, 0.1, 24),
                           geometry::makeSphere(0.03, 24), geometry::makeCone(0.02, 0.03, 24)}) {
    EXPECT_EQ(ConvexPieces::build(mesh)->pieces().size(), 1u);
  }
}

TEST(ConvexPieces, ABoreIsCutIntoItsSectors) {
  EXPECT_EQ(ConvexPieces::build(geometry::makePipe(0.04, 0.02, 0.05, 24))->pieces().size(), 24u);
}

TEST(ConvexPieces, HoldEveryTriangleOnceAndNoOtherSurface) {
  for (const ZoneScene& scene : simpleZoneScenes()) {
    for (const auto* mesh : {&scene.moving, &scene.environment}) {
      const auto pieces = ConvexPieces::build(*mesh);
      std::vector<int> times(mesh->triangles.size(), 0);
      for (const auto& piece : pieces->pieces()) {
        for (const auto triangle : piece.triangles) {
          ++times[triangle];
          for (int k = 0; k < 3; ++k)
            EXPECT_GE(depthInside(piece.hull, mesh->corner(triangle, k)), -pieces->tolerance());
        }
        // Middles of all other triangles lie outside (parts put together of several solids may overlap).
        if (scene.name == "box among posts") continue;
        for (std::uint32_t i = 0; i < mesh->triangles.size(); ++i) {
          const dvec3 middle = (mesh->corner(i, 0) + mesh->corner(i, 1) + mesh->corner(i, 2)) / 3.0;
          EXPECT_LE(depthInside(piece.hull, middle), 2.0 * pieces->tolerance()) << scene.name;
        }
      }
      EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; })) << scene.name;
    }
  }
}

TEST(ConvexPieces, AnEmptyMeshAndSliversGiveNoPieces) {
  EXPECT_TRUE(ConvexPieces::build({})->pieces().empty());
  geometry::TriangleMesh sliver{{dvec3(0), dvec3(1, 0, 0), dvec3(2, 0, 0)}, {{0, 1, 2}}};
  EXPECT_TRUE(ConvexPieces::build(sliver)->pieces().empty());
}

}  // namespace
}  // namespace hapticell::test
