// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/motion_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "collision/queries/motion_bound.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using test::boxMesh;

using Collider = std::shared_ptr<const MeshCollider>;

Pose randomTurn(std::mt19937& random, double angle) {
  std::normal_distribution<double> normal;
  const dvec3 axis = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
  return Pose::rotation(quaternionFromRotationVector(angle * axis));
}

TEST(MotionBound, HoldsForEveryPointOfTheBody) {
  std::mt19937 random(7);
  const Collider body = MeshCollider::build(test::soupMesh(random, 60, 0.3));
  for (int i = 0; i < 300; ++i) {
    const Pose X_WB0 = test::randomPose(random, 2.0), X_WB1 = test::randomPose(random, 2.0);
    const double chord = motionBound(X_WB0, X_WB1, body->center(), body->radius());
    const double path = pathBound(X_WB0, X_WB1, body->center(), body->radius());
    for (const dvec3& p_BV : body->mesh().vertices) {
      EXPECT_LE(glm::distance(X_WB0 * p_BV, X_WB1 * p_BV), chord + 1e-12);
      double length = 0.0;
      for (int k = 0; k < 20; ++k) {
        length +=
            glm::distance(interpolate(X_WB0, X_WB1, k / 20.0) * p_BV, interpolate(X_WB0, X_WB1, (k + 1) / 20.0) * p_BV);
      }
      EXPECT_LE(length, path + 1e-12);
    }
  }
}

TEST(MotionBound, IsTightForABodyTurningAboutItsOwnMiddleFarFromItsOrigin) {
  const dvec3 p_BS(20, 0, 0);
  const dquat turn = quaternionFromRotationVector({0, 0, 0.01});
  const Pose X_WB1{p_BS - turn * p_BS, turn};
  EXPECT_LT(pathBound({}, X_WB1, p_BS, 0.1), 0.004) << "1 mm at the rim, and what the straight path of the origin adds";
}

TEST(Advance, StopsAtTheClearanceBeforeAWall) {
  ProximityQuery query(MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), MeshCollider::build(boxMesh({0.2, 1, 1})));
  const PartMotion motion = straightMotion(Pose::translation({-0.5, 0, 0}), Pose::translation({0.5, 0, 0}), query.a());
  const MotionStop stop = advance(query, motion, standingStill({}), {0.01});
  EXPECT_TRUE(stop.stopped);
  EXPECT_NEAR(stop.s, 0.5 - 0.15 - 0.01, 1e-6);
  EXPECT_NEAR(stop.nearest.nhat_BA_W.x, -1.0, 1e-9);
  const MotionStop touch = advance(query, motion, standingStill({}), {0.0});
  EXPECT_NEAR(touch.s, 0.35, 3e-6);
  EXPECT_LT(touch.s, 0.35);
}

/// HAPTICELL_SWEEPS: 100000 for the full run.
int sweepsAskedFor() {
  const char* asked = std::getenv("HAPTICELL_SWEEPS");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : 20000;
}

TEST(Advance, NothingPassesThroughAThinPlate) {
  std::mt19937 random(11);
  const Collider plate = MeshCollider::build(boxMesh({2.0, 2.0, 0.001})),
                 tool = MeshCollider::build(boxMesh({0.2, 0.05, 0.02}));
  ProximityQuery query(tool, plate), after(tool, plate);
  std::uniform_real_distribution<double> height(0.12, 0.5), across(-0.3, 0.3), angle(0.0, 0.5 * std::numbers::pi);
  int crossing = 0;
  for (int i = 0; i < sweepsAskedFor(); ++i) {
    const Pose X_WStart{{across(random), across(random), height(random)}, randomTurn(random, angle(random)).q};
    Pose X_WEnd{{across(random), across(random), X_WStart.p.z - 1.0},
                glm::normalize(randomTurn(random, angle(random)).q * X_WStart.q)};
    const MotionStop stop = advance(query, straightMotion(X_WStart, X_WEnd, *tool), standingStill({}), {0.0005});
    ASSERT_TRUE(stop.stopped) << i;
    const Pose X_WStop = interpolate(X_WStart, X_WEnd, stop.s);
    ASSERT_GT(X_WStop.p.z, 0.0) << "beyond the plate at " << i;
    const DistanceResult there = after.distance(X_WStop, {});
    ASSERT_GE(there.distance, 0.0005 - 1e-9) << i;
    ASSERT_LE(there.distance, 0.0005 + 1e-6) << "stops where it must, not before, at " << i;
    ++crossing;
  }
  EXPECT_EQ(crossing, sweepsAskedFor());
}

TEST(Advance, SlidesAlongAndLeavesFromNearerThanTheClearance) {
  ProximityQuery query(MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), MeshCollider::build(boxMesh({1, 1, 0.2})));
  const Pose X_WStart = Pose::translation({0, 0, 0.1502});  // 0.2 mm above the table, with 1 mm asked for.
  const auto to = [&](const dvec3& by) {
    return advance(query, straightMotion(X_WStart, Pose::translation(X_WStart.p + by), query.a()), standingStill({}),
                   {0.001});
  };
  EXPECT_FALSE(to({0.05, 0, 0}).stopped);
  EXPECT_FALSE(to({2, 0, 0}).stopped) << "over the edge and on";
  EXPECT_FALSE(to({0, 0.01, 0.05}).stopped);
  EXPECT_FALSE(to({0, 0, 1}).stopped);
  const MotionStop down = to({0, 0, -0.01});
  EXPECT_TRUE(down.stopped);
  EXPECT_LT(down.s, 1e-4);
}

TEST(Advance, SlidingForLongDoesNotWearTheClearanceAway) {
  ProximityQuery query(MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), MeshCollider::build(boxMesh({1, 1, 0.2})));
  Pose X_WT = Pose::translation({0, 0, 0.152});
  for (int i = 0; i < 2000; ++i) {
    const dvec3 press(0.0002 * std::sin(0.01 * i), 0.0002 * std::cos(0.013 * i), -0.0003);
    const Pose X_WNext = Pose::translation(X_WT.p + press);
    const MotionStop stop = advance(query, straightMotion(X_WT, X_WNext, query.a()), standingStill({}), {0.001});
    X_WT = interpolate(X_WT, X_WNext, stop.s);
  }
  EXPECT_GE(query.distance(X_WT, {}).distance, 0.001 - 1e-7);
}

TEST(Advance, SlidesFarOverAFinelyCutPlane) {
  ProximityQuery query(MeshCollider::build(test::sphereMesh(0.05, 16, 24)),
                       MeshCollider::build(test::sheetMesh(1.0, 60, 0.0)));
  const Pose X_WStart = Pose::translation({-0.3, 0.01, 0.0502});
  const MotionStop slid = advance(query, straightMotion(X_WStart, Pose::translation({0.3, 0.02, 0.0502}), query.a()),
                                  standingStill({}), {0.001});
  EXPECT_FALSE(slid.stopped);
  const Pose X_WTurned{{-0.28, 0.01, 0.0502}, quaternionFromRotationVector({0, 0, 0.4})};
  EXPECT_FALSE(advance(query, straightMotion(X_WStart, X_WTurned, query.a()), standingStill({}), {0.001}).stopped);
}

TEST(Advance, ALongSlideStopsAtAStep) {
  geometry::TriangleMesh floor = boxMesh({1, 1, 0.2});
  geometry::append(floor, boxMesh({0.001, 1, 0.02}), Pose::translation({0.3, 0, 0.11}));
  ProximityQuery query(MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), MeshCollider::build(floor));
  const Pose X_WStart = Pose::translation({-0.3, 0, 0.1505});
  const MotionStop stop = advance(query, straightMotion(X_WStart, Pose::translation({0.7, 0, 0.1505}), query.a()),
                                  standingStill({}), {0.0005});
  EXPECT_TRUE(stop.stopped);
  EXPECT_NEAR(stop.s, 0.6 - 0.0005 - 0.05 - 0.0005, 1e-6);
}

TEST(Advance, PartsThatBeginCollidingMayLeave) {
  ProximityQuery query(MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), MeshCollider::build(boxMesh({0.2, 1, 1})));
  const PartMotion out = straightMotion({}, Pose::translation({-0.5, 0, 0}), query.a());
  const MotionStop left = advance(query, out, standingStill({}), {0.001});
  EXPECT_TRUE(left.began_colliding);
  EXPECT_FALSE(left.stopped);
  PartMotion and_back = out;
  and_back.along = [](double s) { return Pose::translation({-0.8 * (s < 0.5 ? s : 1.0 - s), 0, 0}); };
  and_back.path_bound = 0.8;
  const MotionStop back = advance(query, and_back, standingStill({}), {0.001});
  EXPECT_TRUE(back.stopped) << "once out it does not come in again";
  EXPECT_GT(back.s, 0.5);
  EXPECT_GE(query.distance(and_back.at(back.s), {}).distance, 0.0);
}

TEST(Advance, BothPartsMayMove) {
  const Collider box = MeshCollider::build(boxMesh({0.1, 0.1, 0.1}));
  ProximityQuery query(box, box);
  const PartMotion left = straightMotion(Pose::translation({-0.5, 0, 0}), Pose::translation({0.5, 0, 0}), *box);
  const PartMotion right = straightMotion(Pose::translation({0.5, 0, 0}), Pose::translation({-0.5, 0, 0}), *box);
  const MotionStop stop = advance(query, left, right, {0.0});
  EXPECT_NEAR(stop.s, 0.45, 1e-5);
  const PartMotion along = straightMotion(Pose::translation({0.5, 0, 0}), Pose::translation({1.5, 0, 0}), *box);
  EXPECT_FALSE(advance(query, left, along, {0.0}).stopped);
}

}  // namespace
}  // namespace hapticell::collision
