// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/rula.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

constexpr std::array<SubScore, Rula::kCount> kRulaSubScores{{{"upper_arm", 1, 6},
                                                             {"lower_arm", 1, 3},
                                                             {"wrist", 1, 4},
                                                             {"wrist_twist", 1, 2},
                                                             {"neck", 1, 6},
                                                             {"trunk", 1, 6},
                                                             {"legs", 1, 2},
                                                             {"muscle_use_arm", 0, 1, false},
                                                             {"force_arm", 0, 3, false},
                                                             {"muscle_use_body", 0, 1, false},
                                                             {"force_body", 0, 3, false}}};

// Rows: upper arm 1 to 6, each with lower arm 1 to 3; columns: wrist 1 to 4, each with twist 1 and 2.
constexpr int kRulaTableA[18][8] = {
    {1, 2, 2, 2, 2, 3, 3, 3}, {2, 2, 2, 2, 3, 3, 3, 3}, {2, 3, 3, 3, 3, 3, 4, 4},  // upper arm 1
    {2, 3, 3, 3, 3, 4, 4, 4}, {3, 3, 3, 3, 3, 4, 4, 4}, {3, 4, 4, 4, 4, 4, 5, 5},  // 2
    {3, 3, 4, 4, 4, 4, 5, 5}, {3, 4, 4, 4, 4, 4, 5, 5}, {4, 4, 4, 4, 4, 5, 5, 5},  // 3
    {4, 4, 4, 4, 4, 5, 5, 5}, {4, 4, 4, 4, 4, 5, 5, 5}, {4, 4, 4, 5, 5, 5, 6, 6},  // 4
    {5, 5, 5, 5, 5, 6, 6, 7}, {5, 6, 6, 6, 6, 7, 7, 7}, {6, 6, 6, 7, 7, 7, 7, 8},  // 5
    {7, 7, 7, 7, 7, 8, 8, 9}, {8, 8, 8, 8, 8, 9, 9, 9}, {9, 9, 9, 9, 9, 9, 9, 9},  // 6
};

// Rows: neck 1 to 6; columns: trunk 1 to 6, each with legs 1 and 2.
constexpr int kRulaTableB[6][12] = {
    {1, 3, 2, 3, 3, 4, 5, 5, 6, 6, 7, 7}, {2, 3, 2, 3, 4, 5, 5, 5, 6, 7, 7, 7}, {3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 7},
    {5, 5, 5, 6, 6, 7, 7, 7, 7, 7, 8, 8}, {7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8}, {8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9},
};

// Rows: score C 1 to 8 and more; columns: score D 1 to 7 and more.
constexpr int kRulaTableC[8][7] = {
    {1, 2, 3, 3, 4, 5, 5}, {2, 2, 3, 4, 4, 5, 5}, {3, 3, 3, 4, 4, 5, 6}, {3, 3, 3, 4, 5, 6, 6},
    {4, 4, 4, 5, 6, 7, 7}, {4, 4, 5, 6, 6, 7, 7}, {5, 5, 6, 6, 7, 7, 7}, {5, 5, 6, 7, 7, 7, 7},
};

struct RulaSteps {
  int table_a, score_c, table_b, score_d, final;
};

RulaSteps rulaSteps(std::span<const int> v) {
  const auto at = [&](Rula::Index index) { return v[index]; };
  RulaSteps steps{};
  steps.table_a = kRulaTableA[3 * (at(Rula::kUpperArm) - 1) + at(Rula::kLowerArm) - 1]
                             [2 * (at(Rula::kWrist) - 1) + at(Rula::kWristTwist) - 1];
  steps.score_c = steps.table_a + at(Rula::kMuscleUseArm) + at(Rula::kForceArm);
  steps.table_b = kRulaTableB[at(Rula::kNeck) - 1][2 * (at(Rula::kTrunk) - 1) + at(Rula::kLegs) - 1];
  steps.score_d = steps.table_b + at(Rula::kMuscleUseBody) + at(Rula::kForceBody);
  steps.final = kRulaTableC[std::min(steps.score_c, 8) - 1][std::min(steps.score_d, 7) - 1];
  return steps;
}

int rulaUpperArm(double flexion) {
  if (flexion >= 90.0) return 4;
  if (flexion > 45.0) return 3;
  return flexion > 20.0 || flexion < -20.0 ? 2 : 1;
}

/// Extension is 4 however little; where it is measured, what is just behind the neutral band leads up to it.
int neck(double flexion, bool is_measured) {
  if (is_measured && flexion < 0.0 && flexion >= -kNeckThird) return flexion >= -kNeckSecond ? 2 : 3;
  if (flexion < 0.0) return 4;
  if (flexion >= 20.0) return 3;
  return flexion > 10.0 ? 2 : 1;
}

/// The text names forward angles only; a trunk leaning back counts by its size.
int rulaTrunk(double flexion) {
  const double size = std::abs(flexion);
  if (size >= 60.0) return 4;
  if (size > 20.0) return 3;
  return size > 0.0 ? 2 : 1;
}

}  // namespace

std::string_view Rula::source() const {
  return "McAtamney & Corlett, Applied Ergonomics 24(2), 1993, pp. 91-99";
}

std::span<const SubScore> Rula::subScores() const {
  return kRulaSubScores;
}

int Rula::score(std::span<const int> values) const {
  return rulaSteps(values).final;
}

Evaluation Rula::evaluate(std::span<const int> values) const {
  const RulaSteps steps = rulaSteps(values);
  Evaluation result;
  result.score = steps.final;
  result.level = levelOf(steps.final);
  result.entries = {
      {"A", values[kUpperArm], values[kLowerArm], values[kWrist], values[kWristTwist], steps.table_a},
      {"B", values[kNeck], 0, values[kTrunk], values[kLegs], steps.table_b},
      {"C", std::min(steps.score_c, 8), 0, std::min(steps.score_d, 7), 0, steps.final},
  };
  result.sums = {
      {"score_a", steps.table_a}, {"score_b", steps.table_b}, {"score_c", steps.score_c}, {"score_d", steps.score_d}};
  return result;
}

int Rula::levelOf(int score) const {
  constexpr std::array kHighest{2, 4, 6};  // Of the levels 1 to 3.
  return 1 + static_cast<int>(std::lower_bound(kHighest.begin(), kHighest.end(), score) - kHighest.begin());
}

std::string_view Rula::levelName(int level) const {
  constexpr std::array<std::string_view, 4> kNames{"acceptable", "investigate further", "investigate and change soon",
                                                   "investigate and change now"};
  return kNames[static_cast<std::size_t>(level - 1)];
}

Rula::Values rulaValues(const PostureAngles& angles, std::vector<std::string_view>& unknown) {
  const auto is = [&](const std::optional<bool>& flag, std::string_view name) {
    if (!flag) unknown.push_back(name);
    return flag.value_or(false) ? 1 : 0;
  };
  Rula::Values values;
  if (angles.upper_arm_flexion) {
    values[Rula::kUpperArm] =
        std::clamp(rulaUpperArm(*angles.upper_arm_flexion) + is(angles.upper_arm_abducted, "upper_arm_abducted") +
                       is(angles.shoulder_raised, "shoulder_raised") - is(angles.arm_supported, "arm_supported"),
                   1, 6);
  }
  if (angles.lower_arm_flexion) {
    const bool is_middle = *angles.lower_arm_flexion >= 60.0 && *angles.lower_arm_flexion <= 100.0;
    values[Rula::kLowerArm] = (is_middle ? 1 : 2) + is(angles.lower_arm_across_midline, "lower_arm_across_midline");
  }
  if (angles.wrist_flexion) {
    const double size = std::abs(neutralSettled(angles, *angles.wrist_flexion));
    values[Rula::kWrist] =
        1 + (size > 0.0 ? 1 : 0) + (size >= 15.0 ? 1 : 0) + is(angles.wrist_deviated, "wrist_deviated");
  }
  if (angles.wrist_twist_at_end) values[Rula::kWristTwist] = *angles.wrist_twist_at_end ? 2 : 1;
  if (angles.neck_flexion) {
    const double flexion = neutralSettled(angles, *angles.neck_flexion);
    values[Rula::kNeck] = neck(flexion, angles.measured.value_or(false)) + is(angles.neck_twisted, "neck_twisted") +
                          is(angles.neck_side_bent, "neck_side_bent");
  }
  if (angles.trunk_flexion) {
    const int base =
        angles.trunk_supported.value_or(false) ? 1 : rulaTrunk(neutralSettled(angles, *angles.trunk_flexion));
    values[Rula::kTrunk] =
        base + is(angles.trunk_twisted, "trunk_twisted") + is(angles.trunk_side_bent, "trunk_side_bent");
  }
  if (angles.legs_supported) values[Rula::kLegs] = *angles.legs_supported ? 1 : 2;
  return values;
}

}  // namespace hapticell::ergonomics
