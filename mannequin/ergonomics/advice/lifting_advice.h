// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/methods/niosh.h"

namespace hapticell::ergonomics {

/// 1: index up to 1, acceptable for nearly all; 2: up to 3, raised risk for some; 3: above, or no load is acceptable
/// (the manual's own bounds, section 1.5).
int liftingLevel(const std::optional<double>& index);
std::string_view liftingLevelName(int level);

/// A multiplier below 1, and the index of a single task if it were 1.
struct LiftingDriver {
  std::string_view field;       ///< "h_cm", "v_cm", "d_cm", "asymmetry_deg", "frequency_per_min", "coupling".
  std::string_view multiplier;  ///< "HM" ...
  double value = 0.0;
  std::optional<double> index{};  ///< Empty if a multiplier is 0, or for several tasks.
};

/// A change of one input of the lift. Coupling: 0 good, 1 fair, 2 poor.
struct LiftingChange {
  std::string_view field;
  double from = 0.0;
  double to = 0.0;
  std::optional<double> index{};  ///< With it (and those before it in a list of changes made together).
};

/// The reasons for a lifting index, and the changes that bring it to the next lower level.
struct LiftingAdvice {
  int level = 1;
  double target = 1.0;                   ///< The index to reach: 1 or 3.
  std::vector<LiftingDriver> drivers{};  ///< The multiplier with the greatest effect first.
  std::vector<LiftingChange> alone{};    ///< For each input, the smallest change that suffices alone.
  /// If only the load alone, or no single input, suffices: these changes, made together in this order.
  std::vector<LiftingChange> together{};
};

/// The index of a task; empty if its limit is 0.
using LiftingIndex = std::function<std::optional<double>(const LiftingTask&)>;

/// Changes of the inputs of one task. `index_of` computes the index of the changed task (alone, or composite with
/// others); `result` is that of the unchanged task.
LiftingAdvice adviseLift(const LiftingTask& task, const LiftingResult& result, const LiftingIndex& index_of);
/// For a single task.
LiftingAdvice adviseLift(const LiftingTask& task, const LiftingResult& result);

}  // namespace hapticell::ergonomics
