// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/reba.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

constexpr std::array<SubScore, Reba::kCount> kRebaSubScores{{{"neck", 1, 3},
                                                             {"trunk", 1, 5},
                                                             {"legs", 1, 4},
                                                             {"upper_arm", 1, 6},
                                                             {"lower_arm", 1, 2},
                                                             {"wrist", 1, 3},
                                                             {"load", 0, 3, false},
                                                             {"coupling", 0, 3, false},
                                                             {"activity", 0, 3, false}}};

// Rows: trunk 1 to 5; columns: neck 1 to 3, each with legs 1 to 4.
constexpr int kRebaTableA[5][12] = {
    {1, 2, 3, 4, 1, 2, 3, 4, 3, 3, 5, 6}, {2, 3, 4, 5, 3, 4, 5, 6, 4, 5, 6, 7}, {2, 4, 5, 6, 4, 5, 6, 7, 5, 6, 7, 8},
    {3, 5, 6, 7, 5, 6, 7, 8, 6, 7, 8, 9}, {4, 6, 7, 8, 6, 7, 8, 9, 7, 8, 9, 9},
};

// Rows: upper arm 1 to 6; columns: lower arm 1 and 2, each with wrist 1 to 3.
constexpr int kRebaTableB[6][6] = {
    {1, 2, 2, 1, 2, 3}, {1, 2, 3, 2, 3, 4}, {3, 4, 5, 4, 5, 5},
    {4, 5, 5, 5, 6, 7}, {6, 7, 8, 7, 8, 8}, {7, 8, 8, 8, 9, 9},
};

// Rows: score A 1 to 12; columns: score B 1 to 12.
constexpr int kRebaTableC[12][12] = {
    {1, 1, 1, 2, 3, 3, 4, 5, 6, 7, 7, 7},
    {1, 2, 2, 3, 4, 4, 5, 6, 6, 7, 7, 8},
    {2, 3, 3, 3, 4, 5, 6, 7, 7, 8, 8, 8},
    {3, 4, 4, 4, 5, 6, 7, 8, 8, 9, 9, 9},
    {4, 4, 4, 5, 6, 7, 8, 8, 9, 9, 9, 9},
    {6, 6, 6, 7, 8, 8, 9, 9, 10, 10, 10, 10},
    {7, 7, 7, 8, 9, 9, 9, 10, 10, 11, 11, 11},
    {8, 8, 8, 9, 10, 10, 10, 10, 10, 11, 11, 11},
    {9, 9, 9, 10, 10, 10, 11, 11, 11, 12, 12, 12},
    {10, 10, 10, 11, 11, 11, 11, 12, 12, 12, 12, 12},
    {11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12},
    {12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12},
};

struct RebaSteps {
  int table_a, score_a, table_b, score_b, score_c, final;
};

RebaSteps rebaSteps(std::span<const int> v) {
  RebaSteps steps{};
  steps.table_a = kRebaTableA[v[Reba::kTrunk] - 1][4 * (v[Reba::kNeck] - 1) + v[Reba::kLegs] - 1];
  steps.score_a = steps.table_a + v[Reba::kLoad];
  steps.table_b = kRebaTableB[v[Reba::kUpperArm] - 1][3 * (v[Reba::kLowerArm] - 1) + v[Reba::kWrist] - 1];
  steps.score_b = steps.table_b + v[Reba::kCoupling];
  steps.score_c = kRebaTableC[std::min(steps.score_a, 12) - 1][std::min(steps.score_b, 12) - 1];
  steps.final = steps.score_c + v[Reba::kActivity];
  return steps;
}

int rebaTrunk(double flexion) {
  if (flexion > 60.0) return 4;
  if (flexion > 20.0 || flexion < -20.0) return 3;
  return flexion == 0.0 ? 1 : 2;
}

int rebaUpperArm(double flexion) {
  if (flexion > 90.0) return 4;
  if (flexion > 45.0) return 3;
  return flexion > 20.0 || flexion < -20.0 ? 2 : 1;
}

/// The most that legs count as which lack so many degrees to be seated, where they are 1.
int nearSeated(double off_seat) {
  return 1 + std::clamp(static_cast<int>(std::ceil(3.0 * off_seat / kOffSeat)), 1, 3);
}

int either(bool a, bool b) {
  return a || b ? 1 : 0;
}

}  // namespace

std::string_view Reba::source() const {
  return "Hignett & McAtamney, Applied Ergonomics 31(2), 2000, pp. 201-205";
}

std::span<const SubScore> Reba::subScores() const {
  return kRebaSubScores;
}

int Reba::score(std::span<const int> values) const {
  return rebaSteps(values).final;
}

Evaluation Reba::evaluate(std::span<const int> values) const {
  const RebaSteps steps = rebaSteps(values);
  Evaluation result;
  result.score = steps.final;
  result.level = levelOf(steps.final);
  result.entries = {
      {"A", values[kTrunk], 0, values[kNeck], values[kLegs], steps.table_a},
      {"B", values[kUpperArm], 0, values[kLowerArm], values[kWrist], steps.table_b},
      {"C", std::min(steps.score_a, 12), 0, std::min(steps.score_b, 12), 0, steps.score_c},
  };
  result.sums = {{"table_a", steps.table_a},
                 {"score_a", steps.score_a},
                 {"table_b", steps.table_b},
                 {"score_b", steps.score_b},
                 {"score_c", steps.score_c}};
  return result;
}

int Reba::levelOf(int score) const {
  constexpr std::array kHighest{1, 3, 7, 10};  // Of the levels 0 to 3.
  return static_cast<int>(std::lower_bound(kHighest.begin(), kHighest.end(), score) - kHighest.begin());
}

std::string_view Reba::levelName(int level) const {
  constexpr std::array<std::string_view, 5> kNames{"negligible", "low", "medium", "high", "very high"};
  return kNames[static_cast<std::size_t>(level)];
}

Reba::Values rebaValues(const PostureAngles& angles, std::vector<std::string_view>& unknown) {
  const auto is = [&](const std::optional<bool>& flag, std::string_view name) {
    if (!flag) unknown.push_back(name);
    return flag.value_or(false);
  };
  Reba::Values values;
  if (angles.neck_flexion) {
    const int turned = either(is(angles.neck_twisted, "neck_twisted"), is(angles.neck_side_bent, "neck_side_bent"));
    const double flexion = neutralSettled(angles, *angles.neck_flexion);
    values[Reba::kNeck] = (flexion > 20.0 || flexion < 0.0 ? 2 : 1) + turned;
  }
  if (angles.trunk_flexion) {
    values[Reba::kTrunk] =
        rebaTrunk(neutralSettled(angles, *angles.trunk_flexion)) +
        either(is(angles.trunk_twisted, "trunk_twisted"), is(angles.trunk_side_bent, "trunk_side_bent"));
  }
  const bool is_seated = angles.seated.value_or(false);
  if (is_seated) {
    values[Reba::kLegs] = 1;
  } else if (angles.legs_bilateral && angles.knee_flexion) {
    const double knee = *angles.knee_flexion;
    values[Reba::kLegs] = (*angles.legs_bilateral ? 1 : 2) + (knee >= 30.0 ? 1 : 0) + (knee > 60.0 ? 1 : 0);
    if (angles.off_seat) values[Reba::kLegs] = std::min(*values[Reba::kLegs], nearSeated(*angles.off_seat));
  }
  if (angles.upper_arm_flexion) {
    const int out =
        either(is(angles.upper_arm_abducted, "upper_arm_abducted"), angles.upper_arm_rotated.value_or(false));
    values[Reba::kUpperArm] = std::clamp(rebaUpperArm(*angles.upper_arm_flexion) + out +
                                             (is(angles.shoulder_raised, "shoulder_raised") ? 1 : 0) -
                                             (is(angles.arm_supported, "arm_supported") ? 1 : 0),
                                         1, 6);
  }
  if (angles.lower_arm_flexion) {
    values[Reba::kLowerArm] = *angles.lower_arm_flexion >= 60.0 && *angles.lower_arm_flexion <= 100.0 ? 1 : 2;
  }
  if (angles.wrist_flexion) {
    const int turned = either(is(angles.wrist_deviated, "wrist_deviated"), angles.wrist_twist_at_end.value_or(false));
    values[Reba::kWrist] = (std::abs(*angles.wrist_flexion) > 15.0 ? 2 : 1) + turned;
  }
  return values;
}

}  // namespace hapticell::ergonomics
