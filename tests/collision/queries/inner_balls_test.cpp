// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/inner_balls.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "collision/queries/mesh_search.h"
#include "collision/queries/scene.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using Collider = std::shared_ptr<const MeshCollider>;

void add(geometry::TriangleMesh& to, const geometry::TriangleMesh& mesh, const dvec3& at) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  for (const dvec3& vertex : mesh.vertices) to.vertices.push_back(vertex + at);
  for (geometry::Triangle triangle : mesh.triangles) {
    for (auto& corner : triangle) corner += first;
    to.triangles.push_back(triangle);
  }
}

/// Solids, one with a cavity, one of two pieces, one with a sheet in it, and surfaces that enclose nothing.
std::vector<Collider> shapes() {
  geometry::TriangleMesh hollow = test::boxMesh({0.3, 0.3, 0.3}), two = test::boxMesh({0.2, 0.1, 0.1}),
                         with_sheet = test::sphereMesh(0.15);
  add(hollow, test::flipped(test::sphereMesh(0.12)), dvec3(0.0));
  add(two, test::sphereMesh(0.08), {0.2, 0.0, 0.0});
  add(with_sheet, test::sheetMesh(0.2, 4, 0.01), dvec3(0.0));
  std::mt19937 random(5);
  std::vector<Collider> all;
  for (const geometry::TriangleMesh& mesh :
       {test::boxMesh({0.4, 0.2, 0.1}), test::flipped(test::boxMesh({0.1, 0.1, 0.1})), hollow, two, with_sheet,
        test::sheetMesh(0.3, 6, 0.05), test::soupMesh(random, 60, 0.2)})
    all.push_back(MeshCollider::build(mesh));
  return all;
}

TEST(InnerBalls, LieInTheSolidAndNearNoTriangle) {
  int balls = 0;
  for (const Collider& mesh : shapes()) {
    const InnerBalls inner(*mesh);
    if (!mesh->shells().anyClosed()) {
      EXPECT_TRUE(inner.balls().empty());
    } else {
      EXPECT_FALSE(inner.balls().empty());
    }
    for (const InnerBalls::Ball& ball : inner.balls()) {
      ++balls;
      EXPECT_TRUE(mesh->contains(ball.p));
      std::vector<std::uint32_t> near;
      trianglesWithin(*mesh, ball.p, ball.radius, near);
      EXPECT_TRUE(near.empty());
    }
  }
  EXPECT_GT(balls, 20);
}

TEST(InnerBalls, WhereTheyOverlapTheMeshesCollide) {
  std::mt19937 random(11);
  const std::vector<Collider> all = shapes();
  int overlap = 0, collide = 0;
  for (const Collider& a : all) {
    for (const Collider& b : all) {
      const InnerBalls of_a(*a), of_b(*b);
      for (int i = 0; i < 200; ++i) {
        const Pose X_WA = test::randomPose(random, 0.3), X_WB = test::randomPose(random, 0.1);
        const bool is_hit = ProximityQuery(a, b).collides(X_WA, X_WB);
        collide += is_hit;
        if (!of_a.overlap(X_WA, of_b, X_WB)) continue;
        ++overlap;
        ASSERT_TRUE(is_hit) << i;
      }
    }
  }
  EXPECT_GT(overlap, collide / 10) << "and it is seen often";
}

/// Unrelated poses, so often that balls are made: as each pair says for itself.
TEST(InnerBalls, ASceneGivesTheSameAnswersByThem) {
  std::mt19937 random(17);
  const std::vector<Collider> all = shapes();
  Scene scene;
  std::vector<PartIndex> moved, standing;
  for (std::size_t i = 0; i < 3; ++i) moved.push_back(scene.addPart({1, 0}, all[i]));
  for (std::size_t i = 0; i < 20; ++i)
    standing.push_back(scene.addPart({2, 0}, all[i % all.size()], test::randomPose(random, 1.0)));
  scene.addPairs(moved, standing);
  int collide = 0;
  for (int i = 0; i < 2000; ++i) {
    for (const PartIndex part : moved) scene.setPose(part, test::randomPose(random, 1.2));
    bool expected = false;
    for (const PartIndex a : moved) {
      for (const PartIndex b : standing) {
        if (expected) break;
        expected =
            ProximityQuery(scene.sharedCollider(a), scene.sharedCollider(b)).collides(scene.pose(a), scene.pose(b));
      }
    }
    collide += expected;
    ASSERT_EQ(scene.collides(), expected) << i;
    if (i == 1000) {  // Another mesh in a place that was used before.
      scene.removePart(standing[0]);
      standing[0] = scene.addPart({3, 0}, MeshCollider::build(test::boxMesh({0.5, 0.5, 0.05})));
      for (const PartIndex a : moved) scene.addPair(a, standing[0]);
    }
  }
  EXPECT_GT(collide, 300);
  EXPECT_LT(collide, 1700);
}

}  // namespace
}  // namespace hapticell::collision
