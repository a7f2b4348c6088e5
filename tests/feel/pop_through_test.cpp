// SPDX-License-Identifier: Apache-2.0
// M8 of docs/dev/feel.md: a thin plate is never passed through, however the stylus is dragged and however slow the
// client is.
#include "feel/pop_through.h"

#include <gtest/gtest.h>

namespace hapticell::feel {
namespace {

class PopThrough : public ::testing::TestWithParam<int> {};

TEST_P(PopThrough, NeverHappens) {
  SweepSetup setup;
  setup.rate = kRates[GetParam()];
  setup.sweeps = 1500;
  const SweepOutcome outcome = sweepThroughPlate(setup);
  EXPECT_EQ(outcome.pops, 0);
  EXPECT_EQ(outcome.blocked, 0);
  EXPECT_LE(outcome.penetration, 0.05e-3);
}

TEST_P(PopThrough, NeverHappensWithStallsAndNarrowZones) {
  SweepSetup setup;
  setup.rate = kRates[GetParam()];
  setup.sweeps = 400;
  setup.stalls = true;
  setup.zone_share = 1.0 / 3.0;
  const SweepOutcome outcome = sweepThroughPlate(setup);
  EXPECT_EQ(outcome.pops, 0);
  EXPECT_LE(outcome.penetration, 0.05e-3);
}

INSTANTIATE_TEST_SUITE_P(Rates, PopThrough, ::testing::Values(0, 1, 2));

TEST(PopThroughCheck, FindsTheClassicPlanesPops) {
  SweepSetup setup;
  setup.rate = kRates[0];
  setup.sweeps = 50;
  setup.classic = true;
  EXPECT_GT(sweepThroughPlate(setup).pops, 5);
}

TEST(PopThroughCheck, FindsARealPop) {
  EXPECT_TRUE(crossesPlate({0, 0, 0.001}, {0, 0, -0.001}));
  EXPECT_FALSE(crossesPlate({0.049, 0, 0.001}, {0.051, 0, -0.001}));
  EXPECT_FALSE(crossesPlate({0, 0, 0.002}, {0, 0, 0.001}));
}

}  // namespace
}  // namespace hapticell::feel
