// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/advice/change_search.h"
#include "mannequin/ergonomics/scores/method_score.h"

namespace hapticell::ergonomics {

/// One property of the posture that drives a method's score.
struct MethodDriver {
  /// EN 1005-4 and ISO 11226: the body part that is judged; empty for the others, which judge the whole posture.
  std::string_view part{};
  std::vector<FieldChange> changes{};  ///< One change, or two that lower their part only together.
  double score = 0.0;                  ///< With this change alone; for a part its zone, 1 to 3.
  int level = 0;                       ///< Of the whole posture, with this change alone.
};

/// The reasons for a posture's score by a method, and the nearest posture of the next lower level.
struct MethodAdvice {
  PostureMethod method = PostureMethod::kRula;
  MethodScore now;
  std::vector<MethodDriver> drivers{};  ///< The greatest effect first.
  struct Goal {
    std::vector<FieldChange> changes{};
    MethodScore score;
  };
  std::optional<Goal> next{};  ///< Empty at the least level, or if no change of posture alone helps.
};

/// For RULA and REBA from angles; `values` as in scoreOfAngles(). `method.name()` identifies the method.
MethodAdvice adviseAngles(const ScoredMethod& method, const PostureAngles& angles,
                          std::span<const std::optional<int>> values);
MethodAdvice adviseOwas(const OwasPosture& posture);
MethodAdvice adviseEaws(const EawsObservation& observed);
/// `method`: EN 1005-4 or ISO 11226.
MethodAdvice adviseZones(PostureMethod method, const ZonePosture& posture);

/// The same for a figure's posture. Takes from about 10 us (zones, OWAS, EAWS) to some ms (RULA, REBA): call when a
/// posture is at rest, not in each frame. Any thread.
MethodAdvice advise(const PostureScores& scores, PostureMethod method, mannequin::Side side, const WorkTask& task);
/// For its worse side.
MethodAdvice advise(const PostureScores& scores, PostureMethod method, const WorkTask& task);

/// Joints outside their comfort range and the nearest angle within it, degrees; largest excess first. Each one
/// corrected raises the joint comfort by 1/56.
std::vector<FieldChange> comfortDrivers(const mannequin::Posture& posture);

}  // namespace hapticell::ergonomics
