// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/work_task.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hapticell::ergonomics {
namespace {

/// Repetitions a minute from which RULA and REBA speak of repeated action; the methods' own number. Not ours to change.
constexpr double kRepeated = 4.0;

Expected<void> within(const char* name, double value, double least, double most, const Text& expected) {
  if (std::isfinite(value) && value >= least && value <= most) return {};
  char found[64];
  std::snprintf(found, sizeof found, "%g", value);
  return makeError({.place = Text::plain(name), .found = std::string(found), .expected = expected});
}

bool isRepeatedOrStatic(const WorkTask& task) {
  return task.is_static.value_or(false) || task.repetitions_per_min.value_or(0.0) >= kRepeated;
}

WorkTask preset(const char* name, double load, double repetitions, bool is_static, Grip grip, double hours) {
  WorkTask task;
  task.name = name;
  task.load_kg = {0.0, load};
  task.repetitions_per_min = repetitions;
  task.is_static = is_static;
  task.grip = grip;
  task.duration_h = hours;
  task.has_shock = false;
  task.has_rapid_changes = false;
  return task;
}

std::vector<WorkTask> makePresets() {
  std::vector<WorkTask> presets{preset("Inspection", 0.0, 0.5, true, Grip::kGood, 7.0),
                                preset("Light assembly", 0.5, 6.0, false, Grip::kGood, 7.0),
                                preset("Screwing, nut runner", 2.4, 2.0, false, Grip::kGood, 7.0),
                                preset("Overhead work", 1.5, 2.0, true, Grip::kFair, 4.0),
                                preset("Packing boxes", 4.0, 5.0, false, Grip::kFair, 6.0),
                                preset("Lifting crates", 6.0, 2.0, false, Grip::kFair, 2.0)};
  presets[4].load_kg = {2.0, 2.0};
  presets[5].load_kg = {6.0, 6.0};
  presets[5].is_lift = true;
  presets[5].lift_distance_m = 0.6;
  return presets;
}

}  // namespace

std::optional<double> WorkTask::totalLoad() const {
  if (!load_kg[0] && !load_kg[1]) return std::nullopt;
  return load_kg[0].value_or(0.0) + load_kg[1].value_or(0.0);
}

Expected<void> checkWorkTask(const WorkTask& task) {
  for (const auto& load : task.load_kg) {
    if (auto good = within("load_kg", load.value_or(0.0), 0.0, 200.0, Text("0 to 200 kg")); !good) return good;
  }
  if (auto good = within("repetitions_per_min", task.repetitions_per_min.value_or(0.0), 0.0, 120.0,
                         Text("0 to 120 per minute"));
      !good)
    return good;
  if (auto good = within("duration_h", task.duration_h.value_or(0.0), 0.0, 24.0, Text("0 to 24 hours")); !good)
    return good;
  if (auto good = within("lift_distance_m", task.lift_distance_m, 0.0, 2.0, Text("0 to 2 m")); !good) return good;
  return within("asymmetry_deg", task.asymmetry_deg, 0.0, 180.0, Text("0 to 180 degrees"));
}

const std::vector<WorkTask>& workTaskPresets() {
  static const std::vector<WorkTask> presets = makePresets();
  return presets;
}

std::optional<int> rulaForce(const WorkTask& task, std::optional<double> load_kg) {
  if (task.has_shock.value_or(false)) return 3;
  if (!load_kg) return std::nullopt;
  if (*load_kg < 2.0) return 0;
  if (!task.is_static && !task.repetitions_per_min) return std::nullopt;
  const int once = *load_kg > 10.0 ? 2 : 1;
  return isRepeatedOrStatic(task) ? once + 1 : once;
}

std::optional<int> rulaMuscleUse(const WorkTask& task) {
  if (isRepeatedOrStatic(task)) return 1;
  if (!task.is_static || !task.repetitions_per_min) return std::nullopt;
  return 0;
}

std::optional<int> rebaLoad(const WorkTask& task) {
  const auto load = task.totalLoad();
  if (!load) return std::nullopt;
  const int level = (*load < 5.0 ? 0 : 1) + (*load <= 10.0 ? 0 : 1);
  return level + (task.has_shock.value_or(false) ? 1 : 0);
}

std::optional<int> rebaCoupling(const WorkTask& task) {
  if (!task.grip) return std::nullopt;
  return static_cast<int>(*task.grip);
}

std::optional<int> rebaActivity(const WorkTask& task) {
  if (!task.is_static || !task.repetitions_per_min) return std::nullopt;
  return (*task.is_static ? 1 : 0) + (*task.repetitions_per_min > kRepeated ? 1 : 0) +
         (task.has_rapid_changes.value_or(false) ? 1 : 0);
}

}  // namespace hapticell::ergonomics
