// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::ergonomics {

/// Quality of the grip: the four classes of REBA; the lifting equation has the first three.
enum class Grip { kGood, kFair, kPoor, kUnacceptable };

/// Task data that a posture does not show, entered once for a task and stored with the workcell. Values that nobody
/// entered are empty and never scored as zero: a score that needs one is marked partial. A value.
struct WorkTask {
  std::string name = "Task";
  std::string mannequin = {};                         ///< Name of the mannequin that does it; empty: any.
  std::array<std::optional<double>, 2> load_kg = {};  ///< In the left and in the right hand, weight or force / 9.81.
  std::optional<double> repetitions_per_min = {};     ///< Repetitions of the same movement.
  std::optional<bool> is_static = {};                 ///< The posture is held for more than a minute.
  std::optional<Grip> grip = {};
  std::optional<double> duration_h = {};       ///< Duration in a shift.
  std::optional<bool> has_shock = {};          ///< Loads or forces come suddenly.
  std::optional<bool> has_rapid_changes = {};  ///< Rapid large changes of posture, or an unstable base.
  bool is_walking = false;
  bool trunk_supported = false;
  std::array<bool, 2> arm_supported = {};  ///< Left, right.
  bool is_lift = false;                    ///< The load is lifted: the lifting equation is applied.
  double lift_distance_m = 0.25;           ///< Up or down, of a lift.
  double asymmetry_deg = 0.0;              ///< Of a lift: the load beside the sagittal plane.
  std::string note = {};

  std::optional<double> totalLoad() const;  ///< kg in both hands; empty if neither is known.
  bool operator==(const WorkTask&) const = default;
};

/// Refused by name: a load outside 0 to 200 kg, more than 120 repetitions a minute, a shift over 24 h, a lift of more
/// than 2 m, an asymmetry outside 0 to 180 deg, invalid numbers.
Expected<void> checkWorkTask(const WorkTask& task);

/// Typical tasks as a starting point (our own choice): inspection, light assembly, screwing, overhead work, packing,
/// lifting.
const std::vector<WorkTask>& workTaskPresets();

/// Scores of the methods that depend only on the task; empty if an input is missing. `arm`: 0 left, 1 right.
std::optional<int> rulaForce(const WorkTask& task, std::optional<double> load_kg);
std::optional<int> rulaMuscleUse(const WorkTask& task);
std::optional<int> rebaLoad(const WorkTask& task);
std::optional<int> rebaCoupling(const WorkTask& task);
std::optional<int> rebaActivity(const WorkTask& task);

}  // namespace hapticell::ergonomics
