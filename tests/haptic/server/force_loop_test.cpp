// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/force_loop.h"

#include <gtest/gtest.h>

#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

TEST(ForceLoop, MakesNoForceUntilAClientEnablesIt) {
  VirtualSession session;
  session.holdAt(-0.010);
  session.link().sendSet(floorSet(1));
  session.run(1000);
  EXPECT_EQ(session.max_force, 0.0);
  EXPECT_FALSE(session.state().forces_on);
  EXPECT_LT(session.state().X_DS.p.z, -0.009) << "the hand goes through the floor that is not felt";
}

TEST(ForceLoop, FreeMotionIsFree) {
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

TEST(ForceLoop, APressedFloorAnswersWithStiffnessTimesDepth) {
  VirtualSession session;
  session.press();
  const double depth = -session.state().X_DS.p.z;
  // The hand's spring (300 N/m, 10 mm) against the floor's (1000 N/m): 2.31 N, less the friction of 0.06 N.
  EXPECT_NEAR(session.force(), 10e-3 / (1.0 / 300.0 + 1.0 / 1000.0), 0.15);
  EXPECT_NEAR(session.force(), 1000.0 * depth, 0.03 * session.force());
  EXPECT_NEAR(session.state().X_DP.p.z, 0.0, 2e-5) << "the proxy stays on the floor";
  EXPECT_EQ(session.state().adopted_set, 1u);
}

TEST(ForceLoop, TheSameSessionTwiceIsTheSameToTheLastBit) {
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

TEST(ForceLoop, TheFeelDoesNotDependOnTheClientsRate) {
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

TEST(ForceLoop, SkippedTicksAreCountedAndThePhysicsCatchesUp) {
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

TEST(ForceLoop, OtherRatesFeelTheSame) {
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

TEST(ForceLoop, TheClientMayAskForAnotherStiffness) {
  VirtualSession session;
  session.engage();
  session.link().sendControl({.forces_enabled = true, .stiffness = 400.0});
  session.holdAt(-0.010);
  session.run(2000);
  EXPECT_NEAR(session.force(), 400.0 * -session.state().X_DS.p.z, 0.05 * session.force());
  EXPECT_NEAR(session.force(), 10e-3 / (1.0 / 300.0 + 1.0 / 400.0), 0.15);
}

TEST(ForceLoop, AnOutdatedSetAndOneElsewhereChangeNothing) {
  VirtualSession session;
  session.press();
  session.link().sendSet(floorSet(1));  // StartFrom: its number counts for 2.5 s.
  session.run(200);
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
  session.run(200);  // Figures are told ten times a second.
  EXPECT_EQ(session.link().latestStatistics().value_or(ServerStatistics{}).refused_sets, 2u);
}

TEST(ForceLoop, CountsTheSetsThatAreLateAndTakesThem) {
  VirtualSession session({.latency = 0.150});
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    ConstraintSet set = floorSet(sequence);
    set.stamp_ns = session.clock.now();
    session.link().sendSet(set);
    session.run(400);
  }
  EXPECT_EQ(session.state().adopted_set, 3u);
  const auto statistics = session.link().latestStatistics();
  ASSERT_TRUE(statistics.has_value());
  EXPECT_EQ(statistics->late_sets, 3u);
  EXPECT_EQ(statistics->refused_sets, 0u);
}

TEST(ForceLoop, TellsTheAgeOfSets) {
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

}  // namespace
}  // namespace hapticell::haptic
