// SPDX-License-Identifier: Apache-2.0
// Published examples, and postures worked by hand on the methods' worksheets.
#include <gtest/gtest.h>

#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"

namespace hapticell::ergonomics {
namespace {

/// A posture without any modifier, standing on both feet.
PostureAngles plain(double upper_arm, double lower_arm, double wrist, double neck, double trunk, double knee = 0.0) {
  PostureAngles angles;
  angles.upper_arm_flexion = upper_arm;
  angles.lower_arm_flexion = lower_arm;
  angles.wrist_flexion = wrist;
  angles.neck_flexion = neck;
  angles.trunk_flexion = trunk;
  angles.knee_flexion = knee;
  using Flag = std::optional<bool> PostureAngles::*;
  for (const Flag flag : std::initializer_list<Flag>{
           &PostureAngles::upper_arm_abducted, &PostureAngles::upper_arm_rotated, &PostureAngles::shoulder_raised,
           &PostureAngles::arm_supported, &PostureAngles::lower_arm_across_midline, &PostureAngles::wrist_deviated,
           &PostureAngles::wrist_twist_at_end, &PostureAngles::neck_twisted, &PostureAngles::neck_side_bent,
           &PostureAngles::trunk_twisted, &PostureAngles::trunk_side_bent, &PostureAngles::seated}) {
    angles.*flag = false;
  }
  angles.legs_supported = true;
  angles.legs_bilateral = true;
  return angles;
}

struct RulaExample {
  const char* name;
  PostureAngles angles;
  int muscle_use;
  int force;
  int a, b, c, d, final;
};

TEST(WorkedExamples, Rula) {
  auto shelf = plain(95, 30, 10, -10, 10);
  shelf.shoulder_raised = true;
  auto inspection = plain(30, 95, 0, 22, 8);
  inspection.arm_supported = true;
  inspection.wrist_deviated = true;
  auto one_leg = plain(90, 100.1, 0, 20, 60);
  one_leg.legs_supported = false;
  const RulaExample examples[] = {
      {"typing", plain(0, 90, 0, 5, 0), 0, 0, 1, 1, 1, 1, 1},
      {"bench", plain(40, 80, 12, 18, 15), 1, 0, 3, 2, 4, 3, 3},
      {"shelf", shelf, 0, 1, 6, 5, 7, 6, 7},
      {"bin", plain(60, 25, 16, 25, 65), 0, 1, 4, 5, 5, 6, 7},
      {"inspection", inspection, 1, 0, 2, 3, 3, 4, 4},
      {"boundary", plain(20, 60, 15, 10, 20), 0, 0, 2, 2, 2, 2, 2},
      {"ninety", one_leg, 0, 0, 4, 6, 4, 6, 6},
      {"carry", plain(10, 95, 10, 0, 0), 0, 2, 2, 1, 4, 3, 3},
  };
  const Rula rula;
  for (const RulaExample& example : examples) {
    std::vector<std::string_view> unknown;
    auto values = rulaValues(example.angles, unknown);
    EXPECT_TRUE(unknown.empty()) << example.name;
    values[Rula::kMuscleUseArm] = values[Rula::kMuscleUseBody] = example.muscle_use;
    values[Rula::kForceArm] = values[Rula::kForceBody] = example.force;
    const Assessment assessment = assess(rula, values);
    ASSERT_TRUE(assessment.evaluation.has_value()) << example.name;
    std::vector<int> sums;
    for (const auto& sum : assessment.evaluation->sums) sums.push_back(sum.value);
    EXPECT_EQ(sums, (std::vector<int>{example.a, example.b, example.c, example.d})) << example.name;
    EXPECT_EQ(assessment.score, example.final) << example.name;
  }
}

// Cardboard factory: A 3, B 1, six times a minute, 250 g: final 3, action level 2.
TEST(WorkedExamples, RulaCardboardFactory) {
  const std::vector<std::optional<int>> values{2, 2, 1, 1, 1, 1, 1, 1, 0, 1, 0};
  const Assessment assessment = assess(Rula(), values);
  EXPECT_EQ(assessment.score, 3);
  EXPECT_EQ(assessment.level, 2);
}

struct RebaExample {
  const char* name;
  PostureAngles angles;
  int load, coupling, activity;
  int table_a, table_b, a, b, c, final;
};

TEST(WorkedExamples, Reba) {
  auto one_leg = plain(95, 15, 18, 22, 45, 35);
  one_leg.trunk_twisted = one_leg.neck_twisted = one_leg.shoulder_raised = one_leg.wrist_deviated = true;
  one_leg.legs_bilateral = false;
  auto overhead = plain(140, 60, 0, -15, -10);
  overhead.shoulder_raised = overhead.upper_arm_abducted = true;
  auto side_lean = plain(30, 90, 0, 5, 8);
  side_lean.trunk_side_bent = side_lean.neck_side_bent = side_lean.upper_arm_abducted = true;
  const RebaExample examples[] = {
      {"upright", plain(0, 20, 0, 0, 0), 0, 0, 0, 1, 1, 1, 1, 1, 1},
      {"stoop", plain(60, 30, 20, 25, 70, 20), 2, 2, 0, 5, 5, 7, 7, 9, 9},
      {"one leg", one_leg, 0, 0, 1, 8, 8, 8, 8, 10, 11},
      {"overhead", overhead, 1, 0, 1, 3, 7, 4, 7, 7, 8},
      {"boundary", plain(20, 60, 15, 20, 20, 30), 1, 0, 0, 3, 1, 4, 1, 3, 3},
      {"side lean", side_lean, 0, 0, 2, 4, 3, 4, 3, 4, 6},
      {"low bin", plain(80, 20, 0, 30, 55, 95), 0, 1, 1, 6, 4, 6, 5, 8, 9},
  };
  const Reba reba;
  for (const RebaExample& example : examples) {
    std::vector<std::string_view> unknown;
    auto values = rebaValues(example.angles, unknown);
    EXPECT_TRUE(unknown.empty()) << example.name;
    values[Reba::kLoad] = example.load;
    values[Reba::kCoupling] = example.coupling;
    values[Reba::kActivity] = example.activity;
    const Assessment assessment = assess(reba, values);
    ASSERT_TRUE(assessment.evaluation.has_value()) << example.name;
    std::vector<int> sums;
    for (const auto& sum : assessment.evaluation->sums) sums.push_back(sum.value);
    EXPECT_EQ(sums, (std::vector<int>{example.table_a, example.a, example.table_b, example.b, example.c}))
        << example.name;
    EXPECT_EQ(assessment.score, example.final) << example.name;
  }
}

// Neck, trunk, legs, upper arm, lower arm, wrist, load, coupling, activity.
TEST(WorkedExamples, RebaPublished) {
  const auto score = [](std::vector<std::optional<int>> values) { return assess(Reba(), values).score; };
  EXPECT_EQ(score({1, 2, 2, 2, 1, 1, 2, 0, 0}), 4);  // load handling: A 3 + 2, B 1
  EXPECT_EQ(score({2, 2, 2, 1, 2, 3, 0, 0, 0}), 4);  // A 4, B 3, C 4
  std::vector<std::string_view> unknown;
  const auto doctest = rebaValues(
      [] {
        auto angles = plain(45, 70, 0, 10, 20, 50);
        angles.wrist_twist_at_end = true;
        angles.legs_bilateral = false;
        return angles;
      }(),
      unknown);
  EXPECT_EQ(doctest[Reba::kNeck], 1);
  EXPECT_EQ(doctest[Reba::kTrunk], 2);
  EXPECT_EQ(doctest[Reba::kLegs], 3);
  EXPECT_EQ(doctest[Reba::kUpperArm], 2);
  EXPECT_EQ(doctest[Reba::kLowerArm], 1);
  EXPECT_EQ(doctest[Reba::kWrist], 2);
  const auto sums = assess(Reba(), doctest).evaluation->sums;
  EXPECT_EQ(sums[0].value, 4) << "table A";
  EXPECT_EQ(sums[2].value, 2) << "table B";
}

// Trunk 64, neck 30, arm 95, elbow 90, knees 40, load 2, coupling 1, wrist 2: A 6 + 2, B 5 + 1, C 10.
TEST(WorkedExamples, RebaWithEverythingInIt) {
  std::vector<std::string_view> unknown;
  auto values = rebaValues(plain(95, 90, 20, 30, 64, 40), unknown);
  values[Reba::kLoad] = 2;
  values[Reba::kCoupling] = 1;
  values[Reba::kActivity] = 0;
  const Assessment assessment = assess(Reba(), values);
  std::vector<int> sums;
  for (const auto& sum : assessment.evaluation->sums) sums.push_back(sum.value);
  EXPECT_EQ(sums, (std::vector<int>{6, 8, 5, 6, 10}));
  EXPECT_EQ(assessment.score, 10);
  values[Reba::kActivity] = 3;
  EXPECT_EQ(assess(Reba(), values).score, 13);
}

TEST(WorkedExamples, Owas) {
  const auto category = [](int code) {
    const std::vector<int> digits{code / 1000, code / 100 % 10, code / 10 % 10, code % 10};
    return Owas().score(digits);
  };
  EXPECT_EQ(category(1111), 1);
  EXPECT_EQ(category(2121), 2);
  EXPECT_EQ(category(2151), 3);
  EXPECT_EQ(category(3131), 1);
  EXPECT_EQ(category(4141), 4);
  EXPECT_EQ(category(1353), 3);
}

TEST(WorkedExamples, OwasDigitsOfAPosture) {
  OwasPosture posture;
  EXPECT_EQ(owasValues(posture), (Owas::Values{1, 1, 2, 1}));
  posture.trunk_flexion = 35;
  posture.trunk_twist = -25;
  posture.arms_at_or_above_shoulder = 1;
  posture.left_knee_flexion = 60;
  posture.load_kg = 12;
  EXPECT_EQ(owasValues(posture), (Owas::Values{4, 2, 5, 2}));
  posture.right_knee_flexion = 50;
  EXPECT_EQ(owasValues(posture)[Owas::kLegs], 4);
  posture.seated = true;
  EXPECT_EQ(owasValues(posture)[Owas::kLegs], 1);
}

}  // namespace
}  // namespace hapticell::ergonomics
