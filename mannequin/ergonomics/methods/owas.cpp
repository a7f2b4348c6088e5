// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/owas.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/text.h"

namespace hapticell::ergonomics {
namespace {

constexpr std::array<SubScore, Owas::kCount> kSubScores{{{HAPTICELL_TRANSLATED("back"), 1, 4},
                                                         {HAPTICELL_TRANSLATED("arms"), 1, 3},
                                                         {HAPTICELL_TRANSLATED("legs"), 1, 7},
                                                         {HAPTICELL_TRANSLATED("load"), 1, 3}}};

// Rows: back 1 to 4, each with arms 1 to 3; columns: legs 1 to 7, each number the categories of loads 1, 2 and 3.
constexpr int kCategories[12][7] = {
    {111, 111, 111, 222, 222, 111, 111}, {111, 111, 111, 222, 222, 111, 111}, {111, 111, 111, 223, 223, 111, 112},
    {223, 223, 223, 333, 333, 222, 233}, {223, 223, 233, 344, 344, 334, 234}, {334, 223, 333, 344, 444, 444, 234},
    {111, 111, 112, 333, 444, 111, 111}, {223, 111, 112, 444, 444, 333, 111}, {223, 111, 233, 444, 444, 444, 111},
    {233, 223, 223, 444, 444, 444, 234}, {334, 234, 334, 444, 444, 444, 234}, {444, 234, 334, 444, 444, 444, 234},
};

constexpr std::array<std::string_view, 4> kBackMeanings{
    HAPTICELL_TRANSLATED("straight", "bent", "twisted or bent sideways", "bent and twisted or bent sideways")};
constexpr std::array<std::string_view, 3> kArmMeanings{HAPTICELL_TRANSLATED(
    "both below shoulder level", "one at or above shoulder level", "both at or above shoulder level")};
constexpr std::array<std::string_view, 7> kLegMeanings{HAPTICELL_TRANSLATED(
    "sitting", "standing on two straight legs", "standing on one straight leg",
    "standing or squatting on two bent legs", "standing or squatting on one bent leg", "kneeling", "walking")};
constexpr std::array<std::string_view, 3> kLoadMeanings{
    HAPTICELL_TRANSLATED("up to 10 kg", "over 10 and up to 20 kg", "over 20 kg")};

int legs(const OwasPosture& posture) {
  // Degrees of a knee that OWAS calls bent; the method names no number for eyes, this is our choice. Half: natural
  // standing is bent; twice: a half squat is straight.
  constexpr double kBent = 30.0;
  if (posture.seated) return 1;
  if (posture.kneeling) return 6;
  if (posture.walking) return 7;
  const double straighter = std::min(posture.left_knee_flexion, posture.right_knee_flexion);
  const double more_bent = std::max(posture.left_knee_flexion, posture.right_knee_flexion);
  if (posture.on_one_leg) return straighter > kBent ? 5 : 3;
  if (straighter > kBent) return 4;
  return more_bent > kBent ? 5 : 2;
}

}  // namespace

std::string_view Owas::source() const {
  return "Karhu, Kansi & Kuorinka, Applied Ergonomics 8(4), 1977, pp. 199-201";
}

std::span<const SubScore> Owas::subScores() const {
  return kSubScores;
}

int Owas::score(std::span<const int> v) const {
  const int triple = kCategories[3 * (v[kBack] - 1) + v[kArms] - 1][v[kLegs] - 1];
  constexpr std::array<int, 3> kPlace{100, 10, 1};
  return triple / kPlace[static_cast<std::size_t>(v[kLoad] - 1)] % 10;
}

Evaluation Owas::evaluate(std::span<const int> values) const {
  Evaluation result;
  result.score = score(values);
  result.level = result.score;
  result.entries = {{"categories", values[kBack], values[kArms], values[kLegs], values[kLoad], result.score}};
  return result;
}

std::string_view Owas::levelName(int level) const {
  constexpr std::array<std::string_view, 4> kNames{"normal", "correct soon", "correct as early as possible",
                                                   "correct now"};
  return kNames[static_cast<std::size_t>(level - 1)];
}

std::string_view Owas::meaning(Index digit, int value) {
  const auto index = static_cast<std::size_t>(value - 1);
  switch (digit) {
    case kBack:
      return kBackMeanings.at(index);
    case kArms:
      return kArmMeanings.at(index);
    case kLegs:
      return kLegMeanings.at(index);
    case kLoad:
      return kLoadMeanings.at(index);
    case kCount:
      break;
  }
  return {};
}

Owas::Values owasValues(const OwasPosture& posture) {
  // Degrees from which a back is bent or turned; OWAS looks by eye, this is our choice, as RULA's second class ends
  // there. Half: upright work scores as bent; twice: bending by 40 deg scores as straight.
  constexpr double kTurned = 20.0;
  const bool is_bent = std::abs(posture.trunk_flexion) > kTurned;
  const bool is_turned = std::abs(posture.trunk_twist) > kTurned || std::abs(posture.trunk_side_bend) > kTurned;
  Owas::Values values;
  values[Owas::kBack] = 1 + (is_bent ? 1 : 0) + (is_turned ? 2 : 0);
  values[Owas::kArms] = 1 + std::clamp(posture.arms_at_or_above_shoulder, 0, 2);
  values[Owas::kLegs] = legs(posture);
  values[Owas::kLoad] = 1 + (posture.load_kg > 10.0 ? 1 : 0) + (posture.load_kg > 20.0 ? 1 : 0);
  return values;
}

}  // namespace hapticell::ergonomics
