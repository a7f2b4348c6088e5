// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/posture_advice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

/// Where the classes of RULA and REBA end, and just before where an end belongs to the class above.
constexpr std::array<double, 14> kClassEnds{-20.0, 0.0,  10.0, 14.9, 15.0, 19.9, 20.0,
                                            29.9,  45.0, 59.9, 60.0, 89.9, 90.0, 100.0};

bool isGiven(const PostureField& field, const PostureAngles& angles) {
  return field.angle != nullptr ? (angles.*field.angle).has_value() : (angles.*field.flag).has_value();
}

double valueOf(const PostureField& field, const PostureAngles& angles) {
  return field.angle != nullptr ? *(angles.*field.angle) : (*(angles.*field.flag) ? 1.0 : 0.0);
}

void set(const PostureField& field, PostureAngles& angles, double value) {
  if (field.angle != nullptr) {
    angles.*field.angle = value;
  } else {
    angles.*field.flag = value > 0.5;
  }
}

double costOf(const PostureField& field, double from, double to) {
  return field.angle != nullptr ? std::abs(to - from) / 10.0 : 1.0;
}

/// The values worth trying, nearest first. Seating a standing figure is no correction of its posture.
std::vector<double> candidates(const PostureField& field, const PostureAngles& angles) {
  const double from = valueOf(field, angles);
  std::vector<double> values;
  if (field.angle == nullptr) {
    const double good = field.good_value ? 1.0 : 0.0;
    if (from != good && field.name != "seated") values.push_back(good);
    return values;
  }
  for (const double end : kClassEnds) {
    if (end != from && end >= field.least && end <= field.greatest) values.push_back(end);
  }
  std::sort(values.begin(), values.end(),
            [from](double a, double b) { return std::abs(a - from) < std::abs(b - from); });
  return values;
}

FieldChange changeOf(const PostureField& field, double from, double to) {
  return {field.name, field.flag != nullptr, from, to};
}

/// Of each field the values that matter: of all that score alike alone, the nearest.
struct Option {
  const PostureField* field;
  double from;
  std::vector<double> values;
};

class GoalSearch {
 public:
  GoalSearch(const PostureAngles& angles, const PostureScore& score, const std::function<int(int)>& level_of)
      : angles_(angles), score_(score), level_of_(level_of) {
    const auto now = score(angles);
    if (!now) return;
    level_ = level_of(*now);
    for (const PostureField& field : postureFields()) {
      if (!isGiven(field, angles)) continue;
      const double from = valueOf(field, angles);
      auto values = candidates(field, angles);
      if (values.size() > 5) values.resize(5);
      if (!values.empty()) options_.push_back({&field, from, std::move(values)});
    }
  }

  std::optional<PostureGoal> find() {
    for (std::size_t count = 1; count <= std::min<std::size_t>(4, options_.size()) && !best_; ++count) {
      tryChanges(0, count, 0.0);
    }
    return best_;
  }

 private:
  void tryChanges(std::size_t first, std::size_t left, double cost) {
    if (best_ && cost >= best_cost_) return;
    if (left == 0) {
      take(cost);
      return;
    }
    for (std::size_t i = first; i + left <= options_.size(); ++i) {
      const Option& option = options_[i];
      for (const double to : option.values) {
        set(*option.field, angles_, to);
        changes_.push_back(changeOf(*option.field, option.from, to));
        tryChanges(i + 1, left - 1, cost + costOf(*option.field, option.from, to));
        changes_.pop_back();
      }
      set(*option.field, angles_, option.from);
    }
  }

  void take(double cost) {
    const auto score = score_(angles_);
    if (!score || level_of_(*score) >= level_) return;
    best_ = PostureGoal{changes_, *score};
    best_cost_ = cost;
  }

  PostureAngles angles_;
  const PostureScore& score_;
  const std::function<int(int)>& level_of_;
  std::vector<Option> options_;
  std::vector<FieldChange> changes_;
  int level_ = 0;
  std::optional<PostureGoal> best_;
  double best_cost_ = 0.0;
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
      {"seated", nullptr, &A::seated, 0.0, 0.0, true},
  };
  return kFields;
}

std::vector<PostureDriver> postureDrivers(const PostureAngles& angles, const PostureScore& score) {
  std::vector<PostureDriver> drivers;

  const auto now = score(angles);
  if (!now) return drivers;
  PostureAngles changed = angles;
  for (const PostureField& field : postureFields()) {
    if (!isGiven(field, angles)) continue;
    const double from = valueOf(field, angles);
    PostureDriver best{changeOf(field, from, from), *now};
    for (const double to : candidates(field, angles)) {
      set(field, changed, to);
      const auto after = score(changed);
      if (after && *after < best.score) best = {changeOf(field, from, to), *after};
    }
    set(field, changed, from);
    if (best.score < *now) drivers.push_back(best);
  }
  std::stable_sort(drivers.begin(), drivers.end(), [](const PostureDriver& a, const PostureDriver& b) {
    if (a.score != b.score) return a.score < b.score;
    return std::abs(a.change.to - a.change.from) < std::abs(b.change.to - b.change.from);
  });
  return drivers;
}

std::optional<PostureGoal> nextLevelPosture(const PostureAngles& angles, const PostureScore& score,
                                            const std::function<int(int)>& level_of) {
  return GoalSearch(angles, score, level_of).find();
}

}  // namespace hapticell::ergonomics
