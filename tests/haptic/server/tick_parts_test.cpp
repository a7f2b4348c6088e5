// SPDX-License-Identifier: Apache-2.0
// The parts that a tick of the force loop consists of.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/loop_output.h"
#include "haptic/server/simulated_hand_driver.h"
#include "haptic/server/stall_watch.h"
#include "haptic/server/stylus_reader.h"
#include "haptic/server/tick_recorder.h"
#include "tests/haptic/server/scripted_hardware.h"

namespace hapticell::haptic {
namespace {

constexpr double kTick = 0.001;

TEST(StallWatch, SwitchesMotorsOffUntilTheClientDisablesForces) {
  ScriptedDevice device;
  StallWatch watch(device);
  EXPECT_FALSE(watch.note(StallWatch::kStall - 1, true));
  EXPECT_TRUE(device.motors);
  EXPECT_TRUE(watch.note(StallWatch::kStall, true)) << "they go off now";
  EXPECT_FALSE(device.motors);
  EXPECT_FALSE(watch.note(StallWatch::kStall, true)) << "they are off already";
  EXPECT_FALSE(watch.note(0, true));
  EXPECT_TRUE(watch.motorsOff()) << "forces are still enabled";
  EXPECT_FALSE(watch.note(0, false));
  EXPECT_FALSE(watch.motorsOff());
  EXPECT_TRUE(device.motors);
  EXPECT_EQ(watch.stalls(), 2u);
}

TEST(StallWatch, OnlyCountsForASimulatedDevice) {
  SimulatedDevice device;
  StallWatch watch(device);
  EXPECT_FALSE(watch.note(1000, true));
  EXPECT_FALSE(watch.motorsOff());
  EXPECT_EQ(watch.stalls(), 1u);
}

TEST(LoopOutput, PublishesTheStateEachTickAndFiguresTenTimesASecond) {
  LoopOutput output(1000.0);
  int published = 0;
  for (int tick = 1; tick <= 1000; ++tick) {
    HapticState state;
    state.tick = static_cast<std::uint64_t>(tick);
    state.server_stamp_ns = tick * std::int64_t{1'000'000};
    output.publish(state, 0, tick == 500 ? 3 : 0);
    ASSERT_TRUE(output.states().update());
    ASSERT_EQ(output.states().value().tick, state.tick);
    published += output.figures().update() ? 1 : 0;
  }
  EXPECT_EQ(published, 10);
  EXPECT_EQ(output.figures().value().ticks, 1000u);
  EXPECT_EQ(output.figures().value().missed, 3u);
  ASSERT_TRUE(output.report().update());
  EXPECT_EQ(output.report().value().ticks, 1000u) << "the same figures for the report";
}

TEST(TickRecorder, AFaultBeginsWithTheTickThatFindsIt) {
  TickRecorder recorder(8);
  SafetyResult safety{};
  const auto record = [&](std::uint64_t tick) {
    recorder.log({.tick = tick});
    FaultSample sample;
    sample.tick = tick;
    recorder.record(safety, sample);
  };
  for (std::uint64_t tick = 1; tick <= 10; ++tick) record(tick);
  EXPECT_EQ(recorder.faults().faults(), 0u);
  EXPECT_EQ(recorder.ticks().at(0).tick, 3u);
  safety.too_fast = true;
  for (std::uint64_t tick = 11; tick <= 20; ++tick) record(tick);
  EXPECT_EQ(recorder.faults().faults(), 1u) << "once as long as it lasts";
  safety.too_fast = false;
  record(21);
  safety.input_fault = true;
  record(22);
  EXPECT_EQ(recorder.faults().faults(), 2u);
  for (std::uint64_t tick = 23; tick <= 400 && !recorder.faults().pending(); ++tick) record(tick);
  ASSERT_TRUE(recorder.faults().pending());
  const FaultRecord fault = recorder.faults().copy();
  EXPECT_EQ(fault.kind, FaultKind::kSpeed) << "the first one";
  EXPECT_EQ(fault.samples.front().tick, 1u);
  bool has_tick = false;
  for (const FaultSample& sample : fault.samples) has_tick = has_tick || sample.tick == 11;
  EXPECT_TRUE(has_tick);
  EXPECT_NEAR(static_cast<double>(fault.tick), 11.0, 1.0);
}

TEST(SimulatedHandDriver, FollowsTheClientAndLetsGoWithIt) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  SimulatedHandDriver driver(device);
  const auto inbox = std::make_unique<ClientInbox>();
  inbox->open(0);
  ASSERT_TRUE(inbox->beginSession());
  const Pose there = Pose::translation({0.02, 0.01, 0.0});
  inbox->submit(HandTarget{.holding = true, .X_DH = there, .buttons = 1});
  DeviceReading reading;
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      driver.follow(*inbox);
      driver.advance(kTick);
    }
    ASSERT_EQ(device.read(reading), DeviceStatus::kOk);
  };
  run(3000);
  EXPECT_LT(glm::distance(reading.X_DS.p, there.p), 0.001);
  EXPECT_EQ(reading.buttons, 1u);
  inbox->close();
  run(50);
  EXPECT_EQ(reading.buttons, 0u) << "nobody holds it any more";
  ScriptedDevice hardware;
  SimulatedHandDriver none(hardware);
  none.follow(*inbox);
  none.advance(kTick);
  EXPECT_EQ(hardware.X_DS.p, dvec3(0, 0, 0.005)) << "nothing happens to hardware";
}

TEST(StylusReader, AcceptsAHandsMotionAndRefusesAJumpUnderForce) {
  ScriptedDevice device;
  StylusReader reader(device, kTick);
  EXPECT_FALSE(reader.isReady());
  StylusReader::Outcome outcome = reader.read(kTick, false);
  EXPECT_FALSE(outcome.refused);
  EXPECT_TRUE(reader.isReady());
  for (int i = 0; i < 100; ++i) {
    device.X_DS.p.x += 1e-4;  // 0.1 m/s.
    outcome = reader.read(kTick, true);
    ASSERT_FALSE(outcome.refused || outcome.jumped || outcome.impossible) << i;
  }
  EXPECT_EQ(reader.reading().X_DS.p.x, device.X_DS.p.x);
  const double before = device.X_DS.p.x;
  device.X_DS.p.x += 0.05;  // 50 m/s.
  outcome = reader.read(kTick, true);
  EXPECT_TRUE(outcome.refused);
  EXPECT_EQ(reader.reading().X_DS.p.x, before) << "the newest accepted pose";
}

TEST(StylusReader, FailsWithoutMeasurementsForKStaleAndRecovers) {
  ScriptedDevice device;
  StylusReader reader(device, kTick);
  reader.read(kTick, false);
  ASSERT_TRUE(reader.isReady());
  device.X_DS.p.x = std::numeric_limits<double>::quiet_NaN();
  int ticks = 0, failures = 0;
  for (; ticks < 100 && !reader.failing(); ++ticks) {
    const auto outcome = reader.read(kTick, true);
    EXPECT_TRUE(outcome.impossible);
    failures += outcome.fails ? 1 : 0;
  }
  EXPECT_TRUE(reader.failing());
  EXPECT_EQ(failures, 1) << "it is said once";
  EXPECT_LE(ticks * kTick, kFreshFor + 1e-9);
  EXPECT_TRUE(std::isfinite(reader.reading().X_DS.p.x));
  device.X_DS = Pose::translation({0.03, 0.0, 0.0});  // Elsewhere: accepted, because no force acts.
  for (int i = 0; i < 50 && !reader.isReady(); ++i) reader.read(kTick, false);
  EXPECT_TRUE(reader.isReady());
  EXPECT_FALSE(reader.failing());
  EXPECT_EQ(reader.reading().X_DS.p.x, 0.03);
}

TEST(ConfiguredLoop, TheConfigurationGoesOverTheDevice) {
  const ScriptedDevice device;
  config::Configuration configuration;
  configuration.haptic.stiffness = 0.0;
  configuration.haptic.damping = 0.0;
  const ForceLoopOptions plain = configuredLoop(device, configuration);
  configuration.haptic.stiffness = 321.0;
  configuration.haptic.damping = 1.25;
  configuration.haptic.force_ramp_s = 0.75;
  const ForceLoopOptions options = configuredLoop(device, configuration);
  EXPECT_EQ(options.renderer.stiffness, 321.0);
  EXPECT_EQ(options.renderer.damping, 1.25);
  EXPECT_EQ(options.safety.ramp_time, 0.75);
  EXPECT_NE(plain.renderer.stiffness, 321.0);
  EXPECT_GT(plain.renderer.stiffness, 0.0) << "0: the device's own";
  configuration.hand.mass = 0.5;
  configuration.hand.stiffness = 700.0;
  configuration.hand.damping = 9.0;
  const HandOptions hand = configuredHand(configuration);
  EXPECT_EQ(hand.mass, 0.5);
  EXPECT_EQ(hand.stiffness, 700.0);
  EXPECT_EQ(hand.damping, 9.0);
}

}  // namespace
}  // namespace hapticell::haptic
