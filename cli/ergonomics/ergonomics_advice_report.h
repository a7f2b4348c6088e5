// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/scores/hand_force.h"
#include "mannequin/ergonomics/advice/lifting_advice.h"
#include "mannequin/ergonomics/advice/method_advice.h"

namespace hapticell::cli {

// The main drivers of a score and changes that lower it, as in the results of `ergonomics`.

/// Adds `posture_drivers` (for EN 1005-4 and ISO 11226 `drivers`: the worst parts) and `nearest_better_posture` to
/// `report`.
void addAdvice(const ergonomics::MethodAdvice& advice, nlohmann::ordered_json& report);

/// Adds `drivers` (multipliers below 1) and `next_level` of a lift to `report`.
void addAdvice(const ergonomics::LiftingAdvice& advice, nlohmann::ordered_json& report);

/// `{input, from, to}`; for a flag, `from` and `to` are true or false.
nlohmann::ordered_json toJson(const ergonomics::FieldChange& change);

/// `{input, from, to, lifting_index}`.
nlohmann::ordered_json toJson(const ergonomics::LiftingChange& change);

/// By the method's name: shift, score and level, or null.
nlohmann::ordered_json toJson(const ergonomics::BetterPlaces& places);

/// For the lines of the EAWS posture section, with shares of the cycle: `drivers` and `next_level`.
void addEawsAdvice(const std::array<double, ergonomics::kEawsPostureCount>& shares, nlohmann::ordered_json& report);

nlohmann::ordered_json handForcesReport(const ergonomics::HandForces& forces);

}  // namespace hapticell::cli
