// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/listed_sweep.h"

#include <gtest/gtest.h>

#include "collision/queries/motion_check.h"
#include "collision/queries/scene.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using Collider = std::shared_ptr<const MeshCollider>;

TEST(NearPairs, AreThoseThatBruteForceFinds) {
  std::mt19937 random(5);
  const Collider a = MeshCollider::build(test::soupMesh(random, 80, 0.2)),
                 b = MeshCollider::build(test::sphereMesh(0.1, 6, 9));
  for (int i = 0; i < 60; ++i) {
    const Pose X_AB = test::randomPose(random, 0.2);
    NearPairs near;
    if (!near.fill(*a, *b, X_AB, 0.01)) continue;
    std::size_t expected = 0;
    for (std::uint32_t t = 0; t < a->mesh().triangles.size(); ++t) {
      for (std::uint32_t u = 0; u < b->mesh().triangles.size(); ++u) {
        const Corners first{a->mesh().corner(t, 0), a->mesh().corner(t, 1), a->mesh().corner(t, 2)};
        const Corners second{X_AB * b->mesh().corner(u, 0), X_AB * b->mesh().corner(u, 1),
                             X_AB * b->mesh().corner(u, 2)};
        expected += triangleDistance(first, second).squared <= 1e-4;
      }
    }
    EXPECT_EQ(near.pairs().size(), expected) << i;
    EXPECT_DOUBLE_EQ(near.reachAt(X_AB), 0.01);
    const Pose X_ABMoved{X_AB.p + dvec3(0, 0, 0.004), X_AB.q};
    EXPECT_NEAR(near.reachAt(X_ABMoved), 0.006, 1e-12);
  }
}

TEST(NearPairs, TooManyAreNone) {
  const Collider sheet = MeshCollider::build(test::sheetMesh(1.0, 40, 0.0));
  NearPairs near;
  EXPECT_FALSE(near.fill(*sheet, *sheet, Pose::translation({0.003, 0.002, 0.001}), 0.01));
  EXPECT_LT(near.reachAt({}), 0.0);
  EXPECT_LT(near.likelyRadius(), 0.01);
}

/// What any answer must satisfy, whatever the query remembers: measured afresh along the motion.
void expectSound(const Collider& a, const Collider& b, const PartMotion& motion, double kept, const MotionStop& stop,
                 const char* which) {
  ProximityQuery fresh(a, b);
  for (int k = 0; k <= 8; ++k) {
    const double distance = fresh.distance(motion.at(stop.s * k / 8.0), {}).distance;
    ASSERT_GE(distance, k == 8 ? kept - 1e-9 : 0.5 * kept - 1e-9) << which;
    if (k == 8) {
      ASSERT_GE(distance, stop.distance_at_least - 1e-9) << which;
    }
  }
  if (!stop.stopped) return;
  const double beyond = std::min(1.0, stop.s + 4e-7 / motion.path_bound);
  ASSERT_LE(fresh.distance(motion.at(beyond), {}).distance, kept + 1e-6) << which << ": and no earlier than it must";
}

/// A body pushed about on another, by steps of all sizes, from gaps of the clearance itself: the query that remembers
/// its list of near pairs against one that knows nothing.
void wander(const Collider& a, const Collider& b, const dvec3& towards, double clearance, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> magnitude(-4.7, -1.8);
  ProximityQuery warm(a, b);
  Pose X_WA = Pose::translation(-0.35 * towards);
  int stops = 0;
  for (int i = 0; i < 220; ++i) {
    const double size = std::pow(10.0, magnitude(random));
    const dvec3 shift = size * (dvec3(normal(random), normal(random), normal(random)) + 1.2 * towards);
    const dvec3 turn = 3.0 * size * dvec3(normal(random), normal(random), normal(random));
    const Pose X_WEnd{X_WA.p + shift, glm::normalize(quaternionFromRotationVector(turn) * X_WA.q)};
    const PartMotion motion = straightMotion(X_WA, X_WEnd, *a);
    ProximityQuery cold(a, b);
    const double kept = std::min(clearance, cold.distance(X_WA, {}).distance);
    const MotionStop remembered = advance(warm, motion, standingStill({}), {clearance});
    const MotionStop anew = advance(cold, motion, standingStill({}), {clearance});
    expectSound(a, b, motion, kept, remembered, "warm");
    expectSound(a, b, motion, kept, anew, "cold");
    if (testing::Test::HasFatalFailure()) return;
    stops += remembered.stopped;
    X_WA = motion.at(remembered.s);
  }
  EXPECT_GT(stops, 20);
}

TEST(ListedSweep, WarmAndColdAnswersAreSoundOnAWavySheet) {
  const Collider body = MeshCollider::build(test::sphereMesh(0.05, 10, 16)),
                 sheet = MeshCollider::build(test::sheetMesh(1.0, 40, 0.05));
  for (const double clearance : {5e-6, 1e-3}) wander(body, sheet, {0, 0, -1}, clearance, 17);
}

TEST(ListedSweep, WarmAndColdAnswersAreSoundOnASoupOfNeedles) {
  std::mt19937 random(3);
  const Collider body = MeshCollider::build(test::boxMesh({0.1, 0.06, 0.04})),
                 soup = MeshCollider::build(test::soupMesh(random, 300, 0.2));
  for (const double clearance : {5e-6, 1e-3}) wander(body, soup, {1, 0, 0}, clearance, 23);
}

TEST(ListedSweep, AMotionOfUnknownBendIsFollowedToo) {
  const Collider box = MeshCollider::build(test::boxMesh({0.1, 0.1, 0.1}));
  ProximityQuery query(box, box);
  PartMotion swing;
  swing.along = [](double s) { return Pose::translation({0.1001 + 0.001 * std::sin(9.0 * s), 0.002 * s, 0.0}); };
  swing.path_bound = 0.011;
  swing.bend_bound = std::numeric_limits<double>::infinity();
  const MotionStop stop = advance(query, swing, standingStill({}), {5e-6});
  ASSERT_TRUE(stop.stopped);
  EXPECT_NEAR(0.1001 + 0.001 * std::sin(9.0 * stop.s), 0.1 + 5e-6, 2e-7);
}

/// A drag during which obstacles come, go, and are switched off: the scene that remembers against a new one.
TEST(ListedSweep, ASceneEditedDuringADragAnswersAsANewOne) {
  std::mt19937 random(41);
  std::normal_distribution<double> normal;
  const Collider body = MeshCollider::build(test::sphereMesh(0.05, 8, 12)),
                 wall = MeshCollider::build(test::sheetMesh(0.6, 20, 0.03));
  Scene scene;
  const PartIndex moved = scene.addPart({1, 0}, body);
  std::vector<PartIndex> walls;
  for (int i = 0; i < 5; ++i) {
    const Pose X_WP{{0.02 * i, 0, 0.0001 - 0.08 - 0.02 * i}, quaternionFromRotationVector({0.05 * i, 0, 0})};
    walls.push_back(scene.addPart({2, static_cast<std::uint32_t>(i)}, wall, X_WP));
    scene.addPair(moved, walls.back());
  }
  for (int i = 0; i < 200; ++i) {
    if (i % 7 == 3) scene.setEnabled(static_cast<PairIndex>(i % scene.pairCount()), i % 2 == 0);
    if (i % 31 == 30) {
      scene.removePart(walls.back());
      walls.back() = scene.addPart({2, 99}, wall, Pose::translation({0, 0, -0.1}));
      scene.addPair(moved, walls.back());
    }
    const dvec3 by = 0.002 * (dvec3(normal(random), normal(random), normal(random)) + dvec3(0, 0, i < 150 ? -1 : 1));
    const MovedPart motion[] = {
        {moved, straightMotion(scene.pose(moved), Pose::translation(scene.pose(moved).p + by), *body)}};
    Scene anew;
    const PartIndex same = anew.addPart({1, 0}, body, scene.pose(moved));
    for (PairIndex pair = 0; pair < scene.pairCount(); ++pair) {
      if (!scene.isEnabled(pair)) continue;
      anew.addPair(same, anew.addPart({2, pair}, wall, scene.pose(scene.environment(pair))));
    }
    const auto nearest = anew.nearest();
    const double kept = nearest ? std::min(5e-6, nearest->result.distance) : 5e-6;
    const SceneStop stop = scene.advance(motion, 5e-6), expected = anew.advance(motion, 5e-6);
    if (stop.began_colliding) break;
    EXPECT_EQ(stop.began_colliding, expected.began_colliding);
    EXPECT_NEAR(stop.s * glm::length(by), expected.s * glm::length(by), 1e-5) << i;
    const Pose X_WP = motion[0].motion.at(stop.s);
    scene.setPose(moved, X_WP);
    anew.setPose(same, X_WP);
    const auto there = anew.nearest();
    if (there) {
      EXPECT_GE(there->result.distance, kept - 1e-9) << i;
    }
  }
}

}  // namespace
}  // namespace hapticell::collision
