// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "haptic/devices/command_steps.h"
#include "haptic/devices/device_care.h"
#include "haptic/devices/hand_path.h"
#include "haptic/devices/hand_path_units.h"
#include "haptic/devices/simulated_hand.h"

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

}  // namespace
}  // namespace hapticell::haptic
