// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/sweep_search.h"

#include <gtest/gtest.h>

#include "collision/queries/mesh_search.h"
#include "collision/queries/scene.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

TEST(SweepSearch, WhatItProvesHoldsAllAlongTheSweep) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto a = MeshCollider::build(test::soupMesh(random, 200, 0.1)),
             b = MeshCollider::build(test::soupMesh(random, 300, 0.3));
  int proven = 0, met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose X_WA = test::randomPose(random, 0.5), X_WB = test::randomPose(random, 0.1);
    const dvec3 sweep_W = test::randomPose(random, 0.4 * share(random)).p;
    const double margin = 0.05 * share(random);
    ProximityQuery query(a, b);
    const bool may_meet = query.mayMeet(X_WA, X_WB, sweep_W, margin);
    double least = 1.0;
    std::vector<TrianglePair> near;
    for (int k = -20; k <= 20; ++k) {
      const Pose X_WThere{X_WA.p + k / 20.0 * sweep_W, X_WA.q};
      near.clear();
      // By the triangles alone, as what is inside the other is no matter here.
      trianglePairsWithin(*a, *b, X_WThere.inverse() * X_WB, margin, near, 1);
      if (!near.empty()) least = std::min(least, near.front().distance);
    }
    if (may_meet) {
      ++met;
      EXPECT_LE(distance(a, X_WA, b, X_WB).distance, margin + glm::length(sweep_W) + 1e-9) << i;
    } else {
      ++proven;
      EXPECT_GE(least, margin) << i;
    }
    if (!query.mayMeet(X_WA, X_WB, sweep_W, margin, 3)) {
      EXPECT_FALSE(may_meet) << "little effort proves nothing that is not so";
    }
  }
  EXPECT_GT(proven, 300);
  EXPECT_GT(met, 300);
}

TEST(SweepSearch, PassesBesideWithoutMeeting) {
  const auto box = MeshCollider::build(test::boxMesh({0.1, 0.1, 0.1}));
  const Pose X_beside = Pose::translation({0, 0.12, 0});
  ProximityQuery query(box, box);
  EXPECT_FALSE(query.mayMeet({}, X_beside, {1.0, 0, 0}, 0.01)) << "along itself only";
  EXPECT_TRUE(query.mayMeet({}, X_beside, {1.0, 0, 0}, 0.03));
  EXPECT_TRUE(query.mayMeet(Pose::translation({-0.5, 0, 0}), {}, {0.6, 0, 0}, 0.01));
  EXPECT_TRUE(query.mayMeet(Pose::translation({0.5, 0, 0}), {}, {0.6, 0, 0}, 0.01)) << "to both sides";
}

/// Two bodies that turn and bend on their ways, past and through a thin wall; sampled far finer than the wall is thick.
TEST(SceneMotion, NothingPassesAndNothingStopsEarly) {
  std::mt19937 random(43);
  const auto bar = MeshCollider::build(test::boxMesh({0.3, 0.02, 0.02})),
             wall = MeshCollider::build(test::boxMesh({0.001, 0.4, 0.4}));
  int stopped = 0, passed = 0;
  for (int i = 0; i < 800; ++i) {
    Scene scene;
    const PartIndex a = scene.addPart({0, 0}, bar), b = scene.addPart({0, 1}, bar), w = scene.addPart({1, 0}, wall);
    scene.addPair(a, w);
    scene.addPair(b, w);
    scene.addPair(a, b);
    std::vector<MovedPart> moved;
    for (const PartIndex part : {a, b}) {
      const Pose X_WStart = Pose::translation({-0.6, part == a ? -0.2 : 0.2, 0}) * test::randomPose(random, 0.05);
      // About a joint, as a link moves: no straight motion.
      const dvec3 axis = glm::normalize(test::randomPose(random, 1.0).p), p_WJ = test::randomPose(random, 0.8).p;
      const double angle = 1.2;
      double reach = 0.0;
      for (const dvec3& corner : bar->mesh().vertices) reach = std::max(reach, glm::distance(X_WStart * corner, p_WJ));
      PartMotion motion;
      motion.path_bound = angle * reach;
      motion.bend_bound = angle * angle * reach;
      motion.along = [X_WStart, axis, p_WJ, angle](double s) {
        const dquat q = quaternionFromRotationVector(s * angle * axis);
        return Pose{p_WJ + q * (X_WStart.p - p_WJ), glm::normalize(q * X_WStart.q)};
      };
      moved.push_back({part, motion});
    }
    const SceneStop stop = scene.advance(moved, 0.0);
    if (stop.began_colliding) continue;
    const auto collideAt = [&](double s) {
      for (const MovedPart& part : moved) scene.setPose(part.part, part.motion.at(s));
      return scene.collides();
    };
    constexpr int kSamples = 1000;
    for (int k = 0; k <= kSamples; ++k) ASSERT_FALSE(collideAt(stop.s * k / kSamples)) << i << " at " << k;
    stop.stopped ? ++stopped : ++passed;
    if (!stop.stopped) continue;
    for (const MovedPart& part : moved) scene.setPose(part.part, part.motion.at(stop.s));
    EXPECT_LT(scene.distance(stop.pair).distance, 3e-6) << i;
  }
  EXPECT_GT(stopped, 50);
  EXPECT_GT(passed, 50);
}

}  // namespace
}  // namespace hapticell::collision
