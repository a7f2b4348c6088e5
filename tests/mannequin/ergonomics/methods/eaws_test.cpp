// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/eaws.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstddef>

namespace hapticell::ergonomics {
namespace {

using Shares = std::array<double, kEawsPostureCount>;

Shares sharesOf(EawsPosture posture, double share) {
  Shares shares{};
  shares[static_cast<std::size_t>(posture)] = share;
  return shares;
}

TEST(Eaws, ALineIsChosenByTheTrunkAndTheArms) {
  EXPECT_EQ(eawsPosture({.trunk_flexion = 20.0}), EawsPosture::kStandNoSupport);
  EXPECT_EQ(eawsPosture({.trunk_flexion = 20.1}), EawsPosture::kStandBentForward);
  EXPECT_EQ(eawsPosture({.trunk_flexion = -30.0}), EawsPosture::kStandBentForward) << "either way";
  EXPECT_EQ(eawsPosture({.trunk_flexion = 60.1}), EawsPosture::kStandBentFar);
  EXPECT_EQ(eawsPosture({.trunk_flexion = 70.0, .hands_above_head = true}), EawsPosture::kStandHandsAboveHead)
      << "raised arms count before a bent trunk";
  EXPECT_EQ(eawsPosture({.elbow_at_shoulder = true, .seated = true}), EawsPosture::kSitElbowAtShoulder);
  EXPECT_EQ(eawsPosture({.trunk_flexion = 30.0, .kneeling = true}), EawsPosture::kKneelBentForward);
  EXPECT_EQ(eawsPosture({.walking = true}), EawsPosture::kStandAndWalkAlternating);
  EXPECT_EQ(eawsPosture({.seated = true, .trunk_supported = true}), EawsPosture::kSitBackSupport);
}

RC_GTEST_PROP(Eaws, PointsGrowWithTheShareAndAddUp, ()) {
  const auto posture = static_cast<EawsPosture>(*rc::gen::inRange(0, static_cast<int>(kEawsPostureCount)));
  const double less = *rc::gen::inRange(0, 1001) * 1e-3, more = less + (1.0 - less) * *rc::gen::inRange(0, 1001) * 1e-3;
  const double few = eawsPosturePoints(sharesOf(posture, less)), many = eawsPosturePoints(sharesOf(posture, more));
  RC_ASSERT(few >= 0.0);
  RC_ASSERT(many >= few - 1e-12);
  const EawsPosture easy = easiestOfKind(posture);
  RC_ASSERT(eawsPosturePoints(sharesOf(easy, more)) <= many + 1e-12);
  RC_ASSERT(easiestOfKind(easy) == easy);
}

TEST(Eaws, DriversAreTheLinesTheCostliestFirst) {
  Shares shares{};
  shares[static_cast<std::size_t>(EawsPosture::kStandBentFar)] = 0.3;
  shares[static_cast<std::size_t>(EawsPosture::kStandHandsAboveHead)] = 0.2;
  shares[static_cast<std::size_t>(EawsPosture::kStandNoSupport)] = 0.5;
  const auto drivers = eawsDrivers(shares);
  ASSERT_GE(drivers.size(), 2u);
  double sum = 0.0;
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    EXPECT_GT(drivers[i].points, 0.0);
    if (i > 0) {
      EXPECT_GE(drivers[i - 1].points, drivers[i].points);
    }
    EXPECT_LE(drivers[i].score, eawsPosturePoints(shares) + 1e-9);
    sum += drivers[i].points;
  }
  EXPECT_NEAR(sum, eawsPosturePoints(shares), 1e-9);
}

TEST(Eaws, ShiftsBringTheLevelDownAndNoMoreThanNeeded) {
  const Shares hard = sharesOf(EawsPosture::kStandBentFar, 0.6);
  const int level = eawsLevel(eawsPosturePoints(hard));
  ASSERT_GT(level, 1);
  const auto shifts = eawsNextLevel(hard);
  ASSERT_FALSE(shifts.empty());
  Shares shifted = hard;
  for (const EawsShift& shift : shifts) {
    EXPECT_EQ(easiestOfKind(shift.from), shift.to);
    EXPECT_GT(shift.share, 0.0);
    shifted[static_cast<std::size_t>(shift.from)] -= shift.share;
    shifted[static_cast<std::size_t>(shift.to)] += shift.share;
    EXPECT_NEAR(eawsPosturePoints(shifted), shift.score, 1e-9);
  }
  EXPECT_LT(eawsLevel(eawsPosturePoints(shifted)), level);
  shifted[static_cast<std::size_t>(shifts.back().from)] += 0.002;
  shifted[static_cast<std::size_t>(shifts.back().to)] -= 0.002;
  EXPECT_EQ(eawsLevel(eawsPosturePoints(shifted)), level) << "a little less would not be enough";
  EXPECT_TRUE(eawsNextLevel(Shares{}).empty()) << "the least level";
}

TEST(Eaws, LevelsAreGreenYellowAndRed) {
  EXPECT_EQ(eawsLevel(0.0), 1);
  EXPECT_EQ(eawsLevel(25.0), 1);
  EXPECT_EQ(eawsLevel(25.01), 2);
  EXPECT_EQ(eawsLevel(50.0), 2);
  EXPECT_EQ(eawsLevel(50.01), 3);
}

}  // namespace
}  // namespace hapticell::ergonomics
