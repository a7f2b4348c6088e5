// SPDX-License-Identifier: Apache-2.0
#include "geometry/normals.h"

#include <gtest/gtest.h>

#include "geometry/shapes.h"

namespace hapticell::geometry {
namespace {

TEST(CornerNormals, ofASphereAreItsRadii) {
  const TriangleMesh sphere = makeSphere(2.0, 96);
  const auto normals = cornerNormals(sphere);
  for (std::uint32_t t = 0; t < sphere.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_GT(glm::dot(normals[3 * t + static_cast<std::uint32_t>(k)], glm::normalize(sphere.corner(t, k))), 0.999);
    }
  }
}

TEST(CornerNormals, ofABoxAreThoseOfItsFaces) {
  const TriangleMesh box = makeBox({1.0, 2.0, 3.0});
  const auto normals = cornerNormals(box);
  for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
    const dvec3 a = box.corner(t, 0);
    const dvec3 face = glm::normalize(glm::cross(box.corner(t, 1) - a, box.corner(t, 2) - a));
    for (std::uint32_t k = 0; k < 3; ++k) EXPECT_NEAR(glm::distance(normals[3 * t + k], face), 0.0, 1e-12);
  }
}

TEST(CornerNormals, ofTwoBoxesThatTouchInAnEdgeStayApart) {
  TriangleMesh two = makeBox(dvec3(1.0));
  append(two, makeBox(dvec3(1.0)), Pose::translation({1.0, 1.0, 0.0}));
  weld(two, 1e-9);
  const auto normals = cornerNormals(two);
  for (const dvec3& n : normals) {
    const dvec3 size = glm::abs(n);
    EXPECT_NEAR(std::max({size.x, size.y, size.z}), 1.0, 1e-12);
  }
}

TEST(ShadedMesh, splitsVerticesAtCreasesOnly) {
  EXPECT_EQ(shadedMesh(makeBox(dvec3(1.0))).positions.size(), 24u);
  const TriangleMesh sphere = makeSphere(1.0, 48);
  EXPECT_EQ(shadedMesh(sphere).positions.size(), sphere.vertices.size());
  // Rims twice, the middles of the two lids once.
  EXPECT_EQ(shadedMesh(makeCylinder(0.5, 1.0, 24)).positions.size(), 4u * 24u + 2u);
}

TEST(ShadedMesh, keepsSmallPartsFarFromTheOriginExact) {
  TriangleMesh far;
  append(far, makeBox(dvec3(0.001)), Pose::translation({1000.0, 2000.0, 0.0}));
  const ShadedMesh shaded = shadedMesh(far);
  EXPECT_NEAR(shaded.origin.y, 2000.0, 1e-9);
  for (const fvec3& p : shaded.positions) EXPECT_NEAR(std::abs(p.x), 0.0005f, 1e-9f);
  EXPECT_EQ(shaded.indices.size(), 36u);
  EXPECT_TRUE(shadedMesh({}).indices.empty());
}

}  // namespace
}  // namespace hapticell::geometry
