// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/figure_measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mannequin/ergonomics/advice/motion_scores.h"
#include "tests/support/test_data.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Posture;
using mannequin::Side;

constexpr double kRadians = std::numbers::pi / 180.0;

MeasuredPosture measured(const Posture& posture, Side side = Side::kRight) {
  const auto figure = mannequin::makeFigure({});
  return measure(*figure, posture, mannequin::forwardKinematics(*figure, posture), side);
}

TEST(FigureMeasurement, StandingStraightIsNothing) {
  const MeasuredPosture m = measured(Posture{});
  EXPECT_EQ(m.trunk_flexion, 0.0);
  EXPECT_EQ(m.trunk_side_bend, 0.0);
  EXPECT_NEAR(m.trunk_twist, 0.0, 1e-9);
  EXPECT_NEAR(m.neck_flexion, 0.0, 1e-9);
  EXPECT_NEAR(m.lower_arm_flexion, 0.0, 6.0);
  EXPECT_NEAR(m.share_on_heavier_foot, 0.5, 0.02);
  EXPECT_FALSE(m.wrist_past_midline);
}

TEST(FigureMeasurement, AStraightNeckIsNotInExtensionHoweverTheBodyIsTurned) {
  Posture posture;
  for (int i = 0; i < 200; ++i) {
    const double turn = 0.37 * i;
    posture.X_WR.q = glm::angleAxis(turn, glm::normalize(dvec3(0.2 * std::sin(turn), 0.3 * std::cos(turn), 1.0)));
    posture[Dof::kVl1LeftTurn] = 0.1 * std::sin(turn);
    posture[Dof::kVl5Flexion] = 0.2 * std::cos(turn);
    EXPECT_EQ(measured(posture).neck_flexion, 0.0) << i;
  }
}

TEST(FigureMeasurement, EachJointMovesItsOwnMeasure) {
  Posture posture;
  posture[Dof::kRightShoulderFlexion] = 70.0 * kRadians;
  posture[Dof::kRightElbowFlexion] = 50.0 * kRadians;
  posture[Dof::kVc7Flexion] = 20.0 * kRadians;
  posture[Dof::kVl1LeftTurn] = 15.0 * kRadians;
  posture[Dof::kLeftKneeFlexion] = 40.0 * kRadians;
  posture[Dof::kRightClavicleElevation] = 12.0 * kRadians;
  const MeasuredPosture still = measured(Posture{});
  const MeasuredPosture m = measured(posture);
  EXPECT_NEAR(m.upper_arm_flexion - still.upper_arm_flexion, 70.0, 6.0);
  EXPECT_NEAR(m.lower_arm_flexion, 50.0, 6.0);
  EXPECT_NEAR(m.neck_flexion, 20.0, 1.0);
  EXPECT_NEAR(m.trunk_twist, 15.0, 0.5);
  EXPECT_NEAR(m.knee_flexion, 40.0, 1e-9);
  EXPECT_NEAR(m.girdle_elevation, 12.0, 1e-9);
  EXPECT_NEAR(measured(posture, Side::kLeft).upper_arm_flexion, still.upper_arm_flexion, 8.0);
}

TEST(FigureMeasurement, AbductionIsNoFlexionAndBackwardsIsExtension) {
  Posture out;
  out[Dof::kLeftShoulderAbduction] = 80.0 * kRadians;
  const MeasuredPosture m = measured(out, Side::kLeft);
  EXPECT_NEAR(m.upper_arm_abduction, 80.0, 8.0);
  EXPECT_LT(std::abs(m.upper_arm_flexion), 45.0);
  Posture back;
  back[Dof::kRightShoulderFlexion] = -40.0 * kRadians;
  EXPECT_NEAR(measured(back).upper_arm_flexion, -40.0, 8.0);
}

TEST(FigureMeasurement, TheWorldsHeadingDoesNotMatter) {
  Posture posture;
  posture[Dof::kVl5Flexion] = 20.0 * kRadians;
  posture[Dof::kVl1RightBend] = 15.0 * kRadians;
  posture[Dof::kRightShoulderFlexion] = 60.0 * kRadians;
  const MeasuredPosture a = measured(posture);
  posture.X_WR.q = quaternionFromRotationVector({0.0, 0.0, 2.1});
  const MeasuredPosture b = measured(posture);
  EXPECT_NEAR(a.trunk_flexion, b.trunk_flexion, 1e-9);
  EXPECT_NEAR(a.trunk_side_bend, b.trunk_side_bend, 1e-9);
  EXPECT_NEAR(a.upper_arm_flexion, b.upper_arm_flexion, 1e-9);
}

// What the data's own page states of this clip (positions of the recorded joints).
TEST(MotionScores, SharedClipsTrunkIsAsItsSourceStates) {
  HAPTICELL_SHARED_DATA_OR_SKIP(data, "mocap");
  const auto clip = mannequin::readMotionFile(data / "02_06.bvh");
  ASSERT_TRUE(clip.has_value()) << clip.error().message();
  const auto figure = mannequin::makeFigure({});
  const auto scores = scoreMotion(*clip, *figure, MotionMethod::kRula, {});
  ASSERT_TRUE(scores.has_value()) << scores.error().message();
  ASSERT_EQ(scores->frames.size(), 1118u);
  double most = 0.0;  // Of the whole lean: this is what the source states.
  int over20 = 0, over60 = 0;
  for (const FrameScore& frame : scores->frames) {
    most = std::max(most, frame.trunk_inclination);
    over20 += frame.trunk_inclination > 20.0 ? 1 : 0;
    over60 += frame.trunk_inclination > 60.0 ? 1 : 0;
    const double whole = std::cos(frame.trunk_flexion * kRadians) * std::cos(frame.trunk_side_bend * kRadians);
    EXPECT_NEAR(whole, std::cos(frame.trunk_inclination * kRadians), 1e-9);
    EXPECT_EQ(frame.score, std::max(frame.left, frame.right));
  }
  EXPECT_NEAR(most, 72.2, 0.05);
  EXPECT_EQ(over20, 492);
  EXPECT_EQ(over60, 175);
  EXPECT_NEAR(scores->frames[559].trunk_inclination, 65.7, 0.05);
  EXPECT_GT(scores->frames[559].trunk_flexion, 60.0) << "forwards";
  EXPECT_NEAR(scores->frames[559].upper_arm_elevation[1], 58.0, 0.05);
  EXPECT_NEAR(scores->frames[559].upper_arm_elevation[0], 5.6, 0.05);
  EXPECT_EQ(scores->frames[scores->worst].score, 7);
  EXPECT_EQ(scores->worst_values.size(), Rula().subScores().size());
  double whole = 0.0;
  for (const auto& [level, share] : scores->share_by_level) whole += share;
  EXPECT_NEAR(whole, 1.0, 1e-9);
}

TEST(MotionScores, TheSharedWalkIsAsItsSourceStatesAndMilderThanTheBend) {
  HAPTICELL_SHARED_DATA_OR_SKIP(data, "mocap");
  const auto figure = mannequin::makeFigure({});
  const auto walk = mannequin::readMotionFile(data / "02_01.bvh"), bend = mannequin::readMotionFile(data / "02_06.bvh");
  ASSERT_TRUE(walk && bend);
  for (const auto method : {MotionMethod::kRula, MotionMethod::kReba, MotionMethod::kOwas}) {
    const auto mild = scoreMotion(*walk, *figure, method, {}), bent = scoreMotion(*bend, *figure, method, {});
    ASSERT_TRUE(mild && bent);
    ASSERT_EQ(mild->frames.size(), 343u);
    EXPECT_LE(mild->frames[mild->worst].score, bent->frames[bent->worst].score);
    double least = 1e9, most = 0.0, sum = 0.0, arm = 0.0;
    for (const FrameScore& frame : mild->frames) {
      least = std::min(least, frame.trunk_inclination);
      most = std::max(most, frame.trunk_inclination);
      sum += frame.trunk_inclination;
      arm = std::max(arm, frame.upper_arm_elevation[1]);
    }
    EXPECT_NEAR(least, 2.3, 0.05);
    EXPECT_NEAR(most, 6.8, 0.05);
    EXPECT_NEAR(sum / 343.0, 4.7, 0.05);
    EXPECT_NEAR(arm, 26.5, 0.05);
    // What drives the worst frame, and what would bring it down, are of that frame.
    const auto& advice = bent->worst_advice;
    EXPECT_EQ(advice.now.score, bent->frames[bent->worst].score);
    EXPECT_FALSE(advice.drivers.empty());
    ASSERT_TRUE(advice.next);
    EXPECT_LT(advice.next->score.level, bent->frames[bent->worst].level);
  }
}

TEST(MotionScores, TheWorstPhaseIsTheLongestAtTheHighestScoreAndBridgesFlicker) {
  const std::vector<int> scores{3, 7, 3, 3, 7, 7, 6, 7, 3, 3, 3, 7, 7};
  const ScorePhase phase = worstPhase(scores, 0.1);
  EXPECT_EQ(phase.score, 7);
  EXPECT_EQ(phase.first, 1u) << "two frames of 0.1 s below it are bridged";
  EXPECT_EQ(phase.last, 7u);
  EXPECT_EQ(phase.shown, 4u);
  const ScorePhase slow = worstPhase(scores, 1.0);
  EXPECT_EQ(slow.first, 4u) << "of two equally long ones the first";
  EXPECT_EQ(slow.last, 5u);
  EXPECT_EQ(worstPhase(std::vector<int>{2, 2}, 0.1).last, 1u);
  EXPECT_EQ(worstPhase({}, 0.1).score, 0);
}

TEST(MotionScores, OwasSeesBentBackAndRaisedArms) {
  const auto figure = mannequin::makeFigure({});
  Posture posture;
  posture[Dof::kRightShoulderFlexion] = 120.0 * kRadians;
  const auto pose = mannequin::forwardKinematics(*figure, posture);
  const OwasPosture owas = owasPosture(*figure, posture, pose);
  EXPECT_EQ(owas.arms_at_or_above_shoulder, 1);
  EXPECT_FALSE(owas.kneeling);
  EXPECT_FALSE(owas.on_one_leg);
  const auto kneeling = mannequin::libraryPosture(*figure, "kneeling");
  ASSERT_TRUE(kneeling.has_value());
  EXPECT_TRUE(owasPosture(*figure, *kneeling, mannequin::forwardKinematics(*figure, *kneeling)).kneeling);
}

}  // namespace
}  // namespace hapticell::ergonomics
