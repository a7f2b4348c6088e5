// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/driving_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mannequin/ergonomics/advice/advice_words.h"
#include "mannequin/ergonomics/advice/posture_advice.h"
#include "tests/mannequin/body/median_man.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Figure;
using mannequin::Posture;
using mannequin::Side;

constexpr double kDegrees = 57.295779513082323;

double drawn(const JointAngle& joint) {
  return kDegrees * std::acos(std::clamp(glm::dot(joint.from_W, joint.to_W), -1.0, 1.0));
}

TEST(DrivingParts, TheOneThatLowersTheScoreMostComesFirst) {
  const Figure figure = mannequin::medianMan();
  const Posture posture = *mannequin::libraryPosture(figure, "overhead");
  const PostureScores scores = scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), WorkTask{});
  for (const PostureMethod method : kPostureMethods) {
    const auto parts = drivingParts(scores, method);
    ASSERT_FALSE(parts.empty()) << nameOf(method);
    EXPECT_LE(parts.size(), 2u);
    const bool has_arm = std::any_of(parts.begin(), parts.end(),
                                     [](const DrivingPart& part) { return part.part == BodyPart::kUpperArm; });
    EXPECT_TRUE(has_arm) << nameOf(method);
    EXPECT_GE(parts[0].band, 1) << nameOf(method);
  }
  const auto rula = drivingParts(scores, PostureMethod::kRula);
  EXPECT_EQ(rula[0].part, BodyPart::kUpperArm);
  EXPECT_TRUE(rula[0].lowers);
  EXPECT_EQ(rula[0].angle, scores.worse().measured.upper_arm_flexion);
  const Posture standing;
  EXPECT_TRUE(drivingParts(scorePosture(figure, standing, mannequin::forwardKinematics(figure, standing), WorkTask{}),
                           PostureMethod::kOwas)
                  .empty());
}

// Of one joint moved alone the drawn angle is the measured one.
TEST(DrivingParts, TheAngleThatIsDrawnIsTheOneThatIsTold) {
  const Figure figure = mannequin::medianMan();
  struct Case {
    Dof dof;
    double radians;
    BodyPart part;
    double MeasuredPosture::*angle;
    double slack;
  };
  for (const Case& one :
       {Case{Dof::kRightShoulderFlexion, 1.2, BodyPart::kUpperArm, &MeasuredPosture::upper_arm_flexion, 3.0},
        Case{Dof::kRightElbowFlexion, 1.1, BodyPart::kLowerArm, &MeasuredPosture::lower_arm_flexion, 1e-6},
        Case{Dof::kRightKneeFlexion, 0.9, BodyPart::kLegs, &MeasuredPosture::knee_flexion, 3.0}}) {
    Posture posture;
    posture[one.dof] = one.radians;
    const auto pose = mannequin::forwardKinematics(figure, posture);
    const MeasuredPosture measured = scorePosture(figure, posture, pose, WorkTask{}).sides[1].measured;
    EXPECT_NEAR(drawn(jointAngle(pose, {one.part, Side::kRight})), std::abs(measured.*one.angle), one.slack);
  }
  Posture bent = *mannequin::libraryPosture(figure, "stooping");
  const auto pose = mannequin::forwardKinematics(figure, bent);
  const MeasuredPosture measured = scorePosture(figure, bent, pose, WorkTask{}).sides[1].measured;
  EXPECT_NEAR(drawn(jointAngle(pose, {BodyPart::kTrunk, Side::kRight})), std::abs(measured.trunk_flexion), 1e-6);
}

TEST(AdviceWords, EveryFieldHasWordsInBothLanguages) {
  std::vector<std::string_view> fields{
      "trunk_twist",      "trunk_side_bend",     "upper_arm_abduction",       "gaze_below_horizontal",
      "head_inclination", "shoulder_raised_deg", "arms_at_or_above_shoulder", "on_one_leg",
      "kneeling",         "hands_above_head",    "elbow_at_shoulder"};
  for (const PostureField& field : postureFields()) fields.push_back(field.name);
  for (const std::string_view field : fields) {
    for (const bool is_flag : {false, true}) {
      const FieldChange change{field, is_flag, 1.0, 0.0};
      const std::string english = changeWords(change, Language::kEnglish),
                        french = changeWords(change, Language::kFrench);
      EXPECT_EQ(english.find('_'), std::string::npos) << english;
      EXPECT_NE(english, french) << field;
    }
  }
}

TEST(AdviceWords, SayWhatDrivesAndWhatBringsItDown) {
  MethodAdvice advice{PostureMethod::kEn1005, {3.0, 3}};
  advice.drivers.push_back({"trunk forward", {{"trunk_flexion", false, 65.0, 20.0}}, 1.0, 3});
  advice.next = MethodAdvice::Goal{{{"trunk_flexion", false, 65.0, 60.0}, {"arm_supported", true, 0.0, 1.0}}, {2.0, 2}};
  EXPECT_EQ(driverWords(advice, Language::kEnglish), "trunk forward 65° to 20° (acceptable)");
  EXPECT_EQ(nextLevelWords(advice, Language::kEnglish),
            "trunk forward 65° to 60°, arm supported: yes gives EN 1005-4: conditionally acceptable");
  EXPECT_EQ(nextLevelWords(advice, Language::kFrench),
            "tronc en avant 65° à 60°, bras soutenu : oui donne EN 1005-4 : acceptable sous condition");
  advice.next.reset();
  EXPECT_NE(nextLevelWords(advice, Language::kEnglish).find("No change"), std::string::npos);
  advice.now = {1.0, 1};
  EXPECT_TRUE(nextLevelWords(advice, Language::kEnglish).empty());
}

TEST(AdviceWords, OfALiftNameItsMultipliersAndChanges) {
  const LiftingTask task{10, 40, 30, 70, 30, 2, 2, Coupling::kPoor};
  const LiftingAdvice advice = adviseLift(task, *lift(task));
  EXPECT_EQ(liftingDriverWords(advice).substr(0, 7), "HM 0.62");
  const std::string next = liftingNextWords(advice, Language::kEnglish);
  EXPECT_EQ(next.substr(0, next.find(" or ")), "hands in front of the ankles 40 cm to 30 cm");
  EXPECT_NE(next.find("load 10 kg to 7.5 kg"), std::string::npos) << next;
  EXPECT_NE(liftingNextWords(advice, Language::kFrench).find("indice de levage d'au plus 1"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::ergonomics
