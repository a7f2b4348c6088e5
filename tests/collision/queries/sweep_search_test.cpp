// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/sweep_search.h"

#include <gtest/gtest.h>

#include "collision/queries/mesh_search.h"
#include "collision/queries/motion_bound.h"
#include "collision/queries/scene.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

/// The mesh in the world where each point has gone by that share of the sweep, by itself.
geometry::TriangleMesh placed(const MeshCollider& part, const SweptPose& swept, double share) {
  geometry::TriangleMesh mesh = part.mesh();
  const dvec3 middle_W = swept.X_WP * part.center();
  for (dvec3& p : mesh.vertices) {
    const dvec3 p_W = swept.X_WP * p;
    p = p_W + share * (swept.sweep.d_W + glm::cross(swept.sweep.turn_W, p_W - middle_W));
  }
  return mesh;
}

TEST(SweepSearch, WhatItProvesHoldsAllAlongTheSweep) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto a = MeshCollider::build(test::soupMesh(random, 200, 0.1)),
             b = MeshCollider::build(test::soupMesh(random, 300, 0.3));
  int proven = 0, met = 0, proven_turning = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose X_WA = test::randomPose(random, 0.5), X_WB = test::randomPose(random, 0.1);
    const double margin = 0.05 * share(random);
    const bool turns = i % 2 == 0;
    const auto turn = [&] { return turns ? test::randomPose(random, 0.3 * share(random)).p : dvec3(0.0); };
    const SweptPose swept_a{X_WA, {test::randomPose(random, 0.4 * share(random)).p, turn()}},
        swept_b{X_WB, {test::randomPose(random, 0.1 * share(random)).p, turn()}};
    ProximityQuery query(a, b);
    const bool may_meet = query.mayMeet(swept_a, swept_b, margin);
    if (may_meet) {
      ++met;
      const double way = glm::length(swept_a.sweep.d_W - swept_b.sweep.d_W) +
                         glm::length(swept_a.sweep.turn_W) * a->radius() +
                         glm::length(swept_b.sweep.turn_W) * b->radius();
      EXPECT_LE(distance(a, X_WA, b, X_WB).distance, margin + way + 1e-9) << i;
    } else {
      ++proven;
      proven_turning += turns ? 1 : 0;
      for (int k = -4; k <= 4; ++k) {
        const auto a_there = MeshCollider::build(placed(*a, swept_a, k / 4.0)),
                   b_there = MeshCollider::build(placed(*b, swept_b, k / 4.0));
        std::vector<TrianglePair> near;
        // By the triangles alone, as what is inside the other is no matter here.
        trianglePairsWithin(*a_there, *b_there, Pose::identity(), margin, near, 1);
        EXPECT_TRUE(near.empty()) << i << " at " << k;
      }
    }
    if (!query.mayMeet(swept_a, swept_b, margin, 3)) {
      EXPECT_FALSE(may_meet) << "little effort proves nothing that is not so";
    }
  }
  EXPECT_GT(proven, 300);
  EXPECT_GT(proven_turning, 100);
  EXPECT_GT(met, 300);
}

TEST(SweepSearch, PassesBesideWithoutMeeting) {
  const auto box = MeshCollider::build(test::boxMesh({0.1, 0.1, 0.1}));
  const Pose X_beside = Pose::translation({0, 0.12, 0});
  ProximityQuery query(box, box);
  const Pose X_here, X_before = Pose::translation({-0.5, 0, 0}), X_behind = Pose::translation({0.5, 0, 0});
  const PartSweep far{{1.0, 0, 0}, {}}, near{{0.6, 0, 0}, {}};
  EXPECT_FALSE(query.mayMeet({X_here, far}, {X_beside}, 0.01)) << "along itself only";
  EXPECT_TRUE(query.mayMeet({X_here, far}, {X_beside}, 0.03));
  EXPECT_TRUE(query.mayMeet({X_before, near}, {X_here}, 0.01));
  EXPECT_TRUE(query.mayMeet({X_behind, near}, {X_here}, 0.01)) << "to both sides";
  EXPECT_FALSE(query.mayMeet({X_here, far}, {X_beside, far}, 0.01)) << "both together";
}

/// A sheet that turns about its middle hardly moves there: a post above it is passed, one at the end is met.
TEST(SweepSearch, TurningMovesWhatIsFarFromTheMiddle) {
  const auto sheet = MeshCollider::build(test::sheetMesh(1.0, 50, 0.0));
  const auto post = MeshCollider::build(test::boxMesh({0.02, 0.02, 0.5}));
  ProximityQuery query(sheet, post);
  const Pose X_here, X_beside = Pose::translation({0.1, 0, 0.28}), X_at_end = Pose::translation({0.45, 0, 0.28});
  const PartSweep turn{{}, {0, 0.1, 0}};
  EXPECT_FALSE(query.mayMeet({X_here, turn}, {X_beside}, 0.001));
  EXPECT_TRUE(query.mayMeet({X_here, turn}, {X_at_end}, 0.001));
}

TEST(MotionBound, ATurnIsWhatItsPartsSay) {
  std::mt19937 random(42);
  for (int i = 0; i < 1000; ++i) {
    const Pose X_WB0 = test::randomPose(random, 1.0), X_WB1 = test::randomPose(random, 1.0);
    const Turn turn = turnOf(X_WB0, X_WB1);
    const dvec3 r_B = test::randomPose(random, 1.0).p, r_W = X_WB0.rotate(r_B), gone = X_WB1.rotate(r_B) - r_W;
    EXPECT_LE(glm::length(gone - glm::cross(turn.w_W, r_W)), turn.bent * glm::length(r_W) + 1e-12);
    EXPECT_LE(glm::length(gone), turn.chord * glm::length(r_W) + 1e-12);
  }
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
