// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/display_mesh.h"

#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

TEST(DisplayMesh, ABoxHasTwelveCreasesAndFlatFaces) {
  const DisplayMesh display = makeDisplayMesh(geometry::makeBox({1.0, 2.0, 3.0}));
  EXPECT_EQ(display.creases, 12u);
  EXPECT_EQ(display.edges.size(), 18u) << "six diagonals are smooth";
  EXPECT_EQ(display.vertices.size(), 24u);
  EXPECT_EQ(display.indices.size(), 36u);
}

TEST(DisplayMesh, ACylinderIsSmoothRoundItsSide) {
  const DisplayMesh display = makeDisplayMesh(geometry::makeCylinder(0.5, 1.0, 48));
  EXPECT_EQ(display.creases, 96u) << "only the two rims";
  for (const DisplayVertex& vertex : display.vertices) {
    if (std::abs(vertex.normal.z) > 0.5f) continue;
    const fvec3 radial = glm::normalize(fvec3(vertex.position.x, vertex.position.y, 0.0f));
    EXPECT_GT(glm::dot(radial, vertex.normal), 0.999f);
  }
}

TEST(DisplayMesh, CornersThatAreNotSharedAreSmoothedAllTheSame) {
  const geometry::TriangleMesh shared = geometry::makeSphere(1.0, 24);
  geometry::TriangleMesh soup;
  for (std::uint32_t t = 0; t < shared.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (int i = 0; i < 3; ++i) soup.vertices.push_back(shared.corner(t, i));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(makeDisplayMesh(soup).creases, makeDisplayMesh(shared).creases);
  EXPECT_EQ(makeDisplayMesh(soup).vertices.size(), makeDisplayMesh(shared).vertices.size());
}

TEST(DisplayMesh, BordersAreDrawnAndLargeCoordinatesKeepTheirDigits) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{1e6, 0, 0}, {1e6 + 0.001, 0, 0}, {1e6, 0.001, 0}};
  mesh.triangles = {{0, 1, 2}};
  const DisplayMesh display = makeDisplayMesh(mesh);
  EXPECT_EQ(display.creases, 3u);
  EXPECT_NEAR(glm::length(display.edges[0].to - display.edges[0].from), 0.0012, 3e-4);
  EXPECT_NEAR(display.center.x, 1e6, 1.0);
}

TEST(DisplayMesh, NothingAndFacesWithoutAreaDoNotHurt) {
  EXPECT_TRUE(makeDisplayMesh({}).vertices.empty());
  geometry::TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}, {0, 0, 1}};
  for (const DisplayVertex& vertex : makeDisplayMesh(flat).vertices) EXPECT_TRUE(std::isfinite(vertex.normal.x));
}

}  // namespace
}  // namespace hapticell::app
