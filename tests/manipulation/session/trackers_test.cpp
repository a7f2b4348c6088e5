// SPDX-License-Identifier: Apache-2.0
// What a session notes from step to step, of an engine whose hand the test leads.
#include <gtest/gtest.h>

#include <cmath>

#include "manipulation/session/contact_tracker.h"
#include "manipulation/session/force_extremes.h"
#include "manipulation/session/joint_meter.h"
#include "manipulation/session/limit_tracker.h"
#include "manipulation/session/penetration_meter.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/manipulation/session/moved_by_hand.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::MovedByHand;

constexpr workcell::EntityId kTable = 1, kBox = 2;

MeteredTick tickAt(double t, double force) {
  MeteredTick tick;
  tick.t = t;
  tick.force_D = dvec3(0.6 * force, 0.0, -0.8 * force);
  return tick;
}

TEST(ForceExtremes, AreTheGreatestForceAndStepOfAMillisecond) {
  ForceExtremes extremes;
  extremes.add(tickAt(0.0, 2.0));
  EXPECT_NEAR(extremes.maxForce(), 2.0, 1e-12);
  EXPECT_EQ(extremes.maxStep(), 0.0) << "nothing came before the first";
  extremes.add(tickAt(0.001, 2.5));
  EXPECT_NEAR(extremes.maxStep(), 0.5, 1e-12);
  extremes.add(tickAt(0.003, 1.1));
  EXPECT_NEAR(extremes.maxStep(), 0.7, 1e-12) << "1.4 N in 2 ms";
  extremes.add(tickAt(0.0032, 1.3));
  EXPECT_NEAR(extremes.maxStep(), 0.7, 1e-12) << "a tick too early is not a steeper force";
  EXPECT_NEAR(extremes.maxForce(), 2.5, 1e-12);
}

/// What the hand gets by a force of 1 N that goes along with it, or against it.
double leastEnergy(double step, int ticks) {
  ForceExtremes extremes;
  for (int i = 0; i < ticks; ++i) {
    MeteredTick tick = tickAt(1e-3 * i, 1.0);
    tick.coupling_D.linear = tick.force_D;
    tick.step_D.linear = step * tick.force_D;
    extremes.add(tick);
  }
  return extremes.leastEnergy();
}

TEST(ForceExtremes, EnergyIsWhatTheMotorsGaveWithinASecond) {
  // The first tick begins, the second one is the first balance.
  EXPECT_NEAR(leastEnergy(1e-3, 12), -0.010, 1e-12);
  EXPECT_EQ(leastEnergy(-1e-3, 12), 0.0) << "the hand pushed";
  EXPECT_NEAR(leastEnergy(1e-5, 3000), -0.010, 5e-5) << "three seconds, of which one counts";
}

TEST(ContactTracker, NotesWhoTouchedWhenAndHowHard) {
  MovedByHand hand(test::boxOverTable(0.005), kBox);
  ContactTracker tracker;
  double began = 0.0, ended = 0.0;
  const auto moveTo = [&](double z, double force) {
    hand.moveTo({0, 0, z});
    tracker.add(hand.time(), hand.engine, force);
    if (hand.engine.contacts().empty()) return;
    if (began == 0.0) began = hand.time();
    ended = hand.time();
  };
  for (int i = 0; i <= 60; ++i) moveTo(-1e-4 * i, 0.05 * i);
  ASSERT_GT(began, 0.0);
  ASSERT_EQ(tracker.contacts().size(), 1U);
  for (int i = 60; i >= 0; --i) moveTo(-1e-4 * i, 0.0);
  const ContactInterval& first = tracker.contacts()[0];
  EXPECT_EQ(first.entity, kBox);
  EXPECT_EQ(first.other, kTable);
  EXPECT_EQ(first.time_in, began);
  EXPECT_EQ(first.time_out, ended);
  EXPECT_NEAR(first.max_force, 3.0, 1e-12);
  // Again after longer than an interruption.
  for (int i = 0; i < 40; ++i) moveTo(0.0, 9.0);
  for (int i = 0; i <= 60; ++i) moveTo(-1e-4 * i, 1.0);
  ASSERT_EQ(tracker.contacts().size(), 2U);
  tracker.finish(hand.time() + 0.01);
  EXPECT_EQ(tracker.contacts()[1].time_out, hand.time() + 0.01);
  EXPECT_EQ(tracker.contacts()[0].max_force, first.max_force) << "what is free is not pushed";
}

TEST(ContactTracker, WhatPassesIsTouchedWithoutForce) {
  MovedByHand hand(test::boxOverTable(0.001), kBox);
  hand.engine.apply(command::SetOnContact{workcell::OnContact::kPass});
  ContactTracker tracker;
  PenetrationMeter meter;
  for (int i = 0; i <= 30; ++i) {
    hand.moveTo({0, 0, -2e-4 * i});
    tracker.add(hand.time(), hand.engine, 4.0);
    meter.measure(hand.engine);
  }
  ASSERT_EQ(tracker.contacts().size(), 1U);
  EXPECT_EQ(tracker.contacts()[0].max_force, 0.0);
  EXPECT_NEAR(meter.worst(), 0.005, 1e-5) << "6 mm down, 1 mm of which was free";
  EXPECT_EQ(meter.worstBlocked(), 0.0);
}

TEST(PenetrationMeter, MeasuresHowDeepItBeganAndThatItComesFree) {
  MovedByHand hand(test::boxOverTable(-0.004), kBox);
  PenetrationMeter meter;
  EXPECT_NEAR(meter.measure(hand.engine), 0.004, 1e-5);
  double before = meter.worst();
  for (int i = 1; i <= 60; ++i) {
    hand.moveTo({0, 0, 1e-4 * i});
    const double bottom = hand.engine.held()->accepted().X_WE.p.z - 0.03;
    const double depth = meter.measure(hand.engine);
    EXPECT_NEAR(depth, std::max(0.0, -bottom), 1e-5) << i;
    EXPECT_LE(depth, before + 1e-9);
    before = depth;
  }
  EXPECT_EQ(before, 0.0);
  EXPECT_NEAR(meter.worst(), 0.004, 1e-5);
  EXPECT_EQ(meter.worstBlocked(), meter.worst());
  hand.engine.apply(command::Release{});
  hand.moveTo({0, 0, 0});
  EXPECT_EQ(meter.measure(hand.engine), 0.0) << "nothing is held";
}

/// A SCARA that lifts, 0.1 m of which is below it; its links have no shapes.
std::vector<workcell::Entity> scaraCell() {
  workcell::Entity robot;
  robot.id = kBox;
  robot.name = "robot";
  auto model = std::make_shared<const kinematics::RobotModel>(kinematics::test::scara());
  const std::string tip = model->links.back().name;
  robot.body = workcell::Robot{{.model = model, .joints = {0.3, 0.8, -0.05, 0.0}, .tip_link = tip}};
  return {robot};
}

TEST(JointMeter, NotesTheWayAndTheSpeedOfEachJoint) {
  MovedByHand hand(scaraCell(), kBox);
  JointMeter meter;
  std::vector<double> lowest, highest, speed, before;
  double t_before = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double angle = 0.06 * i;
    hand.moveTo({0.01 * std::sin(angle), 0.01 - 0.01 * std::cos(angle), 0.004 * std::sin(2.0 * angle)});
    meter.add(hand.time(), hand.engine);
    const std::vector<double> now = hand.engine.placement(kBox).joints;
    if (before.empty()) {
      lowest = highest = now;
      speed.assign(now.size(), 0.0);
    } else {
      for (std::size_t k = 0; k < now.size(); ++k) {
        lowest[k] = std::min(lowest[k], now[k]);
        highest[k] = std::max(highest[k], now[k]);
        speed[k] = std::max(speed[k], std::abs(now[k] - before[k]) / (hand.time() - t_before));
      }
    }
    before = now;
    t_before = hand.time();
  }
  ASSERT_EQ(meter.joints().size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const JointUse& use = meter.joints()[k];
    EXPECT_EQ(use.joint, static_cast<int>(k));
    EXPECT_NEAR(use.lowest, lowest[k], 1e-12);
    EXPECT_NEAR(use.highest, highest[k], 1e-12);
    EXPECT_NEAR(use.max_speed, speed[k], 1e-9);
    EXPECT_EQ(use.greatest_speed, 3.0) << "as its model says";
    EXPECT_LE(use.max_speed, use.greatest_speed * (1.0 + 1e-9));
  }
  EXPECT_GT(meter.joints()[2].highest - meter.joints()[2].lowest, 0.006) << "it was lifted";
}

TEST(JointMeter, AJumpWhileNothingIsHeldIsNoSpeed) {
  MovedByHand hand(scaraCell(), kBox);
  JointMeter meter;
  meter.add(hand.time(), hand.engine);
  hand.engine.apply(command::Release{});
  hand.moveTo({0, 0, 0});
  meter.add(hand.time(), hand.engine);
  std::vector<workcell::Entity> moved = scaraCell();
  moved[0].setJoints({0.9, 0.8, 0.1, 0.0});
  hand.engine.apply(command::SetDocument{moved, {}});
  hand.engine.apply(command::Grab{kBox});
  hand.moveTo({0, 0, 0});
  meter.add(hand.time(), hand.engine);
  ASSERT_EQ(meter.joints().size(), 4U);
  EXPECT_LT(meter.joints()[0].max_speed, 1e-6);
  MovedByHand box(test::boxOverTable(0.01), kBox);
  JointMeter none;
  none.add(box.time(), box.engine);
  EXPECT_TRUE(none.joints().empty()) << "a solid has no joints";
}

TEST(LimitTracker, NotesTheLimitThatHolds) {
  MovedByHand hand(scaraCell(), kBox);
  LimitTracker tracker;
  double began = 0.0, last = 0.0;
  const auto moveTo = [&](double z) {
    hand.moveTo({0, 0, z});
    tracker.add(hand.time(), hand.engine);
    const double lift = hand.engine.placement(kBox).joints[2];
    EXPECT_GE(lift, -0.1 - 1e-12);
    bool holds = false;
    for (const LimitState& limit : hand.engine.nearLimits()) holds = holds || (limit.holds && limit.joint == 2);
    if (!holds) return;
    EXPECT_NEAR(lift, -0.1, 2e-3);
    if (began == 0.0) began = hand.time();
    last = hand.time();
  };
  for (int i = 0; i <= 60; ++i) moveTo(-1e-3 * i);
  for (int i = 60; i >= 0; --i) moveTo(-1e-3 * i);
  ASSERT_GT(began, 0.0);
  ASSERT_EQ(tracker.limits().size(), 1U);
  const LimitInterval& limit = tracker.limits()[0];
  EXPECT_EQ(limit.kind, LimitKind::kJoint);
  EXPECT_EQ(limit.joint, 2);
  EXPECT_NE(limit.text.find("j3"), std::string::npos) << limit.text;
  EXPECT_EQ(limit.time_in, began);
  EXPECT_EQ(limit.time_out, last);
  for (int i = 0; i < 40; ++i) moveTo(0.0);
  for (int i = 0; i <= 60; ++i) moveTo(-1e-3 * i);
  EXPECT_EQ(tracker.limits().size(), 2U) << "again, later";
}

}  // namespace
}  // namespace hapticell::manipulation
