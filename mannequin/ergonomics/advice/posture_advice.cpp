// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/posture_advice.h"

#include <array>
#include <cmath>

#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"

namespace hapticell::ergonomics {
namespace {

/// Where the classes of RULA and REBA end, and just before where an end belongs to the class above.
constexpr std::array<double, 14> kClassEnds{-20.0, 0.0,  10.0, 14.9, 15.0, 19.9, 20.0,
                                            29.9,  45.0, 59.9, 60.0, 89.9, 90.0, 100.0};

bool isGiven(const PostureField& field, const PostureAngles& angles) {
  return field.angle != nullptr ? (angles.*field.angle).has_value() : (angles.*field.flag).has_value();
}

double valueOf(const PostureField& field, const PostureAngles& angles) {
  if (field.angle != nullptr) return *(angles.*field.angle);
  return *(angles.*field.flag) ? 1.0 : 0.0;
}

void set(const PostureField& field, PostureAngles& angles, double value) {
  if (field.angle != nullptr) {
    angles.*field.angle = value;
  } else {
    angles.*field.flag = value > 0.5;
  }
}

/// The values worth trying.
ChangeField changeFieldOf(const PostureField& field, double from) {
  ChangeField result{field.name, field.flag != nullptr, field.flag != nullptr ? 1.0 : 10.0, from};
  if (!field.is_correctable) return result;
  if (field.flag != nullptr) {
    const double good = field.good_value ? 1.0 : 0.0;
    if (from != good) result.values.push_back(good);
    return result;
  }
  std::vector<double> ends;
  for (const double end : kClassEnds) {
    if (end >= field.least && end <= field.greatest) ends.push_back(end);
  }
  result.values = nearestFirst(std::move(ends), from);
  return result;
}

/// The given fields of a posture as the search knows them, and the way back.
struct AngleSearch {
  AngleSearch(const PostureAngles& given, const PostureScore& score_of) : angles(given) {
    for (const PostureField& field : postureFields()) {
      if (!isGiven(field, given)) continue;
      places.push_back(&field);
      fields.push_back(changeFieldOf(field, valueOf(field, given)));
    }
    score = [this, &score_of](std::span<const double> values) -> std::optional<double> {
      for (std::size_t i = 0; i < values.size(); ++i) set(*places[i], angles, values[i]);
      const auto found = score_of(angles);
      return found ? std::optional<double>(*found) : std::nullopt;
    };
  }
  AngleSearch(const AngleSearch&) = delete;
  AngleSearch& operator=(const AngleSearch&) = delete;

  PostureAngles angles;
  std::vector<const PostureField*> places;
  std::vector<ChangeField> fields;
  ValuesScore score;
};

}  // namespace

const std::vector<PostureField>& postureFields() {
  using A = PostureAngles;
  static const std::vector<PostureField> kFields{
      {"upper_arm_flexion", &A::upper_arm_flexion, nullptr, -90.0, 180.0},
      {"lower_arm_flexion", &A::lower_arm_flexion, nullptr, -15.0, 160.0},
      {"wrist_flexion", &A::wrist_flexion, nullptr, -90.0, 90.0},
      {"neck_flexion", &A::neck_flexion, nullptr, -90.0, 90.0},
      {"trunk_flexion", &A::trunk_flexion, nullptr, -90.0, 150.0},
      {"knee_flexion", &A::knee_flexion, nullptr, -15.0, 160.0},
      {"upper_arm_abducted", nullptr, &A::upper_arm_abducted},
      {"upper_arm_rotated", nullptr, &A::upper_arm_rotated},
      {"shoulder_raised", nullptr, &A::shoulder_raised},
      {"arm_supported", nullptr, &A::arm_supported, 0.0, 0.0, true},
      {"lower_arm_across_midline", nullptr, &A::lower_arm_across_midline},
      {"wrist_deviated", nullptr, &A::wrist_deviated},
      {"wrist_twist", nullptr, &A::wrist_twist_at_end},
      {"neck_twisted", nullptr, &A::neck_twisted},
      {"neck_side_bent", nullptr, &A::neck_side_bent},
      {"trunk_twisted", nullptr, &A::trunk_twisted},
      {"trunk_side_bent", nullptr, &A::trunk_side_bent},
      {"trunk_supported", nullptr, &A::trunk_supported, 0.0, 0.0, true},
      {"legs_supported", nullptr, &A::legs_supported, 0.0, 0.0, true},
      {"legs_bilateral", nullptr, &A::legs_bilateral, 0.0, 0.0, true},
      {"seated", nullptr, &A::seated, 0.0, 0.0, true, false},
      {"off_seat", &A::off_seat, nullptr, 0.0, 180.0, false, false},
      {"measured", nullptr, &A::measured, 0.0, 0.0, true, false},
  };
  return kFields;
}

PostureScore scoreOfAngles(const ScoredMethod& method, std::span<const std::optional<int>> values) {
  const bool is_rula = method.name() == "RULA";
  return [&method, is_rula, given = std::vector<std::optional<int>>(values.begin(), values.end()),
          complete = std::vector<int>(values.size()),
          unknown = std::vector<std::string_view>()](const PostureAngles& angles) mutable -> std::optional<int> {
    const auto score = [&](std::span<const std::optional<int>> of_angles) -> std::optional<int> {
      for (std::size_t i = 0; i < complete.size(); ++i) {
        const SubScore& sub_score = method.subScores()[i];
        if (sub_score.required && !of_angles[i]) return std::nullopt;
        complete[i] = sub_score.required ? *of_angles[i] : given[i].value_or(sub_score.least);
      }
      return method.score(complete);
    };
    unknown.clear();
    return is_rula ? score(rulaValues(angles, unknown)) : score(rebaValues(angles, unknown));
  };
}

std::vector<PostureDriver> postureDrivers(const PostureAngles& angles, const PostureScore& score) {
  AngleSearch search(angles, score);
  return singleChanges(search.fields, search.score);
}

std::optional<PostureGoal> nextLevelPosture(const PostureAngles& angles, const PostureScore& score,
                                            const std::function<int(int)>& level_of) {
  AngleSearch search(angles, score);
  return nearestLowerLevel(search.fields, search.score,
                           [&](double found) { return level_of(static_cast<int>(std::lround(found))); });
}

}  // namespace hapticell::ergonomics
