// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mannequin/ergonomics/methods/eaws.h"
#include "mannequin/ergonomics/advice/posture_advice.h"
#include "mannequin/ergonomics/methods/rula.h"
#include "mannequin/ergonomics/methods/static_posture.h"

namespace hapticell::ergonomics {
namespace {

TEST(PostureAngles, FlagsFollowTheThresholds) {
  MeasuredPosture measured;
  measured.trunk_twist = -10.0;
  measured.neck_side_bend = 9.9;
  measured.upper_arm_abduction = 45.0;
  measured.wrist_twist_share = 0.76;
  measured.share_on_heavier_foot = 0.95;
  const PostureAngles angles = postureAngles(measured);
  EXPECT_EQ(angles.trunk_twisted, true);
  EXPECT_EQ(angles.neck_side_bent, false);
  EXPECT_EQ(angles.upper_arm_abducted, true);
  EXPECT_EQ(angles.wrist_twist_at_end, true);
  EXPECT_EQ(angles.legs_supported, false);
  EXPECT_FALSE(angles.arm_supported.has_value());
  PostureThresholds tolerant;
  tolerant.upright = 7.0;
  measured.trunk_flexion = 6.0;
  EXPECT_EQ(postureAngles(measured, tolerant).trunk_flexion, 0.0);
  EXPECT_EQ(postureAngles(measured).trunk_flexion, 6.0);
}

PostureAngles reaching() {
  MeasuredPosture measured;
  measured.upper_arm_flexion = 95.0;
  measured.lower_arm_flexion = 30.0;
  measured.neck_flexion = -10.0;
  measured.trunk_flexion = 25.0;
  measured.girdle_elevation = 12.0;
  return postureAngles(measured);
}

TEST(PostureAdvice, EachDriverAndTheGoalDoWhatTheySay) {
  const Rula rula;
  const PostureScore score = [&](const PostureAngles& angles) {
    std::vector<std::string_view> unknown;
    const auto values = rulaValues(angles, unknown);
    return assess(rula, values).score;
  };
  const int now = *score(reaching());
  const auto drivers = postureDrivers(reaching(), score);
  ASSERT_FALSE(drivers.empty());
  for (const PostureDriver& driver : drivers) EXPECT_LT(driver.score, now) << driver.change.field;
  const auto goal = nextLevelPosture(reaching(), score, [&](int value) { return rula.levelOf(value); });
  ASSERT_TRUE(goal.has_value());
  EXPECT_LT(rula.levelOf(goal->score), rula.levelOf(now));
  PostureAngles changed = reaching();
  for (const FieldChange& change : goal->changes) {
    for (const PostureField& field : postureFields()) {
      if (field.name != change.field) continue;
      if (field.angle != nullptr) changed.*field.angle = change.to;
      if (field.flag != nullptr) changed.*field.flag = change.to > 0.5;
    }
  }
  EXPECT_EQ(score(changed), goal->score);
}

TEST(StaticPosture, ZonesOfEn1005) {
  MeasuredPosture posture;
  EXPECT_EQ(en1005(posture, 20.0, {}).worst, Zone::kAcceptable);
  posture.trunk_flexion = 40.0;
  PostureUse use;
  use.movements_per_min = 1.0;
  EXPECT_EQ(en1005(posture, 20.0, use).worst, Zone::kConditional);
  use.movements_per_min = 3.0;
  EXPECT_EQ(en1005(posture, 20.0, use).worst, Zone::kNotAcceptable);
  posture = {};
  EXPECT_EQ(en1005(posture, -5.0, {}).worst, Zone::kNotAcceptable);  // looking up
  posture.upper_arm_flexion = -40.0;
  EXPECT_EQ(en1005(posture, 10.0, {}).worst, Zone::kNotAcceptable);  // arm behind the body
}

TEST(StaticPosture, HoldingTimesOfIso11226) {
  const auto timeOf = [](const PartVerdicts& verdicts, std::string_view part) {
    for (const PartVerdict& verdict : verdicts.parts) {
      if (verdict.part == part) return verdict.holding_time_min;
    }
    return std::optional<double>();
  };
  MeasuredPosture posture;
  posture.trunk_flexion = 40.0;
  posture.upper_arm_flexion = 40.0;
  const PartVerdicts verdicts = iso11226(posture, 55.0, {});
  EXPECT_NEAR(*timeOf(verdicts, "trunk inclination"), 2.5, 1e-12);
  EXPECT_NEAR(*timeOf(verdicts, "upper arm elevation"), 2.0, 1e-12);
  EXPECT_NEAR(*timeOf(verdicts, "head inclination"), 4.5, 1e-12);
  EXPECT_EQ(verdicts.worst, Zone::kConditional);
  PostureUse supported;
  supported.trunk_supported = supported.arm_supported = true;
  EXPECT_FALSE(timeOf(iso11226(posture, 10.0, supported), "trunk inclination").has_value());
  posture.trunk_flexion = 61.0;
  EXPECT_EQ(iso11226(posture, 0.0, supported).worst, Zone::kNotAcceptable);
}

TEST(Eaws, PointsAreLinearBetweenTheColumns) {
  std::array<double, kEawsPostureCount> shares{};
  const auto bent = static_cast<std::size_t>(EawsPosture::kStandBentForward);
  shares[bent] = 0.50;
  EXPECT_DOUBLE_EQ(eawsPosturePoints(shares), 23.0);
  shares[bent] = 0.585;
  EXPECT_NEAR(eawsPosturePoints(shares), 27.5, 1e-12);
  EXPECT_EQ(eawsLevel(eawsPosturePoints(shares)), 2);
  shares[bent] = 1.0;
  EXPECT_DOUBLE_EQ(eawsPosturePoints(shares), 40.0);
  shares[static_cast<std::size_t>(EawsPosture::kStandHandsAboveHead)] = 0.2;
  EXPECT_DOUBLE_EQ(eawsPosturePoints(shares), 66.0);
  EXPECT_EQ(eawsLevel(66.0), 3);
}

}  // namespace
}  // namespace hapticell::ergonomics
