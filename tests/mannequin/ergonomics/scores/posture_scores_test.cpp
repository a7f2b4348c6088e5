// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/posture_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/scores/figure_measurement.h"
#include "mannequin/ergonomics/scores/score_words.h"
#include "tests/mannequin/body/median_man.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Figure;
using mannequin::Posture;
using mannequin::Side;

WorkTask known() {
  WorkTask task;
  task.load_kg = {0.0, 1.0};
  task.repetitions_per_min = 1.0;
  task.is_static = false;
  task.grip = Grip::kGood;
  task.duration_h = 1.0;
  task.has_shock = false;
  task.has_rapid_changes = false;
  return task;
}

PostureScores scoresOf(const Figure& figure, const char* name, const WorkTask& task) {
  const Posture posture = *mannequin::libraryPosture(figure, name);
  return scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), task);
}

TEST(PostureScores, AgreeWithEachMethodAskedByItself) {
  const Figure figure = mannequin::medianMan();
  for (const auto& library : mannequin::postureLibrary()) {
    const Posture posture = *mannequin::libraryPosture(figure, library.name);
    const auto pose = mannequin::forwardKinematics(figure, posture);
    const PostureScores scores = scorePosture(figure, posture, pose, known());
    for (const Side side : {Side::kLeft, Side::kRight}) {
      MeasuredPosture measured = measure(figure, posture, pose, side);
      measured.seated = scores.is_seated;
      PostureAngles angles = postureAngles(measured);
      angles.arm_supported = angles.trunk_supported = false;
      std::vector<std::string_view> unknown;
      Rula::Values rula = rulaValues(angles, unknown);
      rula[Rula::kMuscleUseArm] = rula[Rula::kMuscleUseBody] = rula[Rula::kForceArm] = rula[Rula::kForceBody] = 0;
      const auto assessed = assess(Rula(), rula);
      EXPECT_EQ(scores.sides[static_cast<std::size_t>(side)].rula_score, *assessed.score) << library.name;
    }
    EXPECT_TRUE(scores.missing.empty());
  }
}

TEST(PostureScores, SeatsAreSeenAndSquatsAreNot) {
  const Figure figure = mannequin::medianMan();
  EXPECT_TRUE(scoresOf(figure, "seated", known()).is_seated);
  EXPECT_EQ(scoresOf(figure, "seated", known()).owas[Owas::kLegs], 1);
  for (const char* name : {"standing", "squatting", "kneeling", "stooping", "overhead"})
    EXPECT_FALSE(scoresOf(figure, name, known()).is_seated) << name;
}

TEST(PostureScores, WorsePosturesScoreHigher) {
  const Figure figure = mannequin::medianMan();
  const int standing = scoresOf(figure, "standing", known()).rula();
  EXPECT_GT(scoresOf(figure, "overhead", known()).rula(), standing);
  EXPECT_GT(scoresOf(figure, "stooping", known()).rula(), standing);
  EXPECT_GT(scoresOf(figure, "stooping", known()).reba(), scoresOf(figure, "standing", known()).reba());
  EXPECT_EQ(scoresOf(figure, "overhead", known()).eaws, EawsPosture::kStandHandsAboveHead);
}

TEST(PostureScores, WhatNobodyEnteredIsNamedAndNotScoredAsZero) {
  const Figure figure = mannequin::medianMan();
  const PostureScores scores = scoresOf(figure, "standing", WorkTask{});
  EXPECT_EQ(scores.missing.size(), 4u);
  EXPECT_FALSE(scores.sides[1].rula[Rula::kForceArm].has_value());
  EXPECT_FALSE(scores.sides[1].reba[Reba::kCoupling].has_value());
  const auto lines = assumptionsOf(scores, WorkTask{}, Language::kEnglish);
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const auto& l) { return l.find("partial") != l.npos; }));
  EXPECT_EQ(assumptionsOf(scores, WorkTask{}, Language::kFrench).size(), lines.size());
}

TEST(WorkTask, LoadsAndPaceBecomeTheMethodsOwnScores) {
  WorkTask task = known();
  EXPECT_EQ(rulaForce(task, 1.9), 0);
  EXPECT_EQ(rulaForce(task, 2.0), 1);
  EXPECT_EQ(rulaForce(task, 10.5), 2);
  EXPECT_EQ(rulaMuscleUse(task), 0);
  task.repetitions_per_min = 4.0;
  EXPECT_EQ(rulaForce(task, 5.0), 2);
  EXPECT_EQ(rulaForce(task, 11.0), 3);
  EXPECT_EQ(rulaMuscleUse(task), 1);
  task.has_shock = true;
  EXPECT_EQ(rulaForce(task, 0.0), 3);
  task.load_kg = {3.0, 3.0};
  EXPECT_EQ(rebaLoad(task), 2) << "5 to 10 kg and a shock";
  task.repetitions_per_min.reset();
  EXPECT_FALSE(rebaActivity(task));
  task.load_kg[1] = 300.0;
  EXPECT_FALSE(checkWorkTask(task));
  for (const WorkTask& preset : workTaskPresets()) EXPECT_TRUE(checkWorkTask(preset)) << preset.name;
}

TEST(PostureScores, LiftsAreRefusedOutsideTheirValidity) {
  const Figure figure = mannequin::medianMan();
  WorkTask task = workTaskPresets()[5];
  const Posture posture = *mannequin::libraryPosture(figure, "both_hands_forward");
  const auto pose = mannequin::forwardKinematics(figure, posture);
  const PostureScores scores = scorePosture(figure, posture, pose, task);
  const auto lift = scoreLift(figure, pose, scores, task);
  ASSERT_TRUE(lift) << lift.error().message();
  EXPECT_GT(*lift->lifting_index, 0.5);
  EXPECT_LT(*lift->lifting_index, 5.0);
  task.load_kg[0].reset();
  EXPECT_FALSE(scoreLift(figure, pose, scores, task)) << "one hand";
  task = workTaskPresets()[5];
  task.grip.reset();
  const auto refused = scoreLift(figure, pose, scores, task);
  ASSERT_FALSE(refused);
  EXPECT_EQ(english(refused.error().place), "grip");
}

TEST(SegmentBands, FollowTheSubScoresOfTheirPart) {
  const Figure figure = mannequin::medianMan();
  const auto scores = scoresOf(figure, "overhead", known());
  const auto bands = segmentBands(scores, ColourMethod::kRula);
  EXPECT_GE(bands[mannequin::indexOf(mannequin::Segment::kRightUpperArm)], 2);
  EXPECT_EQ(bands[mannequin::indexOf(mannequin::Segment::kLeftThigh)], 0);
  for (const auto method : {ColourMethod::kReba, ColourMethod::kOwas, ColourMethod::kEn1005}) {
    for (const int band : segmentBands(scores, method)) {
      EXPECT_GE(band, 0);
      EXPECT_LE(band, 3);
    }
  }
}

TEST(BodySizes, AllFourDoTheSameTask) {
  const Figure figure = mannequin::medianMan();
  Posture posture = *mannequin::libraryPosture(figure, "both_hands_forward");
  const auto pose = mannequin::forwardKinematics(figure, posture);
  const auto active = activeHands(pose, posture);
  EXPECT_TRUE(active[0] && active[1]);
  const auto bodies = atSameTask(mannequin::boundaryFigures(), figure, posture, known());
  ASSERT_EQ(bodies.size(), 4u);
  for (const BodyAtTask& body : bodies) {
    if (!body.is_reached) continue;
    const auto there = mannequin::forwardKinematics(body.figure, body.posture);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      const dvec3 wanted = mannequin::handPose(pose, side) * figure.p_HandGrip[i];
      const dvec3 grip = mannequin::handPose(there, side) * body.figure.p_HandGrip[i];
      EXPECT_LT(glm::length(wanted - grip), 2e-3) << body.name;
    }
  }
  EXPECT_TRUE(bodies[2].is_reached) << "its own size";
}

TEST(BodySizes, TheFiguresOwnSizeIsAsItStandsAndTheHeightOfNowIsThatOfTheColumns) {
  const Figure figure = mannequin::boundaryFigures()[1].figure;
  for (const char* name : {"reaching", "both_hands_forward", "stooping"}) {
    const Posture posture = *mannequin::libraryPosture(figure, name);
    const auto bodies = atSameTask(mannequin::boundaryFigures(), figure, posture, known());
    const auto own = scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), known());
    EXPECT_EQ(bodies[1].scores.rula(), own.rula()) << name;
    EXPECT_EQ(bodies[1].scores.reba(), own.reba()) << name;
    const auto heights =
        scoresByHeight(mannequin::boundaryFigures(), figure, posture, known(), {-0.06, -0.03, -3e-17, 0.03});
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      EXPECT_EQ(heights[i][2], bodies[i].is_reached ? bodies[i].scores.rula() : 0) << name << ", " << bodies[i].name;
    }
  }
}

TEST(ScoreWords, NameTheDriverInBothLanguages) {
  const Figure figure = mannequin::medianMan();
  const auto scores = scoresOf(figure, "overhead", known());
  const MainDriver driver = mainDriver(scores, Language::kEnglish);
  EXPECT_EQ(driver.index, Rula::kUpperArm);
  EXPECT_LT(driver.score, scores.rula());
  EXPECT_NE(driver.part.find("upper arm"), std::string::npos);
  EXPECT_NE(whySentence(scores, Language::kFrench).find("bras"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::ergonomics
