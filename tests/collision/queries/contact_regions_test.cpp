// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/contact_regions.h"

#include <gtest/gtest.h>

#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using test::boxMesh;

TEST(ContactRegions, CountPlacesAndNotTriangles) {
  geometry::TriangleMesh table = boxMesh({1, 1, 0.05});
  for (const double x : {-0.45, 0.45}) {
    for (const double y : {-0.45, 0.45})
      geometry::append(table, boxMesh({0.05, 0.05, 0.7}), Pose::translation({x, y, -0.4}));
  }
  const auto moved = MeshCollider::build(table), floor = MeshCollider::build(boxMesh({3, 3, 0.1}));
  const Pose X_TableFloor = Pose::translation({0, 0, -0.75 - 0.05 - 0.002});
  EXPECT_EQ(countContactRegions(*moved, *floor, X_TableFloor, 0.001), 0u);
  EXPECT_EQ(countContactRegions(*moved, *floor, X_TableFloor, 0.005), 4u);
  const auto box = MeshCollider::build(boxMesh({0.2, 0.2, 0.2}));
  EXPECT_EQ(countContactRegions(*box, *floor, Pose::translation({0, 0, -0.151}), 0.005), 1u);
}

TEST(ContactRegions, SoupsJoinByPlace) {
  geometry::TriangleMesh soup;
  const geometry::TriangleMesh box = boxMesh({0.2, 0.2, 0.2});
  for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (int i = 0; i < 3; ++i) soup.vertices.push_back(box.corner(t, i));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const auto loose = MeshCollider::build(soup), floor = MeshCollider::build(boxMesh({3, 3, 0.1}));
  EXPECT_EQ(countContactRegions(*loose, *floor, Pose::translation({0, 0, -0.151}), 0.005), 1u);
}

}  // namespace
}  // namespace hapticell::collision
