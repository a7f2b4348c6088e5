// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/change_search.h"

#include <algorithm>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

// Values tried of each field, the nearest first. Half: farther changes are not found; twice: twice as many tries for
// each field that changes at once.
constexpr std::size_t kMostValues = 5;

std::vector<double> valuesOf(const std::vector<ChangeField>& fields) {
  std::vector<double> values;
  for (const ChangeField& field : fields) values.push_back(field.from);
  return values;
}

FieldChange changeOf(const ChangeField& field, double to) {
  return {field.name, field.is_flag, field.from, to};
}

double costOf(const ChangeField& field, double to) {
  return std::abs(to - field.from) / field.unit;
}

class GoalSearch {
 public:
  GoalSearch(const std::vector<ChangeField>& fields, const ValuesScore& score, const LevelOf& level_of)
      : fields_(fields), score_(score), level_of_(level_of), values_(valuesOf(fields)) {}

  std::optional<PostureGoal> find(std::size_t most) {
    const auto now = score_(values_);
    if (!now) return std::nullopt;
    level_ = level_of_(*now);
    for (std::size_t count = 1; count <= std::min(most, fields_.size()) && !best_; ++count) tryChanges(0, count, 0.0);
    return best_;
  }

 private:
  void tryChanges(std::size_t first, std::size_t left, double cost) {
    if (best_ && cost >= best_cost_) return;
    if (left == 0) {
      take(cost);
      return;
    }
    for (std::size_t i = first; i + left <= fields_.size(); ++i) {
      const ChangeField& field = fields_[i];
      for (std::size_t k = 0; k < std::min(kMostValues, field.values.size()); ++k) {
        values_[i] = field.values[k];
        changes_.push_back(changeOf(field, values_[i]));
        tryChanges(i + 1, left - 1, cost + costOf(field, values_[i]));
        changes_.pop_back();
      }
      values_[i] = field.from;
    }
  }

  void take(double cost) {
    const auto score = score_(values_);
    if (!score || level_of_(*score) >= level_) return;
    best_ = PostureGoal{changes_, *score};
    best_cost_ = cost;
  }

  const std::vector<ChangeField>& fields_;
  const ValuesScore& score_;
  const LevelOf& level_of_;
  std::vector<double> values_;
  std::vector<FieldChange> changes_;
  int level_ = 0;
  std::optional<PostureGoal> best_;
  double best_cost_ = 0.0;
};

}  // namespace

std::vector<PostureDriver> singleChanges(const std::vector<ChangeField>& fields, const ValuesScore& score) {
  std::vector<std::pair<PostureDriver, double>> found;
  std::vector<double> values = valuesOf(fields);
  const auto now = score(values);
  if (!now) return {};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    PostureDriver best{changeOf(fields[i], fields[i].from), *now};
    for (const double to : fields[i].values) {
      values[i] = to;
      const auto after = score(values);
      if (after && *after < best.score) best = {changeOf(fields[i], to), *after};
    }
    values[i] = fields[i].from;
    if (best.score < *now) found.emplace_back(best, costOf(fields[i], best.change.to));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.first.score != b.first.score ? a.first.score < b.first.score : a.second < b.second;
  });
  std::vector<PostureDriver> drivers;
  for (const auto& [driver, cost] : found) drivers.push_back(driver);
  return drivers;
}

std::optional<PostureGoal> nearestLowerLevel(const std::vector<ChangeField>& fields, const ValuesScore& score,
                                             const LevelOf& level_of, std::size_t most) {
  return GoalSearch(fields, score, level_of).find(most);
}

std::vector<double> nearestFirst(std::vector<double> values, double from) {
  std::erase(values, from);
  std::sort(values.begin(), values.end(),
            [from](double a, double b) { return std::abs(a - from) < std::abs(b - from); });
  return values;
}

}  // namespace hapticell::ergonomics
