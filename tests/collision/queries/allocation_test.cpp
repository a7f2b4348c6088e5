// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "collision/queries/scene.h"
#include "tests/collision/queries/meshes.h"
#include "tests/support/allocation_guard.h"

namespace hapticell::collision {
namespace {

TEST(Allocation, WarmQueriesDoNotAllocate) {
  if (!hapticell::test::allocationsAreCounted()) GTEST_SKIP() << hapticell::test::kNotCounted;
  std::mt19937 random(9);
  const auto ball = MeshCollider::build(test::sphereMesh(0.1)),
             box = MeshCollider::build(test::boxMesh({0.5, 0.5, 0.1}));
  ProximityQuery query(ball, box);
  Scene scene;
  const PartIndex moved = scene.addPart({1, 0}, ball), fixed = scene.addPart({2, 0}, box);
  scene.addPair(moved, fixed);
  std::vector<PairDistance> found;
  found.reserve(16);
  const auto once = [&] {
    const Pose X_WM = test::randomPose(random, 0.5), X_WNext = test::randomPose(random, 0.5);
    query.distance(X_WM, {});
    query.within(X_WM, {}, 0.01);
    query.collides(X_WM, {});
    advance(query, straightMotion(X_WM, X_WNext, *ball), standingStill({}), {0.001});
    scene.setPose(moved, X_WM);
    scene.nearest();
    found.clear();
    scene.pairsWithin(1.0, found);
    const MovedPart motion[] = {{moved, straightMotion(X_WM, X_WNext, *ball)}};
    scene.advance(motion, 0.001);
  };
  const hapticell::test::AllocationGuard first;
  for (int i = 0; i < 100; ++i) once();  // The lists of near pairs get their memory when parts first come near.
  EXPECT_GT(first.count(), 0u) << "the guard counts";
  const hapticell::test::AllocationGuard warm;
  for (int i = 0; i < 200; ++i) once();
  EXPECT_EQ(warm.count(), 0u);
}

}  // namespace
}  // namespace hapticell::collision
