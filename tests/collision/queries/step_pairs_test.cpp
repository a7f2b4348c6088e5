// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/step_pairs.h"

#include <gtest/gtest.h>

#include "collision/queries/proximity_query.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

TEST(StepPairs, AfterSmallStepsTheAnswersAreThoseOfANewSearch) {
  std::mt19937 random(8);
  const auto a = MeshCollider::build(test::sheetMesh(0.4, 30, 0.03)),
             b = MeshCollider::build(test::sphereMesh(0.08, 16, 30));
  ProximityQuery warm(a, b);
  for (int way = 0; way < 20; ++way) {
    Pose X_WB{{0.1, -0.1, 0.13}, test::randomPose(random, 1.0).q};
    const Pose by = test::randomPose(random, 4e-4);
    for (int step = 0; step < 200; ++step) {
      X_WB = {X_WB.p + by.p, glm::normalize(quaternionFromRotationVector(3.0 * by.p) * X_WB.q)};
      const DistanceResult expected = distance(a, {}, b, X_WB), found = warm.distance({}, X_WB);
      ASSERT_EQ(found.colliding, expected.colliding);
      ASSERT_NEAR(found.distance, expected.distance, 1e-9);
      ASSERT_NEAR(glm::distance(found.p_WA, found.p_WB), found.distance, 1e-9);
      ASSERT_EQ(warm.distance({}, X_WB, 0.02).beyond_limit, expected.distance >= 0.02);
      ASSERT_EQ(warm.within({}, X_WB, 0.01), expected.distance <= 0.01);
      ASSERT_EQ(warm.collides({}, X_WB), expected.colliding);
    }
  }
}

TEST(StepPairs, TheLeverIsTheSmallerBodysAndBoundsEveryPoint) {
  std::mt19937 random(9);
  const auto small = MeshCollider::build(test::boxMesh({0.1, 0.02, 0.02})),
             large = MeshCollider::build(test::boxMesh({2.0, 1.0, 1.0}));
  for (const bool swapped : {false, true}) {
    const MeshCollider &a = swapped ? *large : *small, &b = swapped ? *small : *large;
    const MotionLever lever = leverOf(a, b);
    EXPECT_EQ(lever.is_a, !swapped);
    for (int i = 0; i < 200; ++i) {
      const Pose X0 = test::randomPose(random, 1.0);
      const Pose X1 = X0 * Pose{0.1 * test::randomPose(random, 1.0).p, glm::normalize(dquat(1.0, 0.1, 0.02, -0.05))};
      const double bound = motionBound(lever, X0, X1);
      const Pose from = swapped ? X0 : X0.inverse(), to = swapped ? X1 : X1.inverse();
      for (const dvec3& p : small->mesh().vertices) EXPECT_LE(glm::distance(from * p, to * p), bound + 1e-12);
    }
  }
}

TEST(StepPairs, AListOfTooManyIsNone) {
  StepPairs list({{0, 0, 0}, 0.1, false});
  EXPECT_LT(list.come({}), 0.0);
  list.come(Pose::translation({1e-4, 0, 0}));
  EXPECT_GT(list.begin(), 1e-4);
  for (std::uint32_t i = 0; i < StepPairs::kMostOnTheWay; ++i) EXPECT_TRUE(list.add({i, i}, 0.1F));
  EXPECT_FALSE(list.add({0, 1}, 0.1F));
  list.giveUp();
  EXPECT_LT(list.reachAt({}), 0.0);
  list.begin();
  list.add({1, 2}, 0.003F);
  list.add({3, 4}, 0.002F);
  list.add({5, 6}, 0.02F);
  list.finish(0.01);
  ASSERT_EQ(list.pairs().size(), 2u);
  EXPECT_EQ(list.pairs()[0].pair.a, 3u);
  EXPECT_NEAR(list.reachAt(Pose::translation({1e-4 + 1e-3, 0, 0})), 0.009, 1e-12);
}

}  // namespace
}  // namespace hapticell::collision
