// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/shells.h"

#include <gtest/gtest.h>

#include "collision/trees/mesh_collider.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using geometry::TriangleMesh;
using test::boxMesh;

TEST(Shells, TellClosedFromOpen) {
  EXPECT_TRUE(Shells(boxMesh({1, 1, 1})).allClosed());
  EXPECT_FALSE(Shells(test::sheetMesh(1, 4, 0.1)).anyClosed());
  TriangleMesh holed = boxMesh({1, 1, 1});
  holed.triangles.pop_back();
  EXPECT_FALSE(Shells(holed).anyClosed());
  TriangleMesh both = boxMesh({1, 1, 1});
  geometry::append(both, test::sheetMesh(1, 4, 0.1), Pose::translation({3, 0, 0}));
  const Shells shells(both);
  EXPECT_EQ(shells.count(), 2u);
  EXPECT_TRUE(shells.anyClosed());
  EXPECT_FALSE(shells.allClosed());
  EXPECT_FALSE(Shells(TriangleMesh{}).allClosed());
}

TEST(Shells, HairlineGapsOfASoupAreClosed) {
  const TriangleMesh box = boxMesh({1, 1, 1});
  TriangleMesh soup;
  for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (int i = 0; i < 3; ++i) soup.vertices.push_back(box.corner(t, i) + dvec3(1e-8 * t, 0, 0));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(Shells(soup).allClosed());
}

TEST(Shells, InsideAgreesWithTheFormula) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(-0.7, 0.7);
  const auto box = MeshCollider::build(boxMesh({1, 0.6, 0.8})),
             turned = MeshCollider::build(test::flipped(boxMesh({1, 0.6, 0.8})));
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p(uniform(random), uniform(random), uniform(random));
    const bool expected = std::abs(p.x) < 0.5 && std::abs(p.y) < 0.3 && std::abs(p.z) < 0.4;
    EXPECT_EQ(box->contains(p), expected);
    EXPECT_EQ(turned->contains(p), expected) << "a solid turned inside out is a solid";
  }
  // Points from which the rays run into edges and corners.
  EXPECT_TRUE(box->contains({0, 0, 0}));
  EXPECT_TRUE(box->contains({0.1, 0, 0}));
}

TEST(Shells, OverlappingSolidsAreInsideAndCavitiesOutside) {
  TriangleMesh overlapping = boxMesh({1, 1, 1});
  geometry::append(overlapping, boxMesh({1, 1, 1}), Pose::translation({0.5, 0.1, 0.2}));
  EXPECT_TRUE(MeshCollider::build(overlapping)->contains({0.25, 0.05, 0.03}));
  TriangleMesh hollow = boxMesh({1, 1, 1});
  geometry::append(hollow, test::flipped(boxMesh({0.5, 0.5, 0.5})), {});
  const auto collider = MeshCollider::build(hollow);
  EXPECT_FALSE(collider->contains({0.1, 0.02, 0.03}));
  EXPECT_TRUE(collider->contains({0.4, 0.02, 0.03}));
}

}  // namespace
}  // namespace hapticell::collision
