// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/swept_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "collision/queries/motion_check.h"
#include "collision/queries/proximity_query.h"
#include "tests/collision/queries/meshes.h"
#include "collision/queries/triangle_gap.h"

namespace hapticell::collision {
namespace {

TEST(SweptCheck, WhatItProvesHoldsAtEveryMoment) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> share(0.0, 0.3);
  const auto a = MeshCollider::build(test::sphereMesh(0.1, 6, 9)),
             b = MeshCollider::build(test::soupMesh(random, 60, 0.3));
  ProximityQuery query(a, b);
  int proven = 0;
  for (int i = 0; i < 1500; ++i) {
    const Pose X_WA0 = test::randomPose(random, 0.5), X_WB0 = test::randomPose(random, 0.1);
    const Pose X_WA1 = interpolate(X_WA0, test::randomPose(random, 0.5), share(random));
    const Pose X_WB1 = interpolate(X_WB0, test::randomPose(random, 0.1), share(random));
    const PartMotion motion_a = straightMotion(X_WA0, X_WA1, *a), motion_b = straightMotion(X_WB0, X_WB1, *b);
    const SweptPair sweep{X_WA0,
                          X_WA1,
                          X_WB0,
                          X_WB1,
                          motion_a.path_bound + motion_b.path_bound,
                          (motion_a.bend_bound + motion_b.bend_bound) / 8.0};
    const double least = 0.01;
    if (!staysApart(*a, *b, sweep, least)) continue;
    ++proven;
    for (int k = 0; k <= 50; ++k) {
      const DistanceResult here = query.distance(motion_a.at(k / 50.0), motion_b.at(k / 50.0));
      ASSERT_GE(here.contained ? least : here.distance, least - 1e-12) << i << " at " << k;
    }
  }
  EXPECT_GT(proven, 100);
}

TEST(SweptCheck, UnknownBendProvesNothing) {
  const auto box = MeshCollider::build(test::boxMesh({1, 1, 1}));
  const Pose X_far = Pose::translation({2, 0, 0});
  EXPECT_TRUE(staysApart(*box, *box, {{}, {}, X_far, X_far, 0.0, 0.0}, 0.1));
  EXPECT_FALSE(staysApart(*box, *box, {{}, {}, X_far, X_far, 0.0, std::numeric_limits<double>::infinity()}, 0.1));
  EXPECT_FALSE(staysApart(*box, *box, {{}, {}, X_far, {}, 2.0, 0.0}, 0.1));
}

TEST(TriangleGap, AlongTheShortestWayIsTheDistanceAndAlongNoOtherMore) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  int apart = 0;
  for (int i = 0; i < 200; ++i) {
    const dvec3 away = 1.5 * point();
    const Corners a{point() + away, point() + away, point() + away}, b{point(), point(), point()};
    const NearestPair nearest = triangleDistance(a, b);
    const double distance = std::sqrt(nearest.squared);
    EXPECT_LE(gapAlong(glm::normalize(point()), a, b), distance + 1e-12);
    if (distance < 1e-3) continue;
    ++apart;
    EXPECT_NEAR(gapAlong((nearest.p - nearest.q) / distance, a, b), distance, 1e-9);
  }
  EXPECT_GT(apart, 50);
}

}  // namespace
}  // namespace hapticell::collision
