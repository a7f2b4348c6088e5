// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/ergonomics/methods/niosh.h"
#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/scored_method.h"

namespace hapticell::cli {

/// The text of `--input`: JSON in place (begins with a brace), the name of a file, or "-" for standard input.
Expected<nlohmann::json> readErgonomicsInput(const std::string& input);

/// A value as in messages: its JSON, cut to 60 bytes.
std::string shortText(const nlohmann::json& value);

/// Input of a method that is scored from sub-scores: these, and the angles that they were computed from, if angles were
/// given. Errors name fields that are unknown, of the wrong kind or outside their range.
struct ScoredInput {
  std::vector<std::optional<int>> values{};  ///< One for each of the method's sub-scores.
  std::optional<ergonomics::PostureAngles> angles{};
  std::vector<std::string> assumptions{};
  std::vector<std::string> missing{};  ///< Modifiers that were not given with the angles, assumed to be absent.
};

Expected<ScoredInput> rulaInput(const nlohmann::json& input);
Expected<ScoredInput> rebaInput(const nlohmann::json& input);
Expected<ScoredInput> owasInput(const nlohmann::json& input);

/// One lifting task, or several under "tasks", with conditions as flags.
struct LiftingInput {
  std::vector<ergonomics::LiftingTask> tasks{};
  ergonomics::LiftingConditions conditions{};
  bool is_composite = false;
};
Expected<LiftingInput> liftingInput(const nlohmann::json& input);

/// Computes sub-scores from angles, for RULA and REBA; `missing` gets the modifiers that were not given.
std::vector<std::optional<int>> rulaValuesOf(const ergonomics::PostureAngles& angles,
                                             std::vector<std::string_view>& missing);
std::vector<std::optional<int>> rebaValuesOf(const ergonomics::PostureAngles& angles,
                                             std::vector<std::string_view>& missing);

}  // namespace hapticell::cli
