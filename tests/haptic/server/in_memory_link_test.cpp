// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/in_memory_link.h"

#include <gtest/gtest.h>

#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

TEST(InMemoryLink, TellsTheDeviceAndIsConnectedFromTheStart) {
  VirtualSession session;
  EXPECT_EQ(session.link().linkState(), LinkState::kConnected);
  EXPECT_TRUE(session.link().problem().empty());
  ASSERT_TRUE(session.link().device().has_value());
  EXPECT_EQ(session.link().device()->peak_force, 6.4);
  EXPECT_TRUE(session.link().device()->simulated);
  session.link().disconnect();
  EXPECT_EQ(session.link().linkState(), LinkState::kDisconnected);
  EXPECT_FALSE(session.link().problem().empty());
  EXPECT_FALSE(session.link().device().has_value());
}

TEST(InMemoryLink, AStateArrivesAfterTheLatencyAndOnlyOnce) {
  VirtualSession session({.latency = 0.020});
  session.run(20);
  EXPECT_FALSE(session.link().latestState().has_value());
  session.run(1);
  const auto first = session.link().latestState();
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->tick, 1u);
  EXPECT_FALSE(session.link().latestState().has_value());
  session.run(30);
  EXPECT_EQ(session.link().latestState()->tick, 31u) << "the newest that has arrived, the others are dropped";
}

TEST(InMemoryLink, APressBetweenTwoLooksIsSeenOnce) {
  VirtualSession session;
  session.run(5);
  EXPECT_EQ(session.link().latestState()->buttons, 0u);
  session.link().sendHandTarget({.holding = true, .buttons = 1});
  session.run(30);
  session.link().sendHandTarget({.holding = true, .buttons = 0});
  session.run(30);
  EXPECT_EQ(session.link().latestState()->buttons, 1u) << "it was let go long ago";
  session.run(1);
  EXPECT_EQ(session.link().latestState()->buttons, 0u);
  // One that is held is over with it.
  session.link().sendHandTarget({.holding = true, .buttons = 1});
  session.run(30);
  EXPECT_EQ(session.link().latestState()->buttons, 1u);
  session.link().sendHandTarget({.holding = true, .buttons = 0});
  session.run(30);
  EXPECT_EQ(session.link().latestState()->buttons, 0u);
}

TEST(PressLatch, ForgetsWhatWasPressedBeforeAnotherConnection) {
  PressLatch latch;
  latch.hear(1);
  latch.forget();
  EXPECT_EQ(latch.take(0), 0u);
  latch.hear(1);
  EXPECT_EQ(latch.take(1), 1u);
  EXPECT_EQ(latch.take(1), 1u);
  EXPECT_EQ(latch.take(0), 0u);
}

TEST(InMemoryLink, ASetReachesTheLoopAfterTheLatency) {
  VirtualSession session({.latency = 0.020});
  session.run(100);
  session.link().sendSet(floorSet(3));
  session.run(19);
  EXPECT_EQ(session.state().adopted_set, 0u);
  session.run(1);
  EXPECT_EQ(session.state().adopted_set, 3u);
}

TEST(InMemoryLink, WithoutLatencyASetCountsAtTheNextTick) {
  VirtualSession session;
  session.run(10);
  session.link().sendSet(floorSet(3));
  session.run(1);
  EXPECT_EQ(session.state().adopted_set, 3u);
  EXPECT_EQ(session.link().latestState()->adopted_set, 3u);
}

TEST(InMemoryLink, JitterKeepsTheOrder) {
  VirtualSession session({.latency = 0.001, .jitter = 0.050, .seed = 3});
  std::uint64_t last = 0, ticks_with_news = 0;
  for (int i = 0; i < 2000; ++i) {
    session.run(1);
    const auto state = session.link().latestState();
    if (!state) continue;
    EXPECT_GT(state->tick, last);
    last = state->tick;
    ++ticks_with_news;
  }
  EXPECT_GT(last, 1900u);
  EXPECT_LT(ticks_with_news, 1500u) << "jitter bunches them";
}

TEST(InMemoryLink, LosesTheShareItWasToldAndNeverAControl) {
  VirtualSession session({.loss = 0.3});
  int heard = 0;
  for (int i = 0; i < 4000; ++i) {
    session.run(1);
    heard += session.link().latestState().has_value();
  }
  EXPECT_NEAR(heard / 4000.0, 0.7, 0.03);
  VirtualSession lossy({.loss = 1.0});
  lossy.link().sendControl({.forces_enabled = true});
  lossy.run(2000);
  EXPECT_TRUE(lossy.state().forces_on);
}

}  // namespace
}  // namespace hapticell::haptic
