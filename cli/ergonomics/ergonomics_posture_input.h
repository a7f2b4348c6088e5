// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "geometry/system/error.h"
#include "studies/workplace/workplace_search.h"
#include "mannequin/ergonomics/report/posture_report.h"

namespace hapticell::cli {

/// Reads task data as in workcell documents (docs/user/formats.md); errors name unknown fields and wrong kinds.
Expected<ergonomics::WorkTask> workTaskInput(const nlohmann::json& input);

/// EN 1005-4 ("en1005") or ISO 11226 ("iso11226") from angles in degrees: trunk_flexion, trunk_twist, trunk_side_bend,
/// upper_arm_flexion, upper_arm_abduction, gaze_below_horizontal, head_inclination, shoulder_raised_deg, and
/// movements_per_min, static, trunk_supported, arm_supported. An error names a missing value that a part needs.
Expected<nlohmann::ordered_json> zonesReport(const std::string& method, const nlohmann::json& input);

/// Shares of the cycle (0 to 1) by posture name; they must not add up to more than 1.
Expected<nlohmann::ordered_json> eawsReport(const nlohmann::json& input);

/// All scores of a posture, both sides.
nlohmann::ordered_json postureScoresReport(const ergonomics::PostureReportInput& input,
                                           const ergonomics::PostureScores& scores);
nlohmann::ordered_json liftOfPosture(const mannequin::Figure& figure, const mannequin::FigurePose& pose,
                                     const ergonomics::PostureScores& scores, const ergonomics::WorkTask& task);
/// The report of a workplace search. The best placement has its four postures, in the form of posture files.
nlohmann::ordered_json workplaceReport(const studies::WorkplaceMap& map);
/// The best placement in such a report. Error: the report has no placement, or cannot be read.
Expected<studies::WorkplaceCell> bestPlaceIn(const std::filesystem::path& file);

}  // namespace hapticell::cli
