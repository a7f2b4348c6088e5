// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::ergonomics {

enum class Coupling { kGood, kFair, kPoor };

/// Data of one lifting task for the worksheet of the revised NIOSH equation.
struct LiftingTask {
  double load_kg = 0.0;
  double h_cm = 25.0;  ///< Horizontal distance of the hands from the middle of the ankles.
  double v_cm = 75.0;  ///< Hands above the floor, at the start of the lift.
  double d_cm = 25.0;  ///< Height the load is lifted or lowered by.
  double asymmetry_deg = 0.0;
  double frequency_per_min = 0.2;
  double duration_h = 1.0;
  Coupling coupling = Coupling::kGood;
};

/// Conditions outside the validity of the equation; the equation is then not applied.
struct LiftingConditions {
  bool one_handed = false;
  bool seated_or_kneeling = false;
  bool restricted_space = false;
  bool unstable_load = false;
  bool pushing_pulling_or_carrying = false;
  bool fast = false;  ///< Faster than about 0.75 m/s.
  bool hot_or_cold = false;
  bool slippery_floor = false;
};

/// Multipliers (0 to 1) and the resulting part of 23 kg.
struct LiftingResult {
  double hm = 0.0, vm = 0.0, dm = 0.0, am = 0.0, fm = 0.0, cm = 0.0;
  double recommended_weight_limit_kg = 0.0;
  double frequency_independent_limit_kg = 0.0;  ///< With FM = 1.
  std::optional<double> lifting_index;          ///< Empty if the limit is 0: no load is acceptable.
  std::optional<double> frequency_independent_index;
  std::vector<std::string> assumptions{};
};

/// Refuses the first value outside its range, by name.
Expected<void> checkLiftingRanges(const LiftingTask& task);

/// The revised NIOSH lifting equation (Waters, Putz-Anderson & Garg, "Applications manual for the revised NIOSH
/// lifting equation", DHHS 94-110, rev. 9/2021), metric; the formulas govern over its rounded tables. A value outside
/// its range, or conditions outside the validity, are refused by name.
Expected<LiftingResult> lift(const LiftingTask& task, const LiftingConditions& conditions = {});

/// Several tasks of one shift done in turn: the composite lifting index of the manual, section 1.3.
struct CompositeLifting {
  double index = 0.0;
  std::vector<std::size_t> order{};  ///< Tasks by decreasing single-task index.
  std::vector<LiftingResult> tasks{};
};
Expected<CompositeLifting> compositeLift(std::span<const LiftingTask> tasks, const LiftingConditions& conditions = {});

/// Frequency multiplier, linear between the rows of the manual's table 5. Below 0.2/min as at 0.2; above 15/min 0.
double frequencyMultiplier(double frequency_per_min, double duration_h, double v_cm);

}  // namespace hapticell::ergonomics
