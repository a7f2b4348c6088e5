// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/proxy_mover.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "haptic/rendering/proxy_metric.h"
#include "tests/haptic/rendering/rendered_floor.h"

namespace hapticell::haptic {
namespace {

TEST(ProxyMover, HoldsTheProxyInTheZoneWithLittleForce) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  ConstraintSet set = floorSet(1, -1.0);
  set.zone_radius = 0.02;
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0.0), dvec3(0.06, 0, 0));
  EXPECT_TRUE(result.at_zone_edge);
  EXPECT_FALSE(result.contact);
  EXPECT_NEAR(result.X_DP.p.x, kTrustedShare * 0.02, 1e-6);
  EXPECT_NEAR(glm::length(result.force_D), 0.8, 1e-6);
}

TEST(ProxyMover, KeepsTheProxyOffAFloorMetFarOutsideTheZone) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ConstraintSet set = floorSet(1);
  set.zone_radius = 0.02;
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0.1, 0, -0.05));
  EXPECT_GE(result.X_DP.p.z, -1e-7);
}

/// Drags the stylus off to all sides, `reach` m far; the largest way of the proxy from the set's reference, m.
double farthestFrom(ForceRenderer& renderer, const Pose& X_DR, double reach) {
  double farthest = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    const double t = 1e-3 * i, far = std::min(1.0, 2.0 * t) * reach;
    const dvec3 stylus = X_DR.p + far * dvec3(std::cos(7.0 * t), std::sin(5.0 * t), -std::abs(std::sin(3.0 * t)));
    const RenderResult result = renderer.tick(Pose::translation(stylus), kTick);
    farthest = std::max(farthest, lengthOf(metricDifference(result.X_DP, X_DR)));
  }
  return farthest;
}

TEST(ProxyMover, NeverLeavesAZoneThatIsSmallerThanAStep) {
  // A set of a toothed part: complete for 1.2 mm only, with rows that contradict each other and the zone.
  for (const double zone : {0.0005, 0.0012, 0.02}) {
    for (const bool contradicting : {false, true}) {
      ForceRenderer renderer;
      renderer.reset(at(0, 0, 0));
      ConstraintSet set = floorSet(1, contradicting ? 3e-5 : -1e-4);  // Of the first the proxy is inside.
      if (contradicting) {
        set.constraints[set.count++] = planeConstraint(dvec3(0, 0, 1e-5), dvec3(0, 0, -1), set.X_DR, 1);
        set.constraints[set.count++] = planeConstraint(dvec3(1e-5, 0, 0), dvec3(1, 0, 0.1), set.X_DR, 2);
        set.constraints[set.count++] = planeConstraint(dvec3(2e-5, 0, 0), dvec3(-1, 0, 0.1), set.X_DR, 3);
      }
      set.zone_radius = zone;
      ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
      EXPECT_LE(farthestFrom(renderer, set.X_DR, 0.012), zone + 1e-9) << zone << ' ' << contradicting;
    }
  }
}

TEST(ProxyMover, GoesSmoothlyRoundTheEdgeOfAZoneThatTheStylusHasLeftFarBehind) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  ConstraintSet set = floorSet(1, -1.0);
  set.zone_radius = 0.0012;
  renderer.adopt(set);
  moveTo(renderer, dvec3(0.0), dvec3(0.02, 0, 0));
  dvec3 before = renderer.proxy().p;
  for (int i = 1; i <= 1500; ++i) {
    const double angle = 2e-3 * i;
    const RenderResult result = renderer.tick(at(0.02 * std::cos(angle), 0.02 * std::sin(angle), 0), kTick);
    EXPECT_LT(glm::length(result.X_DP.p - before), 2.0 * 2e-3 * set.zone_radius) << "it would rattle";
    before = result.X_DP.p;
  }
  EXPECT_NEAR(std::atan2(before.y, before.x), 3.0, 0.02);
}

TEST(ProxyMover, FeelsAGroupAsOrAndGroupsAsAnd) {
  // A block x < 0, z < 0: above it or beside it is free.
  for (const bool together : {true, false}) {
    ForceRenderer renderer;
    renderer.reset(at(0.005, 0, -0.005));  // Beside the block, under its top's level.
    ConstraintSet set;
    set.sequence = 1;
    set.X_DR = at(0.005, 0, -0.005);
    set.count = 2;
    set.constraints[0] = planeConstraint(dvec3(0.0), dvec3(0, 0, 1), set.X_DR, 0);
    set.constraints[1] = planeConstraint(dvec3(0.0), dvec3(1, 0, 0), set.X_DR, together ? 0 : 1);
    renderer.adopt(set);
    RenderResult result;
    for (int i = 0; i < 300; ++i) result = renderer.tick(at(0.005, 0, -0.005), kTick);
    EXPECT_EQ(result.contact, !together);
    EXPECT_NEAR(result.X_DP.p.z, together ? -0.005 : 0.0, 1e-6);
  }
}

TEST(ProxyMover, EndsACurvedFaceAtItsTrim) {
  // The floor ends at x = 0: beyond, the trim's smaller value says how far inside x < 0 one is.
  ConstraintSet set = floorSet(1, 0.0, dvec3(0, 0, 0.005));
  set.constraints[0].has_trim = true;
  set.constraints[0].trim_gap = 0.0;
  set.constraints[0].trim_gradient = {-1, 0, 0, 0, 0, 0};
  Constraint other = planeConstraint(dvec3(0, 0, -0.01), dvec3(0, 0, 1), set.X_DR, 0);
  set.constraints[set.count++] = other;
  ForceRenderer renderer;
  renderer.reset(at(-0.005, 0, 0.005));
  renderer.adopt(set);
  // Free = (z > 0 and x < 0) or z > -10 mm: the second face alone bounds.
  const RenderResult result = moveTo(renderer, dvec3(-0.005, 0, 0.005), dvec3(0.01, 0, -0.012));
  EXPECT_NEAR(result.X_DP.p.z, -0.01, 1e-6);
}

TEST(ProxyMover, HoldsAGuideFromBothSides) {
  for (const double side : {-0.003, 0.003}) {
    ConstraintSet set = floorSet(1);
    set.constraints[0].kind = ConstraintKind::kEquality;
    ForceRenderer renderer;
    renderer.reset(at(0, 0, 0));
    renderer.adopt(set);
    const RenderResult result = moveTo(renderer, dvec3(0.0), dvec3(0.02, 0, side));
    EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-6);
    EXPECT_NEAR(result.force_D.z, -1000.0 * side, 0.01);
  }
}

TEST(ProxyMover, TurnsTheProxyInsteadOfPushingWhereTurningIsEasier) {
  // A point 100 mm out on the body meets a floor: with the lever of 50 mm the proxy gives way by turning.
  ConstraintSet set;
  set.sequence = 1;
  set.X_DR = at(0, 0, 0);
  set.count = 1;
  set.constraints[0].gap = 0.001;
  set.constraints[0].gradient = {0, 0, 1, 0, -0.1, 0};  // n = z, rho = (0.1, 0, 0): rho x n = (0, -0.1, 0).
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0.0), dvec3(0, 0, -0.006));
  const dvec3 turned = rotationVector(result.X_DP.q);
  const dvec3 point = result.X_DP * dvec3(0.1, 0, 0);
  EXPECT_LT(turned.y, -0.01);
  EXPECT_NEAR(point.z, -0.001, 0.1e-3) << "the point stays on the floor (without curvature: to second order)";
  // Nearest in the metric: 5 mm missing, shared 1 : 4 between shift and turn.
  EXPECT_NEAR(result.X_DP.p.z, -0.006 + 0.001, 0.2e-3);
}

RC_GTEST_PROP(ProxyMoverProperty, KeepsTheProxyOutOfRandomConvexBlocks, ()) {
  // Half-spaces of one group through a sphere's surface: the proxy may touch but not enter.
  const auto seed = *rc::gen::arbitrary<unsigned>();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> spread(-1.0, 1.0);
  const auto direction = [&] { return glm::normalize(dvec3(spread(random), spread(random), spread(random) + 1e-6)); };
  std::array<dvec3, 12> normals;
  for (dvec3& normal : normals) normal = direction();
  const auto depth = [&](const dvec3& p) {
    double least = 1.0;
    for (const dvec3& n : normals) least = std::min(least, 0.01 - glm::dot(n, p));
    return least;
  };
  ForceRenderer renderer;
  dvec3 p = 0.03 * direction();
  while (depth(p) > -0.002) p = 0.05 * direction();
  renderer.reset(Pose::translation(p));
  for (int i = 0; i < 1500; ++i) {
    if (i % 50 == 0) {
      ConstraintSet set;
      set.sequence = static_cast<std::uint64_t>(i) + 1;
      set.X_DR = renderer.proxy();
      set.count = normals.size();
      for (std::size_t k = 0; k < set.count; ++k) {
        set.constraints[k] = planeConstraint(0.01 * normals[k], normals[k], set.X_DR, 0);
      }
      renderer.adopt(set);
    }
    p += 4e-4 * direction() - 0.004 * p * (i % 300 < 150 ? 1.0 : -0.5);
    const RenderResult result = renderer.tick(Pose::translation(p), kTick);
    RC_ASSERT(depth(result.X_DP.p) <= 1e-7);
  }
}

/// A floor and a second body beside it whose top is `step` higher: the stylus presses and slides on to it. Gives where
/// the proxy is then, and the greatest force along the way.
std::pair<dvec3, double> slideOnTo(double step) {
  ForceRenderer renderer;
  renderer.reset(at(-0.005, 0, 0.001));
  ConstraintSet set = floorSet(1);
  set.X_DR = at(-0.005, 0, 0.001);
  set.zone_radius = 0.05;
  set.constraints[0] = planeConstraint(dvec3(0.0), dvec3(0, 0, 1), set.X_DR, 0);
  set.constraints[1] = planeConstraint(dvec3(0, 0, step), dvec3(0, 0, 1), set.X_DR, 1);
  set.constraints[2] = planeConstraint(dvec3(0.0), dvec3(-1, 0, 0), set.X_DR, 1);
  set.count = 3;
  EXPECT_EQ(renderer.adopt(set), Adoption::kAdopted);
  moveTo(renderer, dvec3(-0.005, 0, 0.001), dvec3(-0.005, 0, -0.003));
  double along = 0.0;
  RenderResult result;
  for (int i = 0; i <= 1000; ++i) {
    result = renderer.tick(at(-0.005 + 1e-5 * i, 0, -0.003), kTick);
    along = std::max(along, std::abs(result.force_D.x));
  }
  return {result.X_DP.p, along};
}

TEST(ProxyMover, SlidesOverAFlushSeamAndStopsAtAStep) {
  for (const double step : {0.0, 5e-7, -5e-7}) {
    const auto [p, along] = slideOnTo(step);
    EXPECT_NEAR(p.x, 0.005, 1e-6) << step;
    EXPECT_GE(p.z, std::max(0.0, step) - 1e-7) << step;
    EXPECT_LT(along, 1e-3) << step << ": N";
  }
  const auto [p, along] = slideOnTo(1e-5);
  EXPECT_NEAR(p.x, 0.0, 1e-6);
  EXPECT_NEAR(along, 5.0, 0.1);
}

/// A point may be where two bodies meet without a gap: it does not fall between them.
TEST(ProxyMover, ASeamIsNoCrack) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.001));
  ConstraintSet set = floorSet(1);
  set.X_DR = at(0, 0, 0.001);
  set.zone_radius = 0.05;
  set.count = 0;
  for (const double side : {-1.0, 1.0}) {
    const std::uint32_t group = side < 0.0 ? 0 : 1;
    set.constraints[set.count++] = planeConstraint(dvec3(0.0), dvec3(0, 0, 1), set.X_DR, group);
    set.constraints[set.count++] = planeConstraint(dvec3(-2e-8 * side, 0, 0), dvec3(-side, 0, 0), set.X_DR, group);
  }
  renderer.adopt(set);
  for (const double x : {0.002, -0.002, 0.0}) {
    for (int i = 0; i <= 400; ++i) {
      const double t = 0.0025 * i;
      const RenderResult result = renderer.tick(at(x * std::sin(20.0 * t), 0, 0.001 - 0.004 * t), kTick);
      ASSERT_GE(result.X_DP.p.z, -2e-7) << x << ' ' << i;
    }
  }
}

TEST(ProxyMover, SlidesOnWithFrictionHoweverFarTheProxyIsBehind) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ConstraintSet set = floorSet(1);
  set.zone_radius = 1.0;
  set.constraints[0].friction = 0.15;
  ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.030));
  const RenderResult result = moveTo(renderer, dvec3(0, 0, -0.030), dvec3(0.2, 0, -0.030), 200, 100);
  EXPECT_NEAR(result.X_DP.p.x, 0.2 - 0.15 * 0.030, 1e-4);
}

TEST(ProxyMover, RubsOnlyOnWhatItTouches) {
  // It comes through the air, straight or at a slant, fast or all at once, and stays where it touched if that sticks.
  for (const double friction : {0.15, 0.6, 1e3}) {
    for (const double aside : {0.0, 0.01}) {
      for (const int ticks : {1, 20, 100}) {
        ForceRenderer renderer;
        renderer.reset(at(0, 0, 0.005));
        ConstraintSet set = floorSet(1);
        set.constraints[0].friction = friction;
        ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
        const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(aside, 0, -0.010), ticks, 100);
        EXPECT_NEAR(result.X_DP.p.z, 0.0, 2e-5) << friction << ' ' << aside << ' ' << ticks;
        EXPECT_LE(result.X_DP.p.x, aside);
        if (friction > 1.0 && ticks == 100) {
          EXPECT_NEAR(result.X_DP.p.x, aside / 3.0, 2e-4) << "where it touched";
        }
      }
    }
  }
}

}  // namespace
}  // namespace hapticell::haptic
