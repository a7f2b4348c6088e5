// SPDX-License-Identifier: Apache-2.0
#include "access/removal_order.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace hapticell::access {
namespace {

using Needs = std::vector<std::vector<UnitSet>>;

std::optional<RemovalOrder> orderOf(const Needs& needs, std::size_t wanted = 0) {
  return removalOrder(needs.size(), wanted, [&](std::size_t unit) -> const auto& { return needs[unit]; });
}

bool canGo(const Needs& needs, std::size_t unit, UnitSet gone) {
  for (const UnitSet one : needs[unit])
    if ((one & ~gone) == 0) return true;
  return false;
}

/// The least number of units until `wanted` has gone: breadth first over all sets of units. 0: never.
std::size_t leastByTrying(const Needs& needs, std::size_t wanted) {
  std::vector<bool> known(std::size_t{1} << needs.size());
  std::vector<UnitSet> sets{0};
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t unit = 0; unit < needs.size(); ++unit) {
      const UnitSet now = sets[i], next = now | UnitSet{1} << unit;
      if (next == now || known[next] || !canGo(needs, unit, now)) continue;
      if (unit == wanted) return static_cast<std::size_t>(std::popcount(next));
      known[next] = true;
      sets.push_back(next);
    }
  }
  return 0;
}

TEST(RemovalOrder, IsTheShortestOfAllSetsThatCouldGo) {
  std::mt19937 random(34);
  int found = 0, never = 0;
  for (int round = 0; round < 400; ++round) {
    Needs needs(9);
    for (auto& ways : needs) {
      for (unsigned way = random() % 3; way-- > 0;) ways.push_back(random() & random() & random() % 512);
    }
    for (std::size_t unit = 0; unit < needs.size(); ++unit)
      for (UnitSet& one : needs[unit]) one &= ~(UnitSet{1} << unit);
    const auto order = orderOf(needs);
    const std::size_t least = leastByTrying(needs, 0);
    ASSERT_EQ(order.has_value(), least > 0) << round;
    (order ? found : never) += 1;
    if (!order) continue;
    EXPECT_EQ(order->units.size(), least) << round;
    EXPECT_TRUE(order->is_shortest);
    EXPECT_EQ(order->units.back(), 0u);
    UnitSet gone = 0;
    for (const std::size_t unit : order->units) {
      EXPECT_TRUE(canGo(needs, unit, gone)) << round;
      gone |= UnitSet{1} << unit;
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(never, 50);
}

TEST(RemovalOrder, OfAPublishedKindOfAssembly) {
  // A cover (0) held by two screws (1, 2) above washers (3, 4): the washers go after their screws.
  const Needs needs{{0b11000}, {0}, {0}, {0b00010}, {0b00100}};
  const auto order = orderOf(needs);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->units, (std::vector<std::size_t>{1, 2, 3, 4, 0}));
}

TEST(RemovalOrder, ThirtyPartsInAChainAndARing) {
  Needs chain(30);
  for (std::size_t i = 0; i + 1 < 30; ++i) chain[i] = {UnitSet{1} << (i + 1)};
  chain[29] = {0};
  EXPECT_EQ(orderOf(chain)->units.size(), 30u);
  chain[29] = {1};  // Each waits for the next one.
  EXPECT_FALSE(orderOf(chain));
}

}  // namespace
}  // namespace hapticell::access
