// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "haptic/devices/command_steps.h"
#include "haptic/devices/device_care.h"
#include "haptic/devices/hand_path.h"
#include "haptic/devices/hand_path_units.h"
#include "haptic/devices/input_reader.h"
#include "haptic/devices/simulated_hand.h"
#include "haptic/devices/system_access.h"
#include "tests/haptic/devices/scripted_driver.h"

namespace hapticell::haptic {
namespace {

using driver::Command;
using driver::CommandSteps;

Command commandOf(double force, double torque) {
  Command command;
  command.force[2] = force;
  command.torque[0] = torque;
  return command;
}

RC_GTEST_PROP(CommandSteps, TwoCommandsAreWithinAStepOfEachOtherAndTheLastIsReached, ()) {
  CommandSteps steps;
  double before = 0.0;
  for (int k = 0; k < 5; ++k) {
    const double wanted = *rc::gen::inRange(-60, 61) * 0.1;
    for (int i = 0; i < 15; ++i) {
      const double sent = steps.next(commandOf(wanted, 0.0)).force[2];
      RC_ASSERT(std::abs(sent - before) <= CommandSteps::kForce + 1e-12 || wanted == 0.0);
      RC_ASSERT(std::abs(sent - wanted) <= std::abs(before - wanted) + 1e-12);
      RC_ASSERT(steps.last().force[2] == sent);
      before = sent;
    }
    RC_ASSERT(std::abs(before - wanted) < 1e-9);
  }
}

TEST(CommandSteps, NothingIsSentAtOnceHoweverLargeTheForceWas) {
  CommandSteps steps;
  for (int i = 0; i < 10; ++i) steps.next(commandOf(6.0, 0.3));
  EXPECT_NEAR(steps.last().force[2], 6.0, 1e-9);
  EXPECT_NEAR(steps.last().torque[0], 0.3, 1e-9);
  const Command none = steps.next(commandOf(0.0, 0.3));
  EXPECT_EQ(none.force[2], 0.0);
  EXPECT_NEAR(none.torque[0], 0.3, 1e-9) << "each by itself";
  EXPECT_NEAR(steps.next(commandOf(6.0, 0.3)).force[2], 1.0, 1e-12) << "and comes back in steps";
}

TEST(DeviceCare, AConditionThatIsNewCountsAndAStepIsTakenOnce) {
  DeviceCare care;
  EXPECT_EQ(care.changes(), 0u);
  care.tell(DeviceCondition{});
  EXPECT_EQ(care.changes(), 0u) << "the same again";
  DeviceCondition docked;
  docked.docked = true;
  care.tell(docked);
  care.tell(docked);
  EXPECT_EQ(care.changes(), 1u);
  EXPECT_EQ(care.condition(), docked);
  EXPECT_FALSE(care.takeCalibration());
  care.calibrate(0);
  care.calibrate(2);
  EXPECT_EQ(care.takeCalibration(), 2u);
  EXPECT_FALSE(care.takeCalibration());
}

std::vector<HandSample> handAt(const std::vector<double>& times, double x) {
  std::vector<HandSample> samples;
  for (const double t : times) {
    HandSample sample;
    sample.t = t;
    sample.X_DH = Pose::translation({x, 0.0, 0.0});
    samples.push_back(sample);
  }
  return samples;
}

TEST(HandPathUnits, SecondsAndMetresAreTakenAsTheyAre) {
  auto samples = handAt({0.0, 0.5, 1.0}, 0.1);
  const auto assumed = recogniseHandUnits(samples, "a.csv");
  ASSERT_TRUE(assumed);
  EXPECT_TRUE(assumed->empty());
  EXPECT_EQ(samples[2].t, 1.0);
  EXPECT_EQ(samples[2].X_DH.p.x, 0.1);
}

TEST(HandPathUnits, ClocksAreCountedFromTheFirstRow) {
  for (const auto& [begin, unit] : {std::pair{1.7e12, 1e3}, {1.7e15, 1e6}, {1.7e18, 1e9}}) {
    auto samples = handAt({begin, begin + 0.5 * unit}, 0.1);
    const auto assumed = recogniseHandUnits(samples, "a.csv");
    ASSERT_TRUE(assumed);
    EXPECT_EQ(assumed->size(), 1u);
    EXPECT_EQ(samples[0].t, 0.0);
    EXPECT_NEAR(samples[1].t, 0.5, 1e-6) << unit;
  }
  auto late = handAt({50.0, 50.5}, 0.1);
  ASSERT_TRUE(recogniseHandUnits(late, "a.csv"));
  EXPECT_NEAR(late[1].t, 0.5, 1e-12);
}

TEST(HandPathUnits, MillimetresAreSeenByTheirSizeAndWhatIsFartherIsRefused) {
  auto samples = handAt({0.0, 1.0}, 250.0);
  const auto assumed = recogniseHandUnits(samples, "a.csv");
  ASSERT_TRUE(assumed);
  EXPECT_EQ(assumed->size(), 1u);
  EXPECT_NEAR(samples[0].X_DH.p.x, 0.25, 1e-12);
  auto far = handAt({0.0, 1.0}, 700.0);
  const auto refused = recogniseHandUnits(far, "a.csv");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().file, "a.csv");
  std::vector<double> whole;
  for (int i = 0; i < 120; ++i) whole.push_back(2.0 * i);
  auto milliseconds = handAt(whole, 0.1);
  ASSERT_TRUE(recogniseHandUnits(milliseconds, "a.csv"));
  EXPECT_NEAR(milliseconds.back().t, 0.238, 1e-12);
}

TEST(SimulatedHand, ItsIntentGoesFromWhereItIsToItsGoalNoFasterThanAHand) {
  SimulatedHand hand;
  EXPECT_FALSE(hand.holding());
  hand.hold(Pose::translation({0.5, 0.0, 0.0}), 0b10);
  EXPECT_TRUE(hand.holding());
  EXPECT_EQ(hand.buttons(), 0b10u);
  hand.beginTick({}, 0.001);
  EXPECT_LE(hand.intentAt(0.001).X_DH.p.x, hand.options().max_speed * 0.001 + 1e-12) << "a mouse that jumps";
  double before = hand.intentAt(0.001).X_DH.p.x;
  for (int tick = 0; tick < 400; ++tick) {
    hand.hold(Pose::translation({0.5, 0.0, 0.0}));
    hand.beginTick(Pose::translation({before, 0.0, 0.0}), 0.001);
    const double now = hand.intentAt(0.001).X_DH.p.x;
    EXPECT_LE(now - before, hand.options().max_speed * 0.001 + 1e-9);
    EXPECT_GE(now, before - 1e-12);
    before = now;
  }
  EXPECT_NEAR(before, 0.5, 1e-9);
  Pose invalid;
  invalid.p.x = std::nan("");
  hand.hold(invalid);
  hand.beginTick(Pose::translation({0.5, 0.0, 0.0}), 0.001);
  EXPECT_NEAR(hand.intentAt(0.0005).X_DH.p.x, 0.5, 1e-9) << "an invalid pose is ignored";
  hand.release();
  EXPECT_FALSE(hand.holding());
  EXPECT_LT(HandOptions::loose().damping, HandOptions::firm().damping);
}

TEST(SystemAccess, WhatIsNotGrantedSaysHowToGrantIt) {
  std::set<std::string> what;
  for (const SystemGrant& grant : systemGrants()) {
    EXPECT_TRUE(what.insert(grant.what).second) << grant.what;
    EXPECT_FALSE(grant.found.empty()) << grant.what;
    EXPECT_EQ(grant.fix.empty(), grant.granted) << grant.what;
    if (!grant.fix.empty()) {
      EXPECT_THAT(grant.fix, ::testing::HasSubstr("sudo ")) << grant.what;
    }
  }
  EXPECT_EQ(what.count("real-time priority"), 1u);
  EXPECT_THAT(what, ::testing::SizeIs(4));
  EXPECT_THAT(priorityFix(), ::testing::AnyOf(::testing::HasSubstr("rtprio"), ::testing::HasSubstr("usermod")));
  EXPECT_THAT(lockedMemoryFix(), ::testing::AnyOf(::testing::HasSubstr("memlock"), ::testing::HasSubstr("usermod")));
}

TEST(SystemAccess, LockedMemoryIsGrantedAsTheSystemLimitsIt) {
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_MEMLOCK, &limit), 0);
  for (const SystemGrant& grant : systemGrants()) {
    if (grant.what != "locked memory") continue;
    EXPECT_EQ(grant.granted, ::geteuid() == 0 || limit.rlim_cur == RLIM_INFINITY);
  }
}

/// Waits up to half a minute: a wait that is ever that long is a fault.
template <typename Condition>
bool comesTrue(Condition&& good) {
  for (int i = 0; i < 30000; ++i) {
    if (good()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(InputReader, HandsOutTheNewestStateAndEveryPressOfAButton) {
  driver::ScriptedDriver driver;
  driver.device.about.kind = driver::Kind::kGlove;
  driver.device.about.vibrators = 6;
  {
    InputReader reader(driver, "");
    ASSERT_TRUE(comesTrue([&] { return reader.latest().open && reader.latest().measurements > 0; }));
    EXPECT_EQ(reader.latest().capabilities.kind, driver::Kind::kGlove);
    EXPECT_EQ(reader.takePressed(), 0u);
    const auto set = [&](double thumb, std::uint32_t buttons) {
      const std::scoped_lock lock(driver.device.mutex);
      driver.device.state.sensors[0] = thumb;
      driver.device.state.buttons = buttons;
    };
    set(117.0, 0b101);
    ASSERT_TRUE(comesTrue([&] { return reader.latest().state.sensors[0] == 117.0; }));
    set(118.0, 0b010);
    ASSERT_TRUE(comesTrue([&] { return reader.latest().state.sensors[0] == 118.0; }));
    EXPECT_EQ(reader.takePressed(), 0b111u) << "also those that are released again";
    EXPECT_EQ(reader.takePressed(), 0u) << "each once";
    reader.vibrate({0.25, 0.0, 0.0, 0.0, 0.0, 1.0});
    EXPECT_TRUE(comesTrue([&] {
      const std::scoped_lock lock(driver.device.mutex);
      return driver.device.commands.back().vibration[0] == 0.25 && driver.device.commands.back().vibration[5] == 1.0;
    }));
    EXPECT_TRUE(reader.takeNews().empty());
    driver.device.fail(driver::Status::kVanished, "the glove was unplugged");
    ASSERT_TRUE(comesTrue([&] { return !reader.latest().open; }));
    EXPECT_THAT(reader.latest().problem, ::testing::HasSubstr("the glove was unplugged"));
    EXPECT_THAT(reader.takeNews(), ::testing::Contains(::testing::HasSubstr("the glove was unplugged")));
    EXPECT_TRUE(reader.takeNews().empty()) << "each once";
  }
  EXPECT_GE(driver.opened, 1);
  EXPECT_EQ(driver.opened, driver.closed) << "closed with its reader";
}

TEST(InputReader, SaysWhyADeviceCannotBeOpened) {
  driver::ScriptedDriver driver;
  driver::refuse(driver.refuses, driver::Status::kInUse, "another program has it", "Close it.");
  InputReader reader(driver, "");
  ASSERT_TRUE(comesTrue([&] { return !reader.latest().problem.empty(); }));
  EXPECT_EQ(reader.latest().problem, "Scripted: another program has it. Close it.");
  EXPECT_FALSE(reader.latest().open);
}

}  // namespace
}  // namespace hapticell::haptic
