// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/niosh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace hapticell::ergonomics {
namespace {

// kg: the load constant of the revised NIOSH lifting equation (Waters and others 1993). Not ours to change.
constexpr double kLoadConstantKg = 23.0;

struct FrequencyRow {
  double per_minute;
  double low[3];   ///< V < 75 cm: up to 1 h, 2 h, 8 h.
  double high[3];  ///< V >= 75 cm.
};

constexpr std::array<FrequencyRow, 17> kFrequencies{{
    {0.2, {1.00, 0.95, 0.85}, {1.00, 0.95, 0.85}},
    {0.5, {0.97, 0.92, 0.81}, {0.97, 0.92, 0.81}},
    {1, {0.94, 0.88, 0.75}, {0.94, 0.88, 0.75}},
    {2, {0.91, 0.84, 0.65}, {0.91, 0.84, 0.65}},
    {3, {0.88, 0.79, 0.55}, {0.88, 0.79, 0.55}},
    {4, {0.84, 0.72, 0.45}, {0.84, 0.72, 0.45}},
    {5, {0.80, 0.60, 0.35}, {0.80, 0.60, 0.35}},
    {6, {0.75, 0.50, 0.27}, {0.75, 0.50, 0.27}},
    {7, {0.70, 0.42, 0.22}, {0.70, 0.42, 0.22}},
    {8, {0.60, 0.35, 0.18}, {0.60, 0.35, 0.18}},
    {9, {0.52, 0.30, 0.00}, {0.52, 0.30, 0.15}},
    {10, {0.45, 0.26, 0.00}, {0.45, 0.26, 0.13}},
    {11, {0.41, 0.00, 0.00}, {0.41, 0.23, 0.00}},
    {12, {0.37, 0.00, 0.00}, {0.37, 0.21, 0.00}},
    {13, {0.00, 0.00, 0.00}, {0.34, 0.00, 0.00}},
    {14, {0.00, 0.00, 0.00}, {0.31, 0.00, 0.00}},
    {15, {0.00, 0.00, 0.00}, {0.28, 0.00, 0.00}},
}};

struct Range {
  const char* name;
  double value, least, greatest;
  Text why{};
};

}  // namespace

Expected<void> checkLiftingRanges(const LiftingTask& task) {
  const Range ranges[] = {
      {"load_kg", task.load_kg, 1e-3, 1000.0},
      {"h_cm", task.h_cm, 0.0, 200.0},
      {"v_cm", task.v_cm, 0.0, 300.0},
      {"d_cm", task.d_cm, 0.0, 300.0},
      {"asymmetry_deg", task.asymmetry_deg, 0.0, 180.0},
      {"frequency_per_min", task.frequency_per_min, 0.0, 60.0},
      {"duration_h", task.duration_h, 1e-3, 8.0, Text("The equation covers shifts of up to 8 h.")},
  };
  for (const Range& range : ranges) {
    if (range.value >= range.least && range.value <= range.greatest) continue;
    char found[64], least[64], greatest[64];
    std::snprintf(found, sizeof found, "%g", range.value);
    std::snprintf(least, sizeof least, "%g", range.least);
    std::snprintf(greatest, sizeof greatest, "%g", range.greatest);
    return makeError({.place = Text::plain(range.name),
                      .found = std::string(found),
                      .expected = Text("%1 to %2", std::string(least), std::string(greatest)),
                      .fix = range.why});
  }
  return {};
}

namespace {

Expected<void> checkConditions(const LiftingConditions& conditions) {
  const std::pair<bool, const char*> excluded[] = {
      {conditions.one_handed, "one_handed"},
      {conditions.seated_or_kneeling, "seated_or_kneeling"},
      {conditions.restricted_space, "restricted_space"},
      {conditions.unstable_load, "unstable_load"},
      {conditions.pushing_pulling_or_carrying, "pushing_pulling_or_carrying"},
      {conditions.fast, "fast"},
      {conditions.hot_or_cold, "hot_or_cold"},
      {conditions.slippery_floor, "slippery_floor"},
  };
  for (const auto& [applies, name] : excluded) {
    if (!applies) continue;
    return makeError({.place = Text::plain(name),
                      .found = "the lifting equation is not valid for this",
                      .expected = "a smooth two-handed lift, standing",
                      .fix = "Assess the task with another method, such as RULA, REBA or EN 1005-2."});
  }
  return {};
}

double horizontalMultiplier(double h_cm) {
  return h_cm > 63.0 ? 0.0 : 25.0 / std::max(h_cm, 25.0);
}

double verticalMultiplier(double v_cm) {
  return v_cm > 175.0 ? 0.0 : 1.0 - 0.003 * std::abs(v_cm - 75.0);
}

double distanceMultiplier(double d_cm) {
  return d_cm > 175.0 ? 0.0 : 0.82 + 4.5 / std::max(d_cm, 25.0);
}

double asymmetryMultiplier(double degrees) {
  return degrees > 135.0 ? 0.0 : 1.0 - 0.0032 * degrees;
}

double couplingMultiplier(Coupling coupling, double v_cm) {
  switch (coupling) {
    case Coupling::kGood:
      return 1.0;
    case Coupling::kFair:
      return v_cm < 75.0 ? 0.95 : 1.0;
    case Coupling::kPoor:
      return 0.90;
  }
  return 0.90;
}

std::vector<std::string> assumptionsFor(const LiftingTask& task) {
  std::vector<std::string> notes{
      "The load is lifted smoothly with both hands, standing, on a firm floor, at 19 to 26 °C."};
  if (task.duration_h <= 1.0) {
    notes.push_back("Up to 1 h of lifting is followed by light work at least as long.");
  } else if (task.duration_h <= 2.0) {
    notes.push_back("Up to 2 h of lifting are followed by light work of at least 0.3 times that.");
  }
  notes.push_back("The origin of the lift was judged; where the load is placed with care, judge the destination too.");
  if (task.h_cm < 25.0) notes.push_back("h_cm under 25 counts as 25.");
  if (task.d_cm < 25.0) notes.push_back("d_cm under 25 counts as 25.");
  if (task.frequency_per_min < 0.2) notes.push_back("frequency_per_min under 0.2 counts as 0.2.");
  return notes;
}

}  // namespace

double frequencyMultiplier(double frequency_per_min, double duration_h, double v_cm) {
  if (frequency_per_min > kFrequencies.back().per_minute) return 0.0;
  std::size_t column = duration_h <= 2.0 ? 1 : 2;
  if (duration_h <= 1.0) column = 0;
  const auto value = [&](const FrequencyRow& row) { return v_cm < 75.0 ? row.low[column] : row.high[column]; };
  const double frequency = std::max(frequency_per_min, kFrequencies.front().per_minute);
  const auto after = std::find_if(kFrequencies.begin(), kFrequencies.end(),
                                  [&](const FrequencyRow& row) { return row.per_minute >= frequency; });
  if (after == kFrequencies.begin()) return value(*after);
  const auto before = after - 1;
  const double share = (frequency - before->per_minute) / (after->per_minute - before->per_minute);
  return value(*before) + share * (value(*after) - value(*before));
}

Expected<LiftingResult> lift(const LiftingTask& task, const LiftingConditions& conditions) {
  HAPTICELL_TRY(checkLiftingRanges(task));
  HAPTICELL_TRY(checkConditions(conditions));
  LiftingResult result;
  result.hm = horizontalMultiplier(task.h_cm);
  result.vm = verticalMultiplier(task.v_cm);
  result.dm = distanceMultiplier(task.d_cm);
  result.am = asymmetryMultiplier(task.asymmetry_deg);
  result.fm = frequencyMultiplier(task.frequency_per_min, task.duration_h, task.v_cm);
  result.cm = couplingMultiplier(task.coupling, task.v_cm);
  result.frequency_independent_limit_kg = kLoadConstantKg * result.hm * result.vm * result.dm * result.am * result.cm;
  result.recommended_weight_limit_kg = result.frequency_independent_limit_kg * result.fm;
  if (result.frequency_independent_limit_kg > 0.0) {
    result.frequency_independent_index = task.load_kg / result.frequency_independent_limit_kg;
  }
  if (result.recommended_weight_limit_kg > 0.0) {
    result.lifting_index = task.load_kg / result.recommended_weight_limit_kg;
  }
  result.assumptions = assumptionsFor(task);
  return result;
}

Expected<CompositeLifting> compositeLift(std::span<const LiftingTask> tasks, const LiftingConditions& conditions) {
  if (tasks.empty()) return makeError({.place = "tasks", .found = "none", .expected = "at least one lifting task"});
  CompositeLifting result;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    auto one = lift(tasks[i], conditions);
    if (!one) {
      one.error().place = Text("task %1, %2", i + 1, one.error().place);
      return tl::unexpected(one.error());
    }
    if (!one->lifting_index) {
      return makeError({.place = Text("task %1", i + 1),
                        .found = "a task whose recommended weight limit is 0",
                        .expected = "tasks with a limit above 0",
                        .fix = "Change that task first."});
    }
    result.tasks.push_back(std::move(*one));
  }
  result.order.resize(tasks.size());
  std::iota(result.order.begin(), result.order.end(), 0);
  std::stable_sort(result.order.begin(), result.order.end(), [&](std::size_t a, std::size_t b) {
    return *result.tasks[a].lifting_index > *result.tasks[b].lifting_index;
  });
  result.index = *result.tasks[result.order.front()].lifting_index;
  double frequency = tasks[result.order.front()].frequency_per_min;
  for (auto place = result.order.begin() + 1; place != result.order.end(); ++place) {
    const LiftingTask& task = tasks[*place];
    const double before = frequencyMultiplier(frequency, task.duration_h, task.v_cm);
    frequency += task.frequency_per_min;
    const double with = frequencyMultiplier(frequency, task.duration_h, task.v_cm);
    if (with <= 0.0) {
      return makeError({.place = Text::plain("frequency_per_min"),
                        .found = "all tasks together have more lifts per minute than the table covers",
                        .expected = "at most 15 per minute, fewer in longer shifts",
                        .fix = "Spread the tasks over the day."});
    }
    result.index += *result.tasks[*place].frequency_independent_index * (1.0 / with - 1.0 / before);
  }
  return result;
}

}  // namespace hapticell::ergonomics
