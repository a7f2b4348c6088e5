// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/report/report.h"
#include "mannequin/ergonomics/report/report_findings.h"
#include "mannequin/ergonomics/scores/force_table.h"
#include "mannequin/ergonomics/scores/score_words.h"

namespace hapticell::ergonomics {

/// The content of a report of a posture.
struct PostureReportInput {
  std::string subtitle;  ///< Cell and mannequin.
  std::string date;      ///< As printed; reports do not read a clock.
  std::string source;    ///< The file of the posture; empty: the present posture in the cell.
  Language language = Language::kEnglish;
  mannequin::Figure figure;
  mannequin::Posture posture;
  WorkTask task;
  std::vector<BodyAtTask> bodies{};           ///< Other bodies at the same task; empty: not shown.
  std::vector<ReportBlock::Strip> history{};  ///< Along a recorded motion.
  double history_seconds = 0.0;
  BetterPlaces places{};    ///< Placements of the work that would lower each method's level.
  ReportPicture scene{};    ///< The figure in its cell.
  ForceTable own_limits{};  ///< Of the hands, from the user's own source.
  std::optional<WorkplaceFinding> workplace{};
  std::optional<MotionPhase> phase{};  ///< The worst of the recorded motion.
  bool is_of_phase = false;            ///< The posture is that of the phase, not the figure's present one.
  std::string company{};               ///< In the head.
  ReportPicture logo{};                ///< Beside it.
};

/// The posture's page: picture, body, task, result, four bodies, drivers, sub-scores, zones, assumptions, joint angles.
Report postureReport(const PostureReportInput& input);

/// The page of the task: its data, exposure over the recorded motion, bodies, lifting, missing inputs.
Report taskReport(const PostureReportInput& input);

/// The picture of a figure with its segments in the colours of a method.
std::vector<ReportShape> reportPicture(const mannequin::Figure& figure, const mannequin::Posture& posture,
                                       const PostureScores& scores, ColourMethod method);

/// Strips of bands from scores over time.
ReportBlock::Strip stripOf(const std::string& name, const std::vector<int>& bands);

}  // namespace hapticell::ergonomics
