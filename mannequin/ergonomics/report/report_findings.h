// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mannequin/ergonomics/report/report.h"
#include "mannequin/ergonomics/scores/score_words.h"

namespace hapticell::ergonomics {

/// The entities that a workplace search was allowed to move, and the best place found.
struct WorkplaceFinding {
  std::vector<std::string> moves{};  ///< Names; nothing else was moved.
  bool is_found = false;
  double rise = 0.0, away = 0.0;  ///< m, up and away from the mannequin.
  bool is_seated = false;
  std::array<int, 4> rula{};  ///< P5F, P50F, P50M, P95M at that place.
};

/// A stretch of a recorded motion during which the score is at its highest.
struct MotionPhase {
  std::string motion{};                         ///< Its name.
  double from_s = 0.0, to_s = 0.0, at_s = 0.0;  ///< s from the motion's beginning; `at_s`: the frame that is shown.
  int rula = 0;
};

/// A number formatted as by printf, at most 60 characters.
std::string numberWords(const char* form, double value);

/// "Worst phase: 1.20 s to 2.40 s (1.20 s), RULA 7; shown at 1.80 s", the last part only with `with_frame`.
std::string phaseWords(const MotionPhase& phase, bool with_frame, Language language);

/// The moved parts, the place, and the score of each body there.
ReportBlock workplaceBlock(const WorkplaceFinding& found, Language language);

}  // namespace hapticell::ergonomics
