// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/held_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptic/rendering/force_renderer.h"
#include "haptic/rendering/proxy_rows.h"

namespace hapticell::haptic {
namespace {

constexpr double kTick = 1e-3;

TEST(HeldLoad, NothingHeldIsExactlyNothing) {
  HeldLoad load;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(load.tick(dvec3(0.1 * i), dvec3(1.0), kTick), dvec3(0.0));
}

TEST(HeldLoad, AWeightComesWithoutAStep) {
  HeldLoad load;
  load.setOptions({0.0, 0.0, 0.0, dvec3(0, 0, -0.7)});
  dvec3 before(0.0);
  for (int i = 0; i < 300; ++i) {
    const dvec3 now = load.tick(dvec3(0.0), dvec3(0.0), kTick);
    EXPECT_LE(glm::distance(now, before), 0.0051);
    before = now;
  }
  EXPECT_NEAR(before.z, -0.7, 1e-12);
}

TEST(HeldLoad, ASteadyAccelerationIsAnsweredByMassTimesIt) {
  // A stylus on x = 1/2 a t^2: once the spring has settled, the mass lags so that it is pulled by m a.
  const double mass = 0.4, a = 1.5;
  HeldLoad load;
  load.setOptions({mass, 0.0, 0.0, dvec3(0.0)});
  dvec3 force(0.0);
  for (int i = 0; i <= 1000; ++i) {
    const double t = kTick * i;
    force = load.tick(dvec3(0.5 * a * t * t, 0, 0), dvec3(a * t, 0, 0), kTick);
  }
  EXPECT_NEAR(force.x, -mass * a, 0.02);
}

TEST(HeldLoad, MakesNoEnergyOnAShakenStylus) {
  HeldLoad load;
  load.setOptions({0.3, 0.5, 0.0, dvec3(0.0)});
  double work = 0.0, least = 0.0;
  const double w = 40.0;
  for (int i = 0; i < 5000; ++i) {
    const double t = kTick * i;
    const dvec3 p(0.01 * std::sin(w * t), 0, 0), v(0.01 * w * std::cos(w * t), 0, 0);
    const dvec3 force = load.tick(p, v, kTick);
    work -= glm::dot(force, v) * kTick;
    least = std::min(least, work);
  }
  EXPECT_GT(least, -0.03) << "what the mass holds at most while it is set in motion";
  EXPECT_GT(work, 0.0);
}

TEST(HeldLoad, DryFrictionSticksThenSlips) {
  HeldLoad load;
  load.setOptions({0.0, 0.0, 0.4, dvec3(0.0)});
  EXPECT_EQ(load.tick(dvec3(0.0), dvec3(0.0), kTick), dvec3(0.0));
  EXPECT_NEAR(load.tick({0.25e-3, 0, 0}, dvec3(0.0), kTick).x, -0.2, 1e-9) << "sticks";
  EXPECT_NEAR(load.tick({5e-3, 0, 0}, dvec3(0.0), kTick).x, -0.4, 1e-9) << "slips";
  EXPECT_NEAR(load.tick({4e-3, 0, 0}, dvec3(0.0), kTick).x, 0.4, 1e-9) << "and back";
}

TEST(Pull, DrawsTheStylusIntoItsDetent) {
  GroupedSet grouped;
  ConstraintSet set;
  set.count = 1;
  set.constraints[0].kind = ConstraintKind::kPull;
  set.constraints[0].gradient = {1, 0, 0, 0, 0, 0};
  set.constraints[0].stiffness = 200.0;
  set.constraints[0].reach = 0.01;
  grouped.take(set);
  EXPECT_NEAR(grouped.pullAt(Pose::translation({0.002, 0.3, 0})).x, -200.0 * 0.002 * (1.0 - 0.04), 1e-12);
  EXPECT_GT(grouped.pullAt(Pose::translation({-0.005, 0, 0})).x, 0.0);
  EXPECT_EQ(grouped.pullAt(Pose::translation({0.0101, 0, 0})), dvec3(0.0));
  // It holds nothing back.
  ForceRenderer renderer;
  renderer.reset(Pose::identity());
  renderer.adopt(set);
  for (int i = 1; i <= 50; ++i) renderer.tick(Pose::translation({1e-3 * i, 0, 0}), kTick);
  EXPECT_NEAR(renderer.proxy().p.x, 0.05, 1e-9);
}

TEST(HeldLoad, TakesAnyNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LoadOptions load = sane({nan, -3.0, nan, dvec3(nan, 0, 0)});
  EXPECT_EQ(load, LoadOptions{});
  EXPECT_LE(glm::length(sane({1e9, 1e9, 1e9, dvec3(1e300)}).weight_D), 5.0 + 1e-12);
}

/// A stylus that runs into a wall at z = 0 and stops there: the force on it a moment later.
double strikeOf(double mass) {
  ForceRenderer renderer;
  renderer.setLoad({mass, 0.0, 0.0, dvec3(0.0)});
  renderer.reset(Pose::translation({0, 0, 0.02}));
  ConstraintSet set;
  set.count = 1;
  set.constraints[0].gradient = {0, 0, 1, 0, 0, 0};
  renderer.adopt(set);
  double deepest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double z = std::max(0.0, 0.02 - 2e-4 * i);
    deepest = std::min(deepest, renderer.tick(Pose::translation({0, 0, z}), kTick).force_D.z);
  }
  return -deepest;
}

TEST(HeldLoad, AHeavyPartStrikesHarder) {
  EXPECT_EQ(strikeOf(0.0), 0.0);
  EXPECT_GT(strikeOf(0.5), 1.5 * strikeOf(0.1));
}

}  // namespace
}  // namespace hapticell::haptic
