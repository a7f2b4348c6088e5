// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/shapes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/shapes/mass_properties.h"

namespace hapticell::geometry {
namespace {

/// Watertight, outward, and already welded.
void expectSolid(TriangleMesh mesh) {
  const std::size_t triangles = mesh.triangles.size();
  const std::size_t vertices = mesh.vertices.size();
  ASSERT_GT(triangles, 0u);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_GT(massProperties(mesh).volume, 0.0);
  weld(mesh, weldTolerance(mesh));
  EXPECT_EQ(mesh.triangles.size(), triangles);
  EXPECT_EQ(mesh.vertices.size(), vertices);
}

TEST(Shapes, AreClosedAndOutward) {
  expectSolid(makeBox({0.1, 0.2, 0.3}));
  expectSolid(makeCylinder(0.1, 0.5));
  expectSolid(makeCone(0.1, 0.5, 7));
  expectSolid(makeFrustum(0.3, 0.1, 0.2, 12));
  expectSolid(makePipe(0.3, 0.2, 0.1, 9));
  expectSolid(makeSphere(0.25));
  expectSolid(makeTorus(0.4, 0.1));
}

TEST(Shapes, HaveTheCountsTheyPromise) {
  EXPECT_EQ(makeBox(dvec3(1.0)).triangles.size(), 12u);
  EXPECT_EQ(makeCylinder(1.0, 1.0, 10).triangles.size(), 40u);
  EXPECT_EQ(makeCone(1.0, 1.0, 10).triangles.size(), 20u);
  EXPECT_EQ(makePipe(1.0, 0.5, 1.0, 10).triangles.size(), 80u);
  EXPECT_EQ(makeSphere(1.0, 10).triangles.size(), 2u * 10u * 4u);
}

TEST(Shapes, VolumesTendToTheTrueOnes) {
  EXPECT_NEAR(massProperties(makeCylinder(0.5, 2.0, 2000)).volume, std::numbers::pi * 0.25 * 2.0, 1e-5);
  EXPECT_NEAR(massProperties(makeCone(0.5, 2.0, 2000)).volume, std::numbers::pi * 0.25 * 2.0 / 3.0, 1e-5);
  EXPECT_NEAR(massProperties(makeSphere(0.5, 800)).volume, 4.0 / 3.0 * std::numbers::pi * 0.125, 1e-4);
  EXPECT_NEAR(massProperties(makeTorus(0.5, 0.1, 800, 400)).volume,
              2.0 * std::numbers::pi * std::numbers::pi * 0.5 * 0.01, 1e-4);
  EXPECT_NEAR(massProperties(makePipe(0.5, 0.3, 2.0, 2000)).volume, std::numbers::pi * (0.25 - 0.09) * 2.0, 1e-5);
}

TEST(Shapes, ConcavePrismHasTheVolumeOfItsPolygon) {
  const glm::dvec2 l_shape[] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  const TriangleMesh prism = makePrism(l_shape, 0.5);
  expectSolid(prism);
  EXPECT_NEAR(massProperties(prism).volume, 4.0 * 0.5, 1e-12);
}

TEST(Shapes, RefusesOutlinesThatAreNoPolygon) {
  const glm::dvec2 clockwise[] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const glm::dvec2 two[] = {{0, 0}, {1, 0}};
  EXPECT_TRUE(makePrism(clockwise, 1.0).triangles.empty());
  EXPECT_TRUE(makePrism(two, 1.0).triangles.empty());
  EXPECT_TRUE(triangulatePolygon({}).empty());
}

RC_GTEST_PROP(Shapes, StarPolygonsKeepTheirArea, ()) {
  const auto count = *rc::gen::inRange(3, 40);
  std::vector<glm::dvec2> outline;
  double twice_area = 0.0;
  for (int k = 0; k < count; ++k) {
    const double radius = 0.1 + 0.001 * *rc::gen::inRange(0, 2000);
    outline.emplace_back(radius * std::cos(2.0 * std::numbers::pi * k / count),
                         radius * std::sin(2.0 * std::numbers::pi * k / count));
  }
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 a = outline[k], b = outline[(k + 1) % outline.size()];
    twice_area += a.x * b.y - a.y * b.x;
  }
  const TriangleMesh prism = makePrism(outline, 2.0);
  RC_ASSERT(prism.triangles.size() == 4u * outline.size() - 4u);
  RC_ASSERT(isClosed(prism));
  RC_ASSERT(std::abs(massProperties(prism).volume - twice_area) < 1e-9);
}

}  // namespace
}  // namespace hapticell::geometry
