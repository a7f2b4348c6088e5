// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/force_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/haptic/rendering/rendered_floor.h"

namespace hapticell::haptic {
namespace {

TEST(LimitedByDelay, FollowsTheTrialsTable) {
  RendererOptions options;
  options.stiffness = 5000.0;
  EXPECT_NEAR(limitedByDelay(options).stiffness, 1495.0, 1e-9);
  options.delay = 0.003;
  EXPECT_NEAR(limitedByDelay(options).stiffness, 498.3, 0.1);
  EXPECT_EQ(limitedByDelay(options).damping, 4.0);
  options = {};
  EXPECT_EQ(limitedByDelay(options).stiffness, 1000.0);
  EXPECT_EQ(limitedByDelay(options).damping, 2.0);
  options.stiffness = kNan;
  options.damping = -1.0;
  EXPECT_EQ(limitedByDelay(options).stiffness, 1000.0);
  EXPECT_EQ(limitedByDelay(options).damping, 2.0);
}

TEST(ForceRenderer, FollowsTheStylusWithoutASet) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  const RenderResult result = renderer.tick(at(0.3, 0.1, -0.2), kTick);
  EXPECT_EQ(result.X_DP.p, dvec3(0.3, 0.1, -0.2));
  EXPECT_EQ(result.force_D, dvec3(0.0));
}

TEST(ForceRenderer, PushesOutOfAFloorWithItsStiffness) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ASSERT_EQ(renderer.adopt(floorSet(1)), Adoption::kAdopted);
  const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0.01, 0, -0.002));
  EXPECT_NEAR(result.force_D.z, 2.0, 1e-3);
  EXPECT_NEAR(result.force_D.x, 0.0, 1e-9);
  EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-8);
  EXPECT_NEAR(result.X_DP.p.x, 0.01, 1e-9);
  EXPECT_TRUE(result.contact);
  EXPECT_FALSE(result.at_zone_edge);
  EXPECT_EQ(result.active_rows, 1u);
  EXPECT_EQ(result.adopted_set, 1u);
}

TEST(ForceRenderer, NeverPulls) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  for (int i = 0; i < 30; ++i) {  // Out at 0.1 m/s: the damper alone would hold back.
    const RenderResult result = renderer.tick(at(0, 0, -0.001 + 1e-4 * i), kTick);
    EXPECT_GE(result.force_D.z, 0.0);
  }
}

/// Walls that come up where the hand is already, each turned another way: what of them is held back stands in the
/// offset, so the spring may point anywhere for a while. What damps must not pull at the hand then either.
TEST(ForceRenderer, NeverPullsWhileAnOffsetFades) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  ForceRenderer renderer;
  Pose X_DS = at(0, 0, 0.002);
  renderer.reset(X_DS);
  dvec3 v(0.0), proxy = X_DS.p;
  int pressed = 0;
  for (int i = 0; i < 20000; ++i) {
    if (i % 20 == 0) {
      const dvec3 normal = glm::normalize(dvec3(0.8 * any(random), 0.8 * any(random), 1.0));
      ConstraintSet set = floorSet(static_cast<std::uint64_t>(i + 1));
      set.constraints[0] = planeConstraint(dvec3(0, 0, 0.001 * any(random)), normal, set.X_DR, 0);
      renderer.adopt(set);
      v = 0.2 * dvec3(any(random), any(random), any(random)) - 10.0 * X_DS.p;
    }
    X_DS.p += kTick * v;
    const RenderResult result = renderer.tick(X_DS, kTick);
    const dvec3 stretch = result.X_DP.p - X_DS.p;
    const bool arrived = glm::distance(result.X_DP.p, proxy) < 0.0019;  // Else its way is not all of the stretch.
    proxy = result.X_DP.p;
    if (result.at_zone_edge || !result.contact || !arrived || glm::length(stretch) < 1e-5) continue;
    const dvec3 outward = glm::normalize(stretch);
    EXPECT_GE(glm::dot(result.force_D, outward), std::min(0.0, glm::dot(result.spring_D, outward)) - 1e-9) << i;
    ++pressed;
  }
  EXPECT_GT(pressed, 2000);
}

TEST(ForceRenderer, RefusesSetsThatDoNotFit) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  EXPECT_EQ(renderer.adopt(floorSet(5)), Adoption::kAdopted);
  renderer.tick(at(0, 0, 0.005), kTick);
  EXPECT_EQ(renderer.adopt(floorSet(4)), Adoption::kOutdated);
  EXPECT_EQ(renderer.adopt(floorSet(6, 0.0, dvec3(0.1, 0, 0))), Adoption::kOutsideZone);
  ConstraintSet bad = floorSet(7);
  bad.constraints[0].curvature[3] = kNan;
  EXPECT_EQ(renderer.adopt(bad), Adoption::kMalformed);
  EXPECT_EQ(renderer.tick(at(0, 0, 0.005), kTick).adopted_set, 5u);
}

TEST(ForceRenderer, DropsAForceThatANewSetTakesAwaySlowlyThenExactly) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.004));
  ConstraintSet empty = floorSet(2);
  empty.count = 0;
  renderer.adopt(empty);
  double last = result.force_D.z;
  int ticks = 0;
  while (result.force_D != dvec3(0.0) && ticks < 1000) {
    result = renderer.tick(at(0, 0, -0.004), kTick);
    EXPECT_LE(std::abs(result.force_D.z - last), 0.0501);
    last = result.force_D.z;
    ++ticks;
  }
  EXPECT_LE(ticks, 150);
}

/// A hand at 0.2 m/s that leaves the zone in free air before the next set has come, and is let go by it.
TEST(ForceRenderer, MeetsTheEdgeOfAZoneWithoutAStep) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.05));
  ConstraintSet set = floorSet(1, 0.0, dvec3(0, 0, 0.05));
  set.zone_radius = 0.01;
  ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
  dvec3 before(0.0);
  double largest = 0.0, worst = 0.0;
  for (int i = 1; i <= 120; ++i) {
    const double x = 0.2e-3 * i;
    if (i == 70) {
      ASSERT_EQ(renderer.adopt(floorSet(2, 0.0, dvec3(0.0095, 0, 0.05))), Adoption::kAdopted);
    }
    const RenderResult result = renderer.tick(at(x, 0, 0.05), kTick);
    EXPECT_LE(result.force_D.x, 1e-9) << "never pushed on";
    worst = std::max(worst, glm::length(result.force_D - before));
    largest = std::max(largest, glm::length(result.force_D));
    before = result.force_D;
  }
  EXPECT_GT(largest, 0.3);
  EXPECT_LE(largest, 0.8 + 1e-9);
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(glm::length(before), 1e-9);
}

/// The zone's edge stops a proxy that slides on a floor: nothing was struck, so no damper answers either.
TEST(ForceRenderer, DampsNothingAtTheEdgeOfAZone) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ConstraintSet set = floorSet(1);
  set.zone_radius = 0.02;
  ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
  dvec3 before = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.002)).force_D;
  double worst = 0.0;
  bool edge = false;
  for (int i = 1; i <= 250; ++i) {
    const RenderResult result = renderer.tick(at(1e-4 * i, 0, -0.002), kTick);
    worst = std::max(worst, glm::length(result.force_D - before));
    before = result.force_D;
    edge = edge || result.at_zone_edge;
  }
  EXPECT_TRUE(edge);
  EXPECT_LT(worst, 0.05);
}

TEST(ForceRenderer, SoftensWhereTheMaterialAsksForIt) {
  ConstraintSet set = floorSet(1);
  set.constraints[0].stiffness = 400.0;
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.002), 200, 400);
  EXPECT_NEAR(result.force_D.z, 0.8, 1e-3);
}

TEST(ForceRenderer, SurvivesWrongPosesAndTimes) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  Pose bad = at(0, 0, -0.001);
  bad.p.x = kNan;
  for (const double dt : {kTick, 0.0, -1.0, kNan, 1e9}) {
    const RenderResult result = renderer.tick(bad, dt);
    EXPECT_TRUE(std::isfinite(glm::length(result.force_D)));
    EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-6);
  }
  EXPECT_NEAR(moveTo(renderer, dvec3(0, 0, -0.001), dvec3(0, 0, -0.001)).force_D.z, 1.0, 1e-3);
}

}  // namespace
}  // namespace hapticell::haptic
