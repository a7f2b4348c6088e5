// SPDX-License-Identifier: Apache-2.0
// What a link that closes, falls silent or changes its client does to the force.
#include <gtest/gtest.h>

#include "haptic/server/force_loop.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

constexpr int kWithin50Milliseconds = 50;  // Ticks.

TEST(ForceLoop, ASetIsHeldWhileTheLinkLivesHoweverOld) {
  VirtualSession session;
  session.engage();
  session.holdAt(-0.004);  // 0.9 N: less than the motors bear for ever.
  session.run(1000);
  const double force = session.force();
  ASSERT_GT(force, 0.8);
  session.run(20'000);
  EXPECT_NEAR(session.force(), force, 0.03);
}

TEST(ForceLoop, AClosedLinkTakesTheForceToZeroWithin50Ms) {
  VirtualSession session;
  session.press();
  ASSERT_GT(session.force(), 2.0);
  session.link().disconnect();
  session.max_step = 0.0;
  session.run(kWithin50Milliseconds);
  EXPECT_EQ(session.force(), 0.0);
  EXPECT_LE(session.max_step, 1.0 + 1e-12);
  EXPECT_FALSE(session.state().forces_on);
  session.run(1000);
  EXPECT_EQ(session.force(), 0.0);
  EXPECT_FALSE(session.device.hand().holding()) << "whoever moved the hand is gone";
  EXPECT_EQ(session.state().adopted_set, 0u);
}

TEST(ForceLoop, ASilentLinkIsHeldFor600MsAndThenFadesIn200) {
  VirtualSession session;
  session.press();
  const double force = session.force();
  const std::int64_t last_word = session.clock.now();
  session.link().setSilent(true);
  session.run(1000);
  const TickLog& log = session.loop().log();
  double least_held = 100.0, silence_at_zero = 100.0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log.at(i).stamp_ns < last_word) continue;
    const double strength = glm::length(log.at(i).force_D);
    if (log.at(i).link_silence <= 0.600) least_held = std::min(least_held, strength);
    if (strength == 0.0) silence_at_zero = std::min(silence_at_zero, log.at(i).link_silence);
  }
  EXPECT_GT(least_held, 0.98 * force);
  EXPECT_GT(silence_at_zero, 0.600);
  EXPECT_LE(silence_at_zero, 0.800);
  EXPECT_EQ(session.force(), 0.0);
}

TEST(ForceLoop, AfterASilenceTheForceComesBackThroughTheGateOnly) {
  VirtualSession session;
  session.press();
  session.link().setSilent(true);
  session.run(1000);
  session.link().setSilent(false);
  session.run(1500);
  EXPECT_EQ(session.force(), 0.0) << "the hand still pushes: the wanted force is not small";
  session.holdAt(0.005);
  session.run(2500);
  session.max_step = 0.0;
  for (int i = 0; i < 1500; ++i) {
    session.holdAt(0.005 - 0.00001 * i);
    session.run(1);
  }
  EXPECT_GT(session.force(), 2.0);
  EXPECT_LT(session.max_step, 0.1);
}

TEST(ForceLoop, AClientThatLivesButSaysNoSetForTwoSecondsLosesItsForce) {
  VirtualSession session({}, 1000.0, SafetyOptions{}.set_silence_limit);
  const auto saySets = [&](int ticks, double height_step = 0.0) { session.saySets(ticks, 100, height_step); };
  session.holdAt(0.005);
  session.link().sendControl({.forces_enabled = true});
  saySets(1500);
  saySets(150, -1e-4);
  saySets(1000);
  const double pressed = session.force();
  ASSERT_GT(pressed, 2.0);
  session.max_step = 0.0;
  session.run(1800);
  EXPECT_NEAR(session.force(), pressed, 0.02 * pressed) << "a loop that is slow only is waited for";
  EXPECT_FALSE(session.state().client_stalled);
  session.run(700);
  EXPECT_EQ(session.force(), 0.0);
  EXPECT_TRUE(session.state().client_stalled);
  EXPECT_LT(session.max_step, 0.1);

  saySets(1500);
  EXPECT_FALSE(session.state().client_stalled);
  EXPECT_EQ(session.force(), 0.0) << "the hand still pushes: the wanted force is not small";
  EXPECT_LT(session.max_step, 0.1);
  session.holdAt(0.005);
  saySets(2000);
  session.max_step = 0.0;
  saySets(1500, -1e-5);
  EXPECT_GT(session.force(), 2.0);
  EXPECT_LT(session.max_step, 0.1);
}

TEST(ForceLoop, SetsThatAreRefusedKeepNoForceAlive) {
  constexpr std::uint64_t kFarAhead = std::uint64_t{1} << 62;
  VirtualSession session({}, 1000.0, SafetyOptions{}.set_silence_limit);
  const auto saySets = [&](int ticks, double height_step = 0.0) { session.saySets(ticks, 50, height_step); };
  session.holdAt(0.005);
  session.link().sendControl({.forces_enabled = true});
  saySets(1500);
  saySets(150, -1e-4);
  saySets(1000);
  session.link().sendSet(floorSet(kFarAhead));  // "From the future": all that follow are older.
  session.run(1);
  saySets(1000);
  ASSERT_EQ(session.state().adopted_set, kFarAhead);
  ASSERT_GT(session.force(), 2.0);
  session.max_step = 0.0;
  saySets(1495);
  EXPECT_EQ(session.state().adopted_set, kFarAhead);
  EXPECT_TRUE(session.state().client_stalled);
  EXPECT_LT(session.force(), 0.1) << "what is pressed on may be long gone";

  // By then none is shut out any more, and the force comes back as after any silence.
  saySets(105);
  EXPECT_EQ(session.state().adopted_set, session.sets_said);
  EXPECT_FALSE(session.state().client_stalled);
  EXPECT_EQ(session.force(), 0.0);
  EXPECT_LT(session.max_step, 0.1);
  session.holdAt(0.005);
  saySets(2000);
  session.max_step = 0.0;
  saySets(1500, -1e-5);
  EXPECT_GT(session.force(), 2.0);
  EXPECT_LT(session.max_step, 0.1);
}

TEST(ForceLoop, ShortSilencesAreNotFelt) {
  VirtualSession session;
  session.press();
  session.max_step = 0.0;
  for (int i = 0; i < 5; ++i) {
    session.link().setSilent(true);
    session.run(450);
    session.link().setSilent(false);
    session.run(150);
  }
  EXPECT_LT(session.max_step, 0.05);
  EXPECT_GT(session.force(), 2.0);
}

TEST(ForceLoop, ANewClientBeginsFromNothing) {
  VirtualSession session;
  session.press();
  session.link().disconnect();
  session.link().connect();  // Between two ticks: the loop never sees the link closed.
  session.holdAt(-0.010);
  session.link().sendSet(floorSet(1));
  session.run(50);
  EXPECT_EQ(session.force(), 0.0);
  EXPECT_FALSE(session.state().forces_on) << "the earlier client's enabling does not count";
  EXPECT_EQ(session.state().adopted_set, 1u) << "and its sequence numbers neither";
}

TEST(ForceLoop, AMessageOfAnEarlierClientIsNotTaken) {
  VirtualClock clock;
  SimulatedDevice device;
  ASSERT_TRUE(device.open());
  ForceLoop loop(device, clock, patientOptionsFor(device));
  loop.openLink();
  loop.submit(floorSet(5));
  loop.submit(HapticControl{.forces_enabled = true});
  loop.openLink();  // Another client, before the loop has taken anything.
  for (int i = 0; i < 10; ++i) loop.tick();
  EXPECT_EQ(loop.current().adopted_set, 0u);
  EXPECT_FALSE(loop.current().forces_on);
}

TEST(ForceLoop, MessagesSentTogetherWithTheNewLinkAreTaken) {
  VirtualSession session;
  session.link().sendControl({.forces_enabled = true});
  session.run(2000);
  EXPECT_TRUE(session.state().forces_on);
}

}  // namespace
}  // namespace hapticell::haptic
