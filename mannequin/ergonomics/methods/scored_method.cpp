// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/scored_method.h"

#include <algorithm>
#include <cstdlib>

#include "geometry/system/assertion.h"

namespace hapticell::ergonomics {
namespace {

/// Calls `visit(values)` for every value that the sub-scores at `open` could take.
template <typename Visit>
void forAllValues(const ScoredMethod& method, std::span<const std::size_t> open, std::vector<int>& values,
                  const Visit& visit) {
  if (open.empty()) {
    visit();
    return;
  }
  const SubScore& sub_score = method.subScores()[open.front()];
  for (int value = sub_score.least; value <= sub_score.greatest; ++value) {
    values[open.front()] = value;
    forAllValues(method, open.subspan(1), values, visit);
  }
}

/// The values that a change may take: lower ones where the method has an order, else all others.
std::vector<int> changesOf(const ScoredMethod& method, const SubScore& sub_score, int from) {
  std::vector<int> changes;
  const int last = method.isOrdered() ? from - 1 : sub_score.greatest;
  for (int value = sub_score.least; value <= last; ++value) {
    if (value != from) changes.push_back(value);
  }
  std::sort(changes.begin(), changes.end(), [from](int a, int b) { return std::abs(a - from) < std::abs(b - from); });
  return changes;
}

std::vector<Driver> findDrivers(const ScoredMethod& method, std::vector<int> values) {
  const int now = method.score(values);
  std::vector<Driver> drivers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int from = values[i];
    Driver best{method.subScores()[i].name, from, from, now};
    for (const int to : changesOf(method, method.subScores()[i], from)) {
      values[i] = to;
      const int score = method.score(values);
      if (score < best.score) best = {best.sub_score, from, to, score};
    }
    values[i] = from;
    if (best.score < now) drivers.push_back(best);
  }
  std::stable_sort(drivers.begin(), drivers.end(), [](const Driver& a, const Driver& b) { return a.score < b.score; });
  return drivers;
}

/// Breadth first over the number of sub-scores that change, then over the sum of their changes.
class NextLevelSearch {
 public:
  NextLevelSearch(const ScoredMethod& method, std::vector<int> values)
      : method_(method), start_(values), values_(std::move(values)), level_(method.levelOf(method.score(start_))) {}

  std::optional<NextLevel> find() {
    for (std::size_t count = 1; count <= start_.size() && !best_; ++count) tryChanges(0, count, 0);
    return best_;
  }

 private:
  void tryChanges(std::size_t first, std::size_t left, int cost) {
    if (best_ && cost >= best_cost_) return;
    if (left == 0) {
      take(cost);
      return;
    }
    for (std::size_t i = first; i + left <= start_.size(); ++i) {
      for (const int to : changesOf(method_, method_.subScores()[i], start_[i])) {
        values_[i] = to;
        tryChanges(i + 1, left - 1, cost + std::abs(to - start_[i]));
      }
      values_[i] = start_[i];
    }
  }

  void take(int cost) {
    const int score = method_.score(values_);
    if (method_.levelOf(score) >= level_) return;
    best_ = NextLevel{{}, score, method_.levelOf(score)};
    best_cost_ = cost;
    for (std::size_t i = 0; i < start_.size(); ++i) {
      if (values_[i] != start_[i]) best_->changes.push_back({method_.subScores()[i].name, start_[i], values_[i]});
    }
  }

  const ScoredMethod& method_;
  const std::vector<int> start_;
  std::vector<int> values_;
  const int level_;
  std::optional<NextLevel> best_;
  int best_cost_ = 0;
};

}  // namespace

Assessment assess(const ScoredMethod& method, std::span<const std::optional<int>> values) {
  const auto sub_scores = method.subScores();
  HAPTICELL_DEMAND(values.size() == sub_scores.size());
  Assessment result;
  std::vector<std::size_t> open;
  bool is_known = true;
  for (std::size_t i = 0; i < sub_scores.size(); ++i) {
    result.values.push_back(values[i].value_or(sub_scores[i].required ? 0 : sub_scores[i].least));
    if (values[i]) continue;
    open.push_back(i);
    result.missing.push_back(sub_scores[i].name);
    is_known = is_known && !sub_scores[i].required;
  }
  std::vector<int> tried = result.values;
  bool is_first = true;
  forAllValues(method, open, tried, [&] {
    const int score = method.score(tried);
    result.least_score = is_first ? score : std::min(score, result.least_score);
    result.greatest_score = is_first ? score : std::max(score, result.greatest_score);
    is_first = false;
  });
  if (!is_known) return result;
  result.evaluation = method.evaluate(result.values);
  result.score = result.evaluation->score;
  result.level = result.evaluation->level;
  result.drivers = findDrivers(method, result.values);
  result.next_level = NextLevelSearch(method, result.values).find();
  return result;
}

}  // namespace hapticell::ergonomics
