// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "haptic/rendering/force_renderer.h"
#include "haptic/server/client_inbox.h"
#include "haptic/server/tick_log.h"

namespace hapticell::haptic {
namespace {

TEST(TickLog, KeepsTheLastTicksTheOldestFirst) {
  TickLog log(4);
  EXPECT_EQ(log.size(), 0u);
  for (std::uint64_t tick = 1; tick <= 3; ++tick) log.add({.tick = tick});
  ASSERT_EQ(log.size(), 3u);
  EXPECT_EQ(log.at(0).tick, 1u);
  for (std::uint64_t tick = 4; tick <= 11; ++tick) log.add({.tick = tick});
  ASSERT_EQ(log.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(log.at(i).tick, 8 + i);
  TickLog least(0);
  least.add({.tick = 5});
  EXPECT_EQ(least.at(0).tick, 5u) << "room for one at least";
}

ConstraintSet setOfNumber(std::uint64_t sequence) {
  ConstraintSet set;
  set.sequence = sequence;
  return set;
}

TEST(ClientInbox, TheNewestOfASessionIsTakenOnce) {
  const auto inbox = std::make_unique<ClientInbox>();
  EXPECT_FALSE(inbox->isOpen());
  EXPECT_FALSE(inbox->beginSession());
  inbox->open(1'000'000'000);
  EXPECT_TRUE(inbox->isOpen());
  inbox->submit(setOfNumber(1));
  inbox->submit(setOfNumber(2));
  EXPECT_EQ(inbox->takeSet(), nullptr) << "the session has not begun for the loop";
  EXPECT_TRUE(inbox->beginSession());
  EXPECT_FALSE(inbox->beginSession()) << "once";
  const GroupedSet* set = inbox->takeSet();
  ASSERT_NE(set, nullptr);
  EXPECT_EQ(set->sequence, 2u);
  EXPECT_TRUE(set->well_formed);
  EXPECT_EQ(inbox->takeSet(), nullptr);
  inbox->submit(HapticControl{.forces_enabled = true});
  ASSERT_NE(inbox->takeControl(), nullptr);
  EXPECT_EQ(inbox->takeHandTarget(), nullptr);
}

TEST(ClientInbox, SaysOfASetWithNoNumbersThatItIsNotWellFormed) {
  const auto inbox = std::make_unique<ClientInbox>();
  inbox->open(0);
  ASSERT_TRUE(inbox->beginSession());
  ConstraintSet set = setOfNumber(1);
  set.zone_radius = std::numeric_limits<double>::quiet_NaN();
  inbox->submit(set);
  const GroupedSet* prepared = inbox->takeSet();
  ASSERT_NE(prepared, nullptr);
  EXPECT_FALSE(prepared->well_formed);
  ForceRenderer renderer;
  EXPECT_EQ(renderer.adopt(*prepared, 0.0), Adoption::kMalformed);
}

TEST(ClientInbox, WhatAnEarlierClientSentIsNotTaken) {
  const auto inbox = std::make_unique<ClientInbox>();
  inbox->open(0);
  ASSERT_TRUE(inbox->beginSession());
  inbox->submit(setOfNumber(7));
  inbox->close();
  EXPECT_FALSE(inbox->isOpen());
  inbox->open(5'000'000'000);
  EXPECT_TRUE(inbox->beginSession());
  EXPECT_EQ(inbox->takeSet(), nullptr);
  inbox->submit(setOfNumber(1));
  ASSERT_NE(inbox->takeSet(), nullptr);
}

TEST(ClientInbox, SilenceIsCountedFromTheLastSignOfLife) {
  const auto inbox = std::make_unique<ClientInbox>();
  inbox->open(1'000'000'000);
  EXPECT_NEAR(inbox->silence(1'250'000'000), 0.25, 1e-12);
  inbox->heard(1'200'000'000);
  EXPECT_NEAR(inbox->silence(1'250'000'000), 0.05, 1e-12);
  EXPECT_EQ(inbox->silenceLimit(), 0.0);
  inbox->expectWithin(0.02);
  EXPECT_EQ(inbox->silenceLimit(), 0.02);
}

}  // namespace
}  // namespace hapticell::haptic
