// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/lifting_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hapticell::ergonomics {
namespace {

/// An input, the value that costs nothing, and the step to which a change is told.
struct Input {
  std::string_view field;
  double LiftingTask::*member;
  double best;
  double step;
};

constexpr std::string_view kCouplingField = "coupling", kLoadField = "load_kg";
constexpr std::array<Input, 5> kInputs{{{"h_cm", &LiftingTask::h_cm, 25.0, 0.1},
                                        {"v_cm", &LiftingTask::v_cm, 75.0, 0.1},
                                        {"d_cm", &LiftingTask::d_cm, 25.0, 0.1},
                                        {"asymmetry_deg", &LiftingTask::asymmetry_deg, 0.0, 1.0},
                                        {"frequency_per_min", &LiftingTask::frequency_per_min, 0.2, 0.01}}};
constexpr Input kLoadInput{kLoadField, &LiftingTask::load_kg, 0.1, 0.1};

double indexOrMost(const LiftingIndex& index_of, const LiftingTask& task) {
  return index_of(task).value_or(std::numeric_limits<double>::infinity());
}

bool costsNothing(const LiftingTask& task, const Input& input) {
  const double value = task.*input.member;
  // Nearer, shorter and rarer than the best value gain no more.
  return input.field == "v_cm" ? value == input.best : value <= input.best;
}

/// The nearest value of an input with which the index is at most `target`; the best one where none is.
LiftingChange changeOf(const LiftingTask& task, const Input& input, const LiftingIndex& index_of, double target) {
  const double from = task.*input.member;
  LiftingTask tried = task;
  const auto indexAt = [&](double value) {
    tried.*input.member = value;
    return indexOrMost(index_of, tried);
  };
  double far = input.best, near = from;
  if (indexAt(far) <= target) {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (near + far);
      (indexAt(middle) <= target ? far : near) = middle;
    }
    // To a whole step, towards the best.
    const double steps = far / input.step;
    // Of a step: rounding, so that a value on a whole step stays on it. Half, twice: no effect.
    constexpr double kSlack = 1e-6;
    const double whole = input.step * (input.best < from ? std::floor(steps + kSlack) : std::ceil(steps - kSlack));
    far = input.best < from ? std::max(input.best, whole) : std::min(input.best, whole);
    if (indexAt(far) > target)
      far = std::clamp(far + (input.best < from ? -input.step : input.step), std::min(from, input.best),
                       std::max(from, input.best));
  }
  tried.*input.member = far;
  return {input.field, from, far, index_of(tried)};
}

bool isEnough(const LiftingChange& change, double target) {
  return change.index && *change.index <= target;
}

LiftingChange couplingChange(const LiftingTask& task, const LiftingIndex& index_of) {
  LiftingTask tried = task;
  tried.coupling = Coupling::kGood;
  return {kCouplingField, static_cast<double>(task.coupling), 0.0, index_of(tried)};
}

const Input* inputOf(std::string_view field) {
  const auto found = std::find_if(kInputs.begin(), kInputs.end(), [&](const Input& i) { return i.field == field; });
  return found == kInputs.end() ? nullptr : &*found;
}

std::vector<LiftingDriver> driversOf(const LiftingResult& result) {
  std::vector<LiftingDriver> drivers{{"h_cm", "HM", result.hm},
                                     {"v_cm", "VM", result.vm},
                                     {"d_cm", "DM", result.dm},
                                     {"asymmetry_deg", "AM", result.am},
                                     {"frequency_per_min", "FM", result.fm},
                                     {kCouplingField, "CM", result.cm}};
  std::erase_if(drivers, [](const LiftingDriver& driver) { return driver.value >= 1.0; });
  std::stable_sort(drivers.begin(), drivers.end(),
                   [](const LiftingDriver& a, const LiftingDriver& b) { return a.value < b.value; });
  return drivers;
}

/// The costliest inputs at their best, one after the other, the last only as far as needed; the load if all that is not
/// enough.
std::vector<LiftingChange> together(LiftingTask task, const LiftingAdvice& advice, const LiftingIndex& index_of) {
  std::vector<LiftingChange> changes;
  const auto add = [&](const LiftingChange& change) {
    changes.push_back(change);
    return isEnough(change, advice.target);
  };
  for (const LiftingDriver& driver : advice.drivers) {
    const Input* input = inputOf(driver.field);
    const LiftingChange change =
        input ? changeOf(task, *input, index_of, advice.target) : couplingChange(task, index_of);
    if (input) {
      task.*input->member = change.to;
    } else {
      task.coupling = Coupling::kGood;
    }
    if (add(change)) return changes;
  }
  return add(changeOf(task, kLoadInput, index_of, advice.target)) ? changes : std::vector<LiftingChange>{};
}

}  // namespace

int liftingLevel(const std::optional<double>& index) {
  if (!index) return 3;
  if (*index <= 1.0) return 1;
  return *index <= 3.0 ? 2 : 3;
}

std::string_view liftingLevelName(int level) {
  constexpr std::array<std::string_view, 3> kNames{"acceptable for nearly all healthy workers",
                                                   "raised risk for some; redesign",
                                                   "raised risk for many; redesign now"};
  return kNames[static_cast<std::size_t>(std::clamp(level, 1, 3) - 1)];
}

LiftingAdvice adviseLift(const LiftingTask& task, const LiftingResult& result, const LiftingIndex& index_of) {
  LiftingAdvice advice;
  advice.level = liftingLevel(index_of(task));
  advice.target = advice.level == 3 ? 3.0 : 1.0;
  advice.drivers = driversOf(result);
  if (advice.level == 1) return advice;
  for (const Input& input : kInputs) {
    if (costsNothing(task, input)) continue;
    if (const auto change = changeOf(task, input, index_of, advice.target); isEnough(change, advice.target))
      advice.alone.push_back(change);
  }
  if (task.coupling != Coupling::kGood) {
    if (const auto change = couplingChange(task, index_of); isEnough(change, advice.target))
      advice.alone.push_back(change);
  }
  const bool no_other = advice.alone.empty();
  if (const auto change = changeOf(task, kLoadInput, index_of, advice.target); isEnough(change, advice.target))
    advice.alone.push_back(change);
  if (no_other) advice.together = together(task, advice, index_of);
  return advice;
}

LiftingAdvice adviseLift(const LiftingTask& task, const LiftingResult& result) {
  LiftingAdvice advice = adviseLift(task, result, [](const LiftingTask& changed) -> std::optional<double> {
    const auto lifted = lift(changed);
    return lifted ? lifted->lifting_index : std::nullopt;
  });
  for (LiftingDriver& driver : advice.drivers) {
    if (result.lifting_index) driver.index = *result.lifting_index * driver.value;
  }
  return advice;
}

}  // namespace hapticell::ergonomics
