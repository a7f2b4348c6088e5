// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/force_loop.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

constexpr int kWithin50Milliseconds = 50;  // Ticks.

TEST(ForceLoop, makes_no_force_until_a_client_enables_it) {
  VirtualSession session;
  session.holdAt(-0.010);
  session.link().sendSet(floorSet(1));
  session.run(1000);
  EXPECT_EQ(session.max_force, 0.0);
  EXPECT_FALSE(session.state().forces_on);
  EXPECT_LT(session.state().X_DS.p.z, -0.009) << "the hand goes through the floor that is not felt";
}

TEST(ForceLoop, free_motion_is_free) {
  VirtualSession session;
  session.engage();
  EXPECT_TRUE(session.state().forces_on);
  EXPECT_EQ(session.state().force_ramp, 1.0);
  session.max_force = 0.0;
  for (int i = 0; i < 1000; ++i) {
    session.holdAt(0.010 + 0.004 * std::sin(0.02 * i));
    session.run(1);
  }
  EXPECT_EQ(session.max_force, 0.0);
}

TEST(ForceLoop, a_pressed_floor_answers_with_stiffness_times_depth) {
  VirtualSession session;
  session.press();
  const double depth = -session.state().X_DS.p.z;
  // The hand's spring (300 N/m, 10 mm) against the floor's (1000 N/m): 2.31 N, less the friction of 0.06 N.
  EXPECT_NEAR(session.force(), 10e-3 / (1.0 / 300.0 + 1.0 / 1000.0), 0.15);
  EXPECT_NEAR(session.force(), 1000.0 * depth, 0.03 * session.force());
  EXPECT_NEAR(session.state().X_DP.p.z, 0.0, 2e-5) << "the proxy stays on the floor";
  EXPECT_EQ(session.state().adopted_set, 1u);
}

TEST(ForceLoop, the_same_session_twice_is_the_same_to_the_last_bit) {
  const auto trace = [] {
    VirtualSession session({.latency = 0.01, .jitter = 0.02, .loss = 0.1, .seed = 5});
    std::vector<dvec3> forces;
    session.engage();
    for (int i = 0; i < 1000; ++i) {
      session.holdAt(0.002 * std::sin(0.01 * i) - 0.002);
      if (i % 16 == 0) session.link().sendSet(floorSet(2 + static_cast<std::uint64_t>(i)));
      session.run(1);
      forces.push_back(session.state().force_D);
    }
    return forces;
  };
  EXPECT_EQ(trace(), trace());
}

TEST(ForceLoop, the_feel_does_not_depend_on_the_clients_rate) {
  struct Client {
    int period_ticks;
    double latency;
  };
  std::vector<double> forces;
  for (const Client& client : {Client{100, 0.050}, Client{16, 0.010}, Client{1, 0.001}}) {
    VirtualSession session({.latency = client.latency});
    session.engage();
    session.max_step = 0.0;
    for (int i = 0; i < 3000; ++i) {
      session.holdAt(std::max(-0.010, 0.005 - 0.00001 * i));
      if (i % client.period_ticks == 0) {
        const dvec3 p_DP = session.state().X_DP.p;
        session.link().sendSet(floorSet(2 + static_cast<std::uint64_t>(i), 0.0, p_DP));
      }
      session.run(1);
    }
    EXPECT_LT(session.max_step, 0.1) << "every " << client.period_ticks << " ms";
    forces.push_back(session.force());
  }
  EXPECT_NEAR(forces[1], forces[0], 0.02 * forces[0]);
  EXPECT_NEAR(forces[2], forces[0], 0.02 * forces[0]);
}

TEST(ForceLoop, a_set_is_held_while_the_link_lives_however_old) {
  VirtualSession session;
  session.engage();
  session.holdAt(-0.004);  // 0.9 N: less than the motors bear for ever.
  session.run(1000);
  const double force = session.force();
  ASSERT_GT(force, 0.8);
  session.run(20'000);
  EXPECT_NEAR(session.force(), force, 0.03);
}

TEST(ForceLoop, a_closed_link_takes_the_force_to_zero_within_50_ms) {
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

TEST(ForceLoop, a_silent_link_is_held_for_600_ms_and_then_fades_in_200) {
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

TEST(ForceLoop, after_a_silence_the_force_comes_back_through_the_gate_only) {
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

TEST(ForceLoop, a_client_that_lives_but_says_no_set_for_two_seconds_loses_its_force) {
  VirtualSession session({}, 1000.0, SafetyOptions{}.set_silence_limit);
  const auto saySets = [&](int ticks, double height_step = 0.0) {
    for (int i = 0; i < ticks; ++i) {
      if (height_step != 0.0) session.holdAt(0.005 + height_step * i);
      if (i % 100 == 0) session.link().sendSet(floorSet(++session.sets_said));
      session.run(1);
    }
  };
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

TEST(ForceLoop, short_silences_are_not_felt) {
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

TEST(ForceLoop, a_new_client_begins_from_nothing) {
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

TEST(ForceLoop, a_message_of_an_earlier_client_is_not_taken) {
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

TEST(ForceLoop, messages_sent_together_with_the_new_link_are_taken) {
  VirtualSession session;
  session.link().sendControl({.forces_enabled = true});
  session.run(2000);
  EXPECT_TRUE(session.state().forces_on);
}

TEST(ForceLoop, skipped_ticks_are_counted_and_the_physics_catches_up) {
  VirtualSession smooth, rough;
  for (VirtualSession* session : {&smooth, &rough}) {
    session->link().sendHandTarget(HandTarget{});
    session->device.place(Pose::translation(dvec3(0.0, 0.0, 0.05)));
  }
  smooth.run(100);  // Nobody holds it: it sinks under what the counterweights leave of its weight.
  for (int i = 0; i < 10; ++i) rough.link().step(9);
  EXPECT_EQ(smooth.state().tick, 100u);
  EXPECT_EQ(rough.state().tick, 100u);
  EXPECT_EQ(rough.clock.now(), smooth.clock.now());
  EXPECT_NEAR(rough.device.truePose().p.z, smooth.device.truePose().p.z, 1e-4);
  smooth.loop().shutDown();
  rough.loop().shutDown();
  ASSERT_TRUE(rough.loop().updateReport() && smooth.loop().updateReport());
  EXPECT_EQ(rough.loop().report().ticks, 10u);
  EXPECT_EQ(rough.loop().report().missed, 90u);
  EXPECT_EQ(smooth.loop().report().missed, 0u);
}

TEST(ForceLoop, other_rates_feel_the_same) {
  for (const double rate : {500.0, 2000.0}) {
    VirtualSession session({}, rate);
    session.holdAt(0.005);
    session.link().sendControl({.forces_enabled = true});
    session.link().sendSet(floorSet(1));
    session.run(static_cast<int>(1.5 * rate));
    session.holdAt(-0.010);
    session.run(static_cast<int>(1.5 * rate));
    EXPECT_NEAR(session.force(), 2.31, 0.2) << rate << " Hz";
  }
}

TEST(ForceLoop, the_client_may_ask_for_another_stiffness) {
  VirtualSession session;
  session.engage();
  session.link().sendControl({.forces_enabled = true, .stiffness = 400.0});
  session.holdAt(-0.010);
  session.run(2000);
  EXPECT_NEAR(session.force(), 400.0 * -session.state().X_DS.p.z, 0.05 * session.force());
  EXPECT_NEAR(session.force(), 10e-3 / (1.0 / 300.0 + 1.0 / 400.0), 0.15);
}

TEST(ForceLoop, an_outdated_set_and_one_elsewhere_change_nothing) {
  VirtualSession session;
  session.press();
  session.link().sendSet(floorSet(0, 0.004));
  session.run(200);
  EXPECT_EQ(session.state().adopted_set, 1u);
  ConstraintSet elsewhere = floorSet(9, 0.004, dvec3(1.0, 0.0, 0.0));
  session.link().sendSet(elsewhere);
  session.run(200);
  EXPECT_EQ(session.state().adopted_set, 1u);
  session.link().sendSet(floorSet(10));
  session.run(5);
  EXPECT_EQ(session.state().adopted_set, 10u);
}

TEST(ForceLoop, tells_the_age_of_sets) {
  VirtualSession session({.latency = 0.050});
  for (int i = 0; i < 1000; ++i) {
    ConstraintSet set = floorSet(1 + static_cast<std::uint64_t>(i));
    set.stamp_ns = session.clock.now();
    session.link().sendSet(set);
    session.run(1);
  }
  const auto statistics = session.link().latestStatistics();
  ASSERT_TRUE(statistics.has_value());
  EXPECT_NEAR(statistics->set_age_p50_ms, 50.5, 3.5);
  EXPECT_NEAR(statistics->rate_hz, 1000.0, 1.0);
  EXPECT_EQ(statistics->missed_ticks, 0u);
  EXPECT_EQ(statistics->late_max_ms, 0.0);
}

/// A device that can be told to fail.
class FailingDevice final : public Device {
 public:
  const DeviceCapabilities& capabilities() const override { return inner.capabilities(); }
  Expected<void> open() override { return inner.open(); }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    return failing ? DeviceStatus::kFault : inner.read(reading);
  }
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override {
    written = force_D;
    return inner.write(force_D, torque_D);
  }
  void close() noexcept override {
    closed = true;
    inner.close();
  }

  SimulatedDevice inner;
  dvec3 written{0.0};
  bool failing = false, closed = false;
};

TEST(ForceLoop, a_device_that_fails_gets_no_force_and_must_be_enabled_anew) {
  VirtualClock clock;
  FailingDevice device;
  ASSERT_TRUE(device.open());
  device.inner.hand().hold(Pose::translation(dvec3(0.0, 0.0, 0.005)));
  ForceLoop loop(device, clock, patientOptionsFor(device));
  InMemoryLink link(loop, clock, describe(device));
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      device.inner.advance(0.001);  // Not seen as a simulated one: the test lets its time pass.
      link.step();
    }
  };
  link.sendSet(floorSet(1));
  link.sendControl({.forces_enabled = true});
  run(1500);
  device.inner.hand().hold(Pose::translation(dvec3(0.0, 0.0, -0.010)));
  run(1000);
  ASSERT_GT(glm::length(device.written), 2.0);
  device.failing = true;
  run(1);
  EXPECT_EQ(device.written, dvec3(0.0));
  EXPECT_TRUE(loop.current().device_fault);
  device.failing = false;
  run(2000);
  EXPECT_EQ(device.written, dvec3(0.0)) << "not before the client enables forces anew";
  EXPECT_FALSE(loop.current().device_fault);
}

TEST(ForceLoop, shutting_down_stops_the_motors_for_good) {
  VirtualClock clock;
  FailingDevice device;
  ASSERT_TRUE(device.open());
  ForceLoop loop(device, clock, patientOptionsFor(device));
  device.written = dvec3(1.0);
  loop.shutDown();
  EXPECT_EQ(device.written, dvec3(0.0));
  EXPECT_TRUE(device.closed);
  device.written = dvec3(7.0);
  loop.tick();
  EXPECT_EQ(device.written, dvec3(7.0)) << "no tick after the end";
}

RC_GTEST_PROP(ForceLoop, nothing_that_happens_to_the_link_breaks_clamp_or_slew, ()) {
  VirtualSession session({.latency = 0.001 * *rc::gen::inRange(0, 60), .jitter = 0.02, .loss = 0.2});
  session.engage();
  const int events = *rc::gen::inRange(5, 40);
  std::uint64_t sequence = 2;
  for (int i = 0; i < events; ++i) {
    switch (*rc::gen::inRange(0, 7)) {
      case 0:
        session.link().disconnect();
        break;
      case 1:
        session.link().connect();
        break;
      case 2:
        session.link().setSilent(true);
        break;
      case 3:
        session.link().setSilent(false);
        break;
      case 4:
        session.holdAt(0.001 * *rc::gen::inRange(-40, 10));
        break;
      case 5:
        session.link().sendControl({.forces_enabled = *rc::gen::arbitrary<bool>()});
        break;
      default:
        session.link().sendSet(floorSet(++sequence, 0.001 * *rc::gen::inRange(-5, 30)));
        break;
    }
    session.run(*rc::gen::inRange(1, 400));
  }
  RC_ASSERT(session.max_force <= 6.4 + 1e-9);
  RC_ASSERT(session.max_step <= 1.0 + 1e-9);
}

}  // namespace
}  // namespace hapticell::haptic
