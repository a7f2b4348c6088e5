// SPDX-License-Identifier: Apache-2.0
// The parts of the coupling one by one; together they are tested by force_renderer_test.cpp.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "haptic/rendering/coupling_gains.h"
#include "haptic/rendering/coupling_spring.h"
#include "haptic/rendering/filtered_velocities.h"
#include "haptic/rendering/motor_limit.h"
#include "haptic/rendering/set_slots.h"

namespace hapticell::haptic {
namespace {

constexpr double kMillisecond = 0.001;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

MetricVector up(double size) {
  return {dvec3(0.0, 0.0, size), dvec3(0.0)};
}

MetricVector anyMetric() {
  const auto part = [] { return *rc::gen::inRange(-1000, 1001) * 1e-3; };
  const double a = part(), b = part(), c = part(), d = part(), e = part(), f = part();
  return {dvec3(a, b, c), dvec3(d, e, f)};
}

RC_GTEST_PROP(MotorLimit, TheForceAlongADirectionIsTheLargestThatBothMotorsBear, ()) {
  MotorLimit motors;
  motors.setPeaks(6.4, 0.2, true);
  const bool is_warm = *rc::gen::arbitrary<bool>();
  if (is_warm) motors.setWarmLimit(1.6);
  const double share = is_warm ? 0.25 : 1.0;  // warm motors bear less torque as well
  const MetricVector direction = anyMetric();
  RC_PRE(length(direction) > 1e-2);
  const double force = motors.along(direction);
  const MetricVector acting = (force / length(direction)) * direction;
  const double linear = glm::length(acting.linear) / (6.4 * share);
  const double turning = kRotationLever * glm::length(acting.angular) / (0.2 * share);
  RC_ASSERT(std::abs(std::max(linear, turning) - 1.0) < 1e-12);
  RC_ASSERT(std::abs(motors.along(7.0 * direction) - force) < 1e-9);
}

TEST(MotorLimit, WithoutDrivenTurningOnlyTheForceCounts) {
  MotorLimit motors;
  motors.setPeaks(6.4, 0.0, false);
  EXPECT_EQ(motors.along({dvec3(0.0), dvec3(1.0)}), 6.4);
  EXPECT_EQ(motors.along({}), 6.4);
  motors.setWarmLimit(2.0);
  EXPECT_EQ(motors.along(up(1.0)), 2.0);
}

TEST(MotorLimit, AWarmLimitThatIsNoneIsNone) {
  MotorLimit motors;
  motors.setPeaks(6.4, 0.0, false);
  for (const double none : {0.0, -1.0, kNoNumber, 6.4, 100.0, std::numeric_limits<double>::infinity()}) {
    motors.setWarmLimit(1.0);
    motors.setWarmLimit(none);
    EXPECT_EQ(motors.along(up(1.0)), 6.4) << none;
  }
}

TEST(FilteredVelocities, FollowAStepAsAFilterOfFirstOrder) {
  for (const double stiffness : {200.0, 1000.0, 1200.0, 5000.0}) {
    const double frequency = std::clamp(0.075 * stiffness, 75.0, 100.0);
    FilteredVelocities velocities;
    for (int tick = 1; tick <= 50; ++tick) {
      velocities.add(up(0.2e-3), up(-0.1e-3), stiffness, kMillisecond);
      const auto followed = [&](double hertz) {
        return 1.0 - std::exp(-2.0 * std::numbers::pi * hertz * tick * kMillisecond);
      };
      EXPECT_NEAR(velocities.stylus_D().linear.z, 0.2 * followed(frequency), 1e-12);
      EXPECT_NEAR(velocities.proxy_D().linear.z, -0.1 * followed(frequency), 1e-12);
      EXPECT_NEAR(velocities.slowStylus_D().linear.z, 0.2 * followed(40.0), 1e-12);
    }
    velocities.reset();
    EXPECT_TRUE(velocities.stylus_D() == MetricVector{} && velocities.slowStylus_D() == MetricVector{});
  }
}

TEST(FilteredVelocities, ALongTickFiltersLikeSeveralShortOnes) {
  FilteredVelocities one, four;
  one.add(up(4e-3), up(2e-3), 1000.0, 4.0 * kMillisecond);
  for (int i = 0; i < 4; ++i) four.add(up(1e-3), up(0.5e-3), 1000.0, kMillisecond);
  EXPECT_NEAR(one.stylus_D().linear.z, four.stylus_D().linear.z, 1e-12);
  EXPECT_NEAR(one.proxy_D().linear.z, four.proxy_D().linear.z, 1e-12);
  EXPECT_NEAR(one.slowStylus_D().linear.z, four.slowStylus_D().linear.z, 1e-12);
}

class Gains : public ::testing::Test {
 protected:
  RendererOptions options_{.stiffness = 1000.0, .damping = 2.0};
  CouplingGains gains_;
};

TEST_F(Gains, OutOfContactTheyAreTakenAtOnceInContactTheyMove) {
  gains_.reset(options_);
  ProxyStep solved;
  solved.stiffness = 400.0;
  solved.damping = 6.0;
  gains_.approach(solved, options_, false, kMillisecond);
  EXPECT_EQ(gains_.stiffness(), 400.0);
  gains_.updateDamper(true, false, kMillisecond);
  EXPECT_EQ(gains_.damping(), 6.0);
  gains_.reset(options_);
  int ticks = 0;
  for (double before = gains_.stiffness(); gains_.stiffness() > 400.0; before = gains_.stiffness(), ++ticks) {
    gains_.approach(solved, options_, true, kMillisecond);
    ASSERT_LE(before - gains_.stiffness(), 10.0 + 1e-9) << "the whole stiffness in 0.1 s";
    ASSERT_LT(ticks, 100);
  }
  EXPECT_EQ(ticks, 60);
}

TEST_F(Gains, ARowMayAskForLessStiffnessAndForMoreDampingNeverForAnyMore) {
  gains_.reset(options_);
  ProxyStep solved;
  solved.stiffness = 1e6;
  solved.damping = 1e4;
  gains_.approach(solved, options_, false, kMillisecond);
  gains_.updateDamper(true, false, kMillisecond);
  EXPECT_EQ(gains_.stiffness(), 1000.0);
  EXPECT_EQ(gains_.damping(), kDampingLimit);
  solved.stiffness = solved.damping = 0.0;  // asks for nothing
  gains_.approach(solved, options_, false, kMillisecond);
  EXPECT_EQ(gains_.stiffness(), 1000.0);
  EXPECT_EQ(gains_.damping(), 2.0);
}

TEST_F(Gains, AHandThatStrikesIsDampedAtOnceAndWhatEndsFades) {
  gains_.reset(options_);
  EXPECT_EQ(gains_.damping(), 0.0);
  gains_.updateDamper(true, false, kMillisecond);
  EXPECT_EQ(gains_.damping(), 2.0);
  for (int tick = 1; tick <= 12; ++tick) {
    gains_.updateDamper(false, false, kMillisecond);
    EXPECT_NEAR(gains_.damping(), std::max(0.0, 2.0 * (1.0 - 0.1 * tick)), 1e-12);
  }
  gains_.updateDamper(true, true, kMillisecond);  // a proxy that catches up
  EXPECT_EQ(gains_.damping(), 0.0);
  for (int tick = 1; tick <= 10; ++tick) {
    gains_.updateDamper(true, false, kMillisecond);
    EXPECT_NEAR(gains_.damping(), 0.2 * tick, 1e-12) << "has arrived: no damper in one step";
  }
}

class Spring : public ::testing::Test {
 protected:
  Spring() {
    spring_.motors().setPeaks(6.4, 0.0, false);
    spring_.setStiffness(1000.0);
    spring_.reset();
  }
  /// The hand moves the stylus at 10 mm/s until the proxy is `stretch` m above it. The force, N, upwards.
  double press(double stretch) {
    double force = spring_.last().spring.linear.z;
    while (stretch_ != stretch) force = pressInATick(stretch_ + std::clamp(stretch - stretch_, -1e-5, 1e-5));
    return force;
  }
  double pressInATick(double stretch) {
    const MetricVector step = up(-(stretch - stretch_));
    stretch_ = stretch;
    (void)spring_.stretchTo(up(stretch), {}, step);
    spring_.decayOffset(true, step, kMillisecond);
    spring_.creepBack(false, true, kMillisecond);
    spring_.update(true, 1.0, step, kMillisecond);
    spring_.noteWanted(spring_.last().spring);
    EXPECT_LT(glm::length(dvec3(spring_.last().spring.linear.x, spring_.last().spring.linear.y, 0.0)), 1e-12);
    return spring_.last().spring.linear.z;
  }
  CouplingSpring spring_;
  double stretch_ = 0.0;
};

TEST_F(Spring, BelowTheMotorsLimitItIsHookesSpring) {
  for (int i = 1; i <= 60; ++i) EXPECT_NEAR(press(0.1e-3 * i), 0.1 * i, 1e-9);
  for (int i = 59; i >= 0; --i) EXPECT_NEAR(press(0.1e-3 * i), 0.1 * i, 1e-9);
  EXPECT_EQ(spring_.yielded(), 0.0);
}

TEST_F(Spring, BeyondTheLimitItYieldsAndUnloadsAlongTheStiffnessNeverToAPull) {
  for (int i = 1; i <= 200; ++i) EXPECT_NEAR(press(0.1e-3 * i), std::min(0.1 * i, 6.4), 1e-9);
  EXPECT_GT(spring_.yielded(), 0.0) << "the hand's work that yielding took";
  for (int i = 199; i >= 0; --i) EXPECT_NEAR(press(0.1e-3 * i), std::max(0.0, 6.4 - 0.1 * (200 - i)), 1e-9);
}

TEST_F(Spring, TheForceGoesOnOverAChangeOfSetsAndThenComesToTheNewOne) {
  for (int i = 1; i <= 30; ++i) press(0.1e-3 * i);  // 3 N
  spring_.changeStretch(up(3e-3), up(5e-3));
  EXPECT_NEAR(spring_.offset_D().linear.z, -2e-3, 1e-12);
  (void)spring_.stretchTo(up(5e-3), up(2e-3), {});
  spring_.update(true, 1.0, {}, kMillisecond);
  EXPECT_NEAR(spring_.last().spring.linear.z, 3.0, 1e-6) << "nothing is felt of it";
  double before = 3.0;
  for (int tick = 0; tick < 400; ++tick) {
    spring_.noteWanted(spring_.last().spring);
    spring_.decayOffset(true, {}, kMillisecond);
    spring_.update(true, 1.0, {}, kMillisecond);
    const double force = spring_.last().spring.linear.z;
    EXPECT_LT(std::abs(force - before), 0.051) << "0.05 mm a millisecond at 1000 N/m";
    before = force;
  }
}

TEST_F(Spring, FreeOfContactThereIsExactlyNoForce) {
  for (int i = 1; i <= 30; ++i) press(0.1e-3 * i);
  (void)spring_.stretchTo({}, {}, up(3e-3));
  for (int tick = 0; tick < 100; ++tick) {
    spring_.decayOffset(false, {}, kMillisecond);
    spring_.update(false, 1.0, {}, kMillisecond);
  }
  EXPECT_TRUE(spring_.last().spring == MetricVector{});
  EXPECT_TRUE(spring_.offset_D() == MetricVector{});
}

TEST_F(Spring, WhatDampsNeverPullsAHandThatLifts) {
  for (int i = 1; i <= 10; ++i) press(0.1e-3 * i);  // 1 N upwards
  EXPECT_NEAR(spring_.withoutPull(up(-5.0)).linear.z, -1.0, 1e-9) << "spring and damper together are nothing";
  EXPECT_EQ(spring_.withoutPull(up(-0.5)).linear.z, -0.5);
  EXPECT_EQ(spring_.withoutPull(up(2.0)).linear.z, 2.0);
  const MetricVector aside{dvec3(3.0, 0.0, 0.0), dvec3(0.0)};
  EXPECT_TRUE(spring_.withoutPull(aside) == aside);
}

TEST_F(Spring, AForceThatTheSafetyChainCutIsTheLimitOfWhatIsHeld) {
  press(2e-3 * 0.1);
  spring_.noteWanted(up(0.2));
  EXPECT_TRUE(std::isinf(spring_.last().limit));
  spring_.noteApplied(up(0.2));
  EXPECT_TRUE(std::isinf(spring_.last().limit));
  spring_.noteApplied(up(0.05));
  EXPECT_NEAR(spring_.last().limit, 0.05, 1e-12);
  EXPECT_TRUE(spring_.last().applied == up(0.05));
}

TEST(RestWatch, AHandRestsAfterAFifthOfASecondWithinThreeTenthsOfAMillimetre) {
  ProxyMover mover;
  RestWatch watch;
  int ticks = 0;
  while (!watch.rests(mover, Pose::translation({0.1, 0.0, 0.1e-3 * (ticks % 3)}), kMillisecond))
    ASSERT_LT(++ticks, 300);
  EXPECT_NEAR(ticks, 200, 2);
  EXPECT_FALSE(watch.rests(mover, Pose::translation({0.1005, 0.0, 0.0}), kMillisecond)) << "half a millimetre away";
}

TEST(RestWatch, ASlowDriftIsRestAndAQuickOneIsNot) {
  ProxyMover mover;
  for (const bool is_slow : {true, false}) {
    RestWatch watch;
    bool rests = false;
    double x = 0.0;
    for (int tick = 0; tick < 600; ++tick) {
      x += (is_slow ? 4e-3 : 8e-3) * kMillisecond;
      rests = watch.rests(mover, Pose::translation({x, 0.0, 0.0}), kMillisecond);
    }
    EXPECT_EQ(rests, is_slow);
    watch.reset();
    EXPECT_FALSE(watch.rests(mover, Pose::translation({x, 0.0, 0.0}), kMillisecond));
  }
}

ConstraintSet numbered(std::uint64_t sequence) {
  ConstraintSet set;
  set.sequence = sequence;
  return set;
}

TEST(SetSlots, TheOfferedSetIsInUseAfterTheChangeOnly) {
  const auto slots = std::make_unique<SetSlots>();
  EXPECT_FALSE(slots->holds());
  EXPECT_EQ(slots->sequence(), 0u);
  slots->offer(numbered(7), 0.02);
  EXPECT_TRUE(slots->offered());
  EXPECT_EQ(slots->next().sequence, 7u);
  EXPECT_EQ(slots->sequence(), 0u);
  slots->change();
  EXPECT_TRUE(slots->holds());
  EXPECT_FALSE(slots->offered());
  EXPECT_EQ(slots->sequence(), 7u);
  EXPECT_NEAR(slots->current().age, 0.02, 1e-15);
  slots->offer(numbered(8), 0.0);
  slots->offer(numbered(9), 0.0);
  EXPECT_EQ(slots->next().sequence, 9u) << "the newest offer wins";
  slots->reset();
  EXPECT_FALSE(slots->holds() || slots->offered());
  EXPECT_EQ(slots->sequence(), 0u);
}

TEST(SetSlots, AnOlderNumberIsShutOutForTwoAndAHalfSeconds) {
  const auto slots = std::make_unique<SetSlots>();
  EXPECT_FALSE(slots->isOutdated(0)) << "nothing is in use";
  slots->offer(numbered(7), 0.0);
  slots->change();
  EXPECT_TRUE(slots->isOutdated(6));
  EXPECT_FALSE(slots->isOutdated(7)) << "the same once more";
  slots->advance(2.4);
  EXPECT_TRUE(slots->isOutdated(6));
  slots->advance(0.2);
  EXPECT_FALSE(slots->isOutdated(6)) << "a client that began to count anew";
}

TEST(SetSlots, TheAgeGrowsToASecondAndTakesAnyNumber) {
  const auto slots = std::make_unique<SetSlots>();
  for (const auto& [given, kept] : {std::pair{0.3, 0.3},
                                    {-4.0, 0.0},
                                    {9.0, 1.0},
                                    {kNoNumber, 0.0},
                                    {std::numeric_limits<double>::infinity(), 0.0}}) {
    slots->offer(numbered(1), given);
    EXPECT_EQ(slots->next().age, kept) << given;
  }
  slots->offer(numbered(2), 0.9);
  slots->change();
  slots->advance(0.05);
  EXPECT_NEAR(slots->current().age, 0.95, 1e-12);
  slots->advance(0.5);
  EXPECT_EQ(slots->current().age, 1.0);
}

}  // namespace
}  // namespace hapticell::haptic
