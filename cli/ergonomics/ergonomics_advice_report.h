// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/scores/hand_force.h"
#include "mannequin/ergonomics/advice/lifting_advice.h"
#include "mannequin/ergonomics/advice/method_advice.h"

namespace hapticell::cli {

// What drives a score and what would bring it down, as in the results of `ergonomics`.

/// `posture_drivers` (of EN 1005-4 and ISO 11226 `drivers`: the worst parts) and `nearest_better_posture` into
/// `report`.
void addAdvice(const ergonomics::MethodAdvice& advice, nlohmann::ordered_json& report);

/// `drivers` (multipliers below 1) and `next_level` of a lift into `report`.
void addAdvice(const ergonomics::LiftingAdvice& advice, nlohmann::ordered_json& report);

/// `{input, from, to}`; a flag's are true and false.
nlohmann::ordered_json toJson(const ergonomics::FieldChange& change);

/// `{input, from, to, lifting_index}`.
nlohmann::ordered_json toJson(const ergonomics::LiftingChange& change);

/// By the method's name: shift, score and level, or null.
nlohmann::ordered_json toJson(const ergonomics::BetterPlaces& places);

/// Of the lines of the EAWS posture section, for shares of the cycle: `drivers` and `next_level`.
void addEawsAdvice(const std::array<double, ergonomics::kEawsPostureCount>& shares, nlohmann::ordered_json& report);

nlohmann::ordered_json handForcesReport(const ergonomics::HandForces& forces);

}  // namespace hapticell::cli
