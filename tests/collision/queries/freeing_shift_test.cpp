// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/freeing_shift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using geometry::TriangleMesh;
using test::boxMesh;

/// Shifted as told, the parts are free; by half of it they are not.
void expectFrees(ProximityQuery& query, const Pose& X_WA, const FreeingShift& shift) {
  ASSERT_TRUE(shift.found);
  EXPECT_NEAR(glm::length(shift.direction_W), 1.0, 1e-12);
  EXPECT_FALSE(query.collides({X_WA.p + shift.depth * shift.direction_W, X_WA.q}, {}));
}

TEST(FreeingShift, BoxesComeFreeThroughTheNearestFace) {
  ProximityQuery query(MeshCollider::build(boxMesh({0.2, 0.2, 0.2})), MeshCollider::build(boxMesh({1.0, 1.0, 0.5})));
  const Pose X_WA = Pose::translation({0.1, 0.05, 0.33});  // 2 cm deep in the top
  const FreeingShift shift = freeingShift(query, X_WA, {});
  expectFrees(query, X_WA, shift);
  EXPECT_NEAR(shift.depth, 0.02, 1e-4);
  EXPECT_NEAR(shift.direction_W.z, 1.0, 1e-9);
  EXPECT_FALSE(shift.by_winding);
  EXPECT_FALSE(freeingShift(query, Pose::translation({0, 0, 0.36}), {}).found) << "nothing to free";
}

TEST(FreeingShift, APartWhollyInsideComesOut) {
  ProximityQuery query(MeshCollider::build(test::sphereMesh(0.05)), MeshCollider::build(boxMesh({1.0, 1.0, 0.5})));
  const Pose X_WA = Pose::translation({0.02, 0.3, 0.1});
  const FreeingShift shift = freeingShift(query, X_WA, {});
  expectFrees(query, X_WA, shift);
  EXPECT_NEAR(shift.depth, 0.2, 1e-3) << "up, 15 cm and the radius";
}

TEST(FreeingShift, RandomConvexPairsComeFreeByLittleMoreThanTheLeast) {
  std::mt19937 random(31);
  const auto ball = MeshCollider::build(test::sphereMesh(0.1, 20, 30)),
             box = MeshCollider::build(boxMesh({0.4, 0.3, 0.2}));
  ProximityQuery query(ball, box);
  int freed = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose X_WA = test::randomPose(random, 0.2);
    const FreeingShift shift = freeingShift(query, X_WA, {});
    ASSERT_EQ(shift.found, query.collides(X_WA, {}));
    if (!shift.found) continue;
    expectFrees(query, X_WA, shift);
    // The ball's middle has to get 0.1 m out of the box: through a face, or, where it is outside, straight away.
    const dvec3 half(0.2, 0.15, 0.1), p = X_WA.p;
    const dvec3 out = glm::max(glm::abs(p) - half, dvec3(0.0));
    const dvec3 in = half - glm::abs(p);
    const double least = 0.1 + (glm::length(out) > 0.0 ? -glm::length(out) : std::min({in.x, in.y, in.z}));
    EXPECT_LT(shift.depth, 1.06 * least + 1e-3);
    EXPECT_GT(shift.depth, 0.9 * least - 2e-3);
    ++freed;
  }
  EXPECT_GT(freed, 15);
}

TEST(FreeingShift, AnOpenSoupIsLeftAndNotEntered) {
  TriangleMesh open = boxMesh({0.4, 0.4, 0.4});
  open.triangles.pop_back();  // a hole of one triangle
  ProximityQuery query(MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), MeshCollider::build(open));
  // Nearly all inside: the shortest way without crossing surfaces would be further in.
  const Pose X_WA = Pose::translation({0.03, 0.02, 0.16});
  const FreeingShift shift = freeingShift(query, X_WA, {});
  expectFrees(query, X_WA, shift);
  EXPECT_TRUE(shift.by_winding);
  EXPECT_GT((X_WA.p + shift.depth * shift.direction_W).z, 0.25);
  EXPECT_NEAR(shift.depth, 0.09, 1e-3);
}

TEST(WindingNumber, IsOneInsideAndNoneOutside) {
  const TriangleMesh ball = test::sphereMesh(0.3);
  EXPECT_NEAR(windingNumber(ball, {0.1, 0.05, -0.1}), 1.0, 1e-12);
  EXPECT_NEAR(windingNumber(ball, {0.5, 0.05, -0.1}), 0.0, 1e-12);
  TriangleMesh open = boxMesh({1, 1, 1});
  open.triangles.resize(10);
  EXPECT_NEAR(windingNumber(open, {0, 0, 0}), 5.0 / 6.0, 1e-12) << "a face in six is missing";
}

}  // namespace
}  // namespace hapticell::collision
