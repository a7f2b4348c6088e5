// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mannequin/ergonomics/report/report.h"
#include "mannequin/ergonomics/scores/score_words.h"

namespace hapticell::ergonomics {

/// What a search for the workplace was allowed to move, and where it found the best place.
struct WorkplaceFinding {
  std::vector<std::string> moves{};  ///< Names; nothing else was moved.
  bool is_found = false;
  double rise = 0.0, away = 0.0;  ///< m, up and away from the mannequin.
  bool is_seated = false;
  std::array<int, 4> rula{};  ///< P5F, P50F, P50M, P95M at that place.
};

/// A stretch of a recorded motion in which the score stays at its highest.
struct MotionPhase {
  std::string motion{};                         ///< Its name.
  double from_s = 0.0, to_s = 0.0, at_s = 0.0;  ///< s from the motion's beginning; `at_s`: the frame that is shown.
  int rula = 0;
};

/// A number in printf's form, of up to 60 letters.
std::string numberWords(const char* form, double value);

/// "Worst phase: 1.20 s to 2.40 s (1.20 s), RULA 7; shown at 1.80 s", the last with `with_frame`.
std::string phaseWords(const MotionPhase& phase, bool with_frame, Language language);

/// The parts that moved, the place, and each body's score there.
ReportBlock workplaceBlock(const WorkplaceFinding& found, Language language);

}  // namespace hapticell::ergonomics
