// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/beat_watch.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

struct Beating {
  void beat(double milliseconds, double round_trip = 0.0002) {
    now += static_cast<std::int64_t>(1e6 * milliseconds);
    watch.heard(now, round_trip);
  }
  BeatWatch watch;
  std::int64_t now = 7 * kMillisecond;
};

TEST(BeatWatch, AQuickHeartOnTheSameMachineIsMissedAfter28Milliseconds) {
  Beating client;
  for (int i = 0; i < 19; ++i) {
    client.beat(10.0 + 0.1 * (i % 20));
    EXPECT_EQ(client.watch.limit(), 0.0) << "no rhythm yet";
  }
  for (int i = 0; i < 500; ++i) {
    client.beat(10.0 + 0.1 * (i % 20));
    ASSERT_EQ(client.watch.limit(), BeatWatch::kShortest);
  }
}

TEST(BeatWatch, ASlowHeartHasTheServersOwnLimit) {
  Beating client;
  for (int i = 0; i < 100; ++i) {
    client.beat(100.0);
    ASSERT_EQ(client.watch.limit(), 0.0);
  }
  for (int i = 0; i < 200; ++i) client.beat(10.0);
  EXPECT_EQ(client.watch.limit(), BeatWatch::kShortest) << "it beats quicker now";
}

TEST(BeatWatch, ALateBeatGivesMoreTimeForAWhile) {
  Beating client;
  for (int i = 0; i < 100; ++i) client.beat(10.0);
  client.beat(25.0);
  EXPECT_NEAR(client.watch.limit(), 0.050, 1e-9);
  client.beat(60.0);
  EXPECT_EQ(client.watch.limit(), 0.0);
  for (int i = 0; i < 300; ++i) client.beat(10.0);
  EXPECT_EQ(client.watch.limit(), BeatWatch::kShortest);
}

TEST(BeatWatch, AFarMachineHasTheTimeOfItsRoundTrips) {
  Beating client;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> jitter(0.0, 10.0);
  for (int i = 0; i < 400; ++i) client.beat(5.0 + jitter(random), 0.040);
  EXPECT_GT(client.watch.limit(), 0.160);
  EXPECT_LT(client.watch.limit(), 0.180);
}

TEST(BeatWatch, AClockThatGoesBackAndARoundTripThatIsNoneDoNoHarm) {
  Beating client;
  for (int i = 0; i < 100; ++i) client.beat(i % 7 == 0 ? -3.6e6 : 10.0, i % 5 == 0 ? std::nan("") : 0.001);
  EXPECT_GE(client.watch.limit(), 0.0);
  EXPECT_LE(client.watch.limit(), 0.1);
}

/// A client that presses, beats every 10 ms and is gone with its socket open, as one of four gigabytes that is killed:
/// whenever that is between two beats, the device's own last command is zero 50 ms later.
TEST(ForceLoop, AClientOfAQuickHeartThatDiesLeavesNoForceAfter50Ms) {
  for (int phase = 0; phase < 10; ++phase) {
    VirtualSession session;
    session.press();
    ASSERT_GT(session.force(), 2.0);
    Beating beats;
    for (int i = 0; i < 200; ++i) {
      beats.beat(10.0);
      session.loop().expectWithin(beats.watch.limit());
      session.loop().heard();
      session.run(10);
    }
    ASSERT_GT(session.force(), 2.0);
    session.loop().heard();
    session.link().setSilent(true);
    session.run(phase);  // It dies now.
    session.run(50 - phase);
    EXPECT_EQ(session.force(), 0.0) << phase;
    EXPECT_LE(session.max_step, 1.0 + 1e-9);
  }
}

}  // namespace
}  // namespace hapticell::haptic
