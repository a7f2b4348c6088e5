// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/mass_properties.h"

#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"

namespace hapticell::geometry {
namespace {

TEST(MassProperties, BoxHasTheTextbookInertia) {
  const dvec3 size(0.2, 0.4, 0.6);
  TriangleMesh mesh;
  append(mesh, makeBox(size), Pose::translation({10.0, -20.0, 5.0}));
  const MassProperties box = massProperties(mesh);
  const double volume = size.x * size.y * size.z;
  EXPECT_TRUE(box.closed);
  EXPECT_NEAR(box.volume, volume, 1e-12);
  EXPECT_NEAR(box.area, 2.0 * (0.08 + 0.24 + 0.12), 1e-12);
  EXPECT_NEAR(glm::distance(box.p_MC, dvec3(10.0, -20.0, 5.0)), 0.0, 1e-12);
  EXPECT_NEAR(box.inertia_C_M[0][0], volume / 12.0 * (size.y * size.y + size.z * size.z), 1e-12);
  EXPECT_NEAR(box.inertia_C_M[1][1], volume / 12.0 * (size.x * size.x + size.z * size.z), 1e-12);
  EXPECT_NEAR(box.inertia_C_M[2][2], volume / 12.0 * (size.x * size.x + size.y * size.y), 1e-12);
  EXPECT_NEAR(box.inertia_C_M[0][1], 0.0, 1e-12);
}

TEST(MassProperties, TurningTheBodyTurnsItsInertia) {
  const TriangleMesh part = makeFrustum(0.3, 0.1, 0.5, 24);
  const Pose X_AB{dvec3(1.0, 2.0, 3.0), quaternionFromRotationVector({0.3, -0.7, 1.1})};
  TriangleMesh turned;
  append(turned, part, X_AB);
  const MassProperties in_B = massProperties(part), in_A = massProperties(turned);
  const dmat3 expected = X_AB.R() * in_B.inertia_C_M * glm::transpose(X_AB.R());
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(in_A.inertia_C_M[i][j], expected[i][j], 1e-12);
  }
  EXPECT_NEAR(glm::distance(in_A.p_MC, X_AB * in_B.p_MC), 0.0, 1e-12);
}

TEST(MassProperties, InwardTrianglesGiveNegativeVolumeAndTheSameInertia) {
  TriangleMesh mesh = makeBox(dvec3(1.0));
  const dmat3 outward = massProperties(mesh).inertia_C_M;
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const MassProperties inward = massProperties(mesh);
  EXPECT_NEAR(inward.volume, -1.0, 1e-12);
  EXPECT_NEAR(inward.inertia_C_M[0][0], outward[0][0], 1e-12);
}

TEST(MassProperties, OpenMeshIsSaidToBeOpen) {
  TriangleMesh mesh = makeBox(dvec3(1.0));
  mesh.triangles.pop_back();
  EXPECT_FALSE(massProperties(mesh).closed);
  EXPECT_FALSE(isClosed(TriangleMesh{}));
}

TEST(MassProperties, FlatMeshHasTheCentreOfItsSurface) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  const MassProperties flat = massProperties(mesh);
  EXPECT_EQ(flat.volume, 0.0);
  EXPECT_NEAR(glm::distance(flat.p_MC, dvec3(1.0, 1.0, 0.0)), 0.0, 1e-12);
}

}  // namespace
}  // namespace hapticell::geometry
