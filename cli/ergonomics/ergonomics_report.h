// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "cli/ergonomics/ergonomics_input.h"
#include "mannequin/ergonomics/advice/motion_scores.h"
#include "mannequin/ergonomics/methods/niosh.h"
#include "mannequin/ergonomics/methods/scored_method.h"

namespace hapticell::cli {

/// The result of one posture: score, level, sub-scores, table entries, drivers, next level, assumptions.
nlohmann::ordered_json scoredReport(const ergonomics::ScoredMethod& method, const ScoredInput& input);

/// Scores frame by frame, shares of time, the worst frame, assumptions.
nlohmann::ordered_json motionReport(ergonomics::MotionMethod method, const ergonomics::MotionScores& scores,
                                    const ergonomics::MotionTask& task);

nlohmann::ordered_json liftingReport(const ergonomics::LiftingTask& task, const ergonomics::LiftingResult& result);
nlohmann::ordered_json compositeReport(const LiftingInput& input, const ergonomics::CompositeLifting& result);

}  // namespace hapticell::cli
