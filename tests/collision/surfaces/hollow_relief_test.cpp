// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/hollow_relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "collision/queries/mesh_search.h"
#include "collision/surfaces/surface_recognition.h"
#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/shapes.h"
#include "tests/collision/surfaces/generated_parts.h"

namespace {

using namespace hapticell;

constexpr double kBore = 0.01, kSteps = 40;

TEST(HollowRelief, ABoresFacetsStandBehindItsSurface) {
  const auto surface = collision::recogniseSurfaces(geometry::makePipe(0.03, kBore, 0.05, static_cast<int>(kSteps)));
  ASSERT_TRUE(collision::hasHollows(surface));
  const auto mesh = collision::relievedMesh(surface);
  const auto drawn = collision::MeshCollider::build(surface.mesh);
  const auto relieved = collision::MeshCollider::build(mesh);
  const double sagitta = kBore * (1.0 - std::cos(std::numbers::pi / kSteps));
  double drawn_least = 1.0, least = 1.0, most = 0.0;
  for (int i = 0; i < 500; ++i) {
    const dvec3 p(0.0, 0.0, -0.02 + 8e-5 * i);  // From the axis every way is the bore's radius.
    const double before = collision::nearestPoint(*drawn, p, 0.1).distance;
    const double after = collision::nearestPoint(*relieved, p, 0.1).distance;
    drawn_least = std::min(drawn_least, before);
    least = std::min(least, after);
    most = std::max(most, after);
  }
  EXPECT_NEAR(drawn_least, kBore - sagitta, 1e-8);
  EXPECT_GE(least, kBore - 1e-8);
  EXPECT_LE(most, kBore + 0.1 * sagitta);
}

TEST(HollowRelief, MovesNothingThatIsNotHollow) {
  for (const auto& solid : {geometry::makeBox(dvec3(0.1)), geometry::makeCylinder(0.02, 0.05, 48)}) {
    const auto surface = collision::recogniseSurfaces(solid);
    EXPECT_FALSE(collision::hasHollows(surface));
    const auto mesh = collision::relievedMesh(surface);
    EXPECT_EQ(mesh.vertices, surface.mesh.vertices);
  }
}

TEST(HollowRelief, NeverMovesByMoreThanTwiceItsLimit) {
  for (const auto& part : test::generatedParts()) {
    const auto surface = collision::recogniseSurfaces(part.mesh);
    const auto mesh = collision::relievedMesh(surface);
    ASSERT_EQ(mesh.triangles, surface.mesh.triangles);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      EXPECT_LE(glm::length(mesh.vertices[i] - surface.mesh.vertices[i]), 2e-4) << part.name;
  }
}

}  // namespace
