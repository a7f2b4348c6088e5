// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mannequin/ergonomics/scores/posture_scores.h"

namespace hapticell::ergonomics {

enum class Language { kEnglish, kFrench };

/// The words of scores and reports in a language; English is the key, and what has no translation stays English.
std::string word(std::string_view english, Language language);

/// The sub-score whose fall to its least lowers RULA most (of equal ones the worst in its range), in words.
struct MainDriver {
  Rula::Index index = Rula::kUpperArm;
  std::string part;    ///< "right upper arm"
  std::string reason;  ///< "97°, raised"
  int score = 0;       ///< RULA with that one at its least.
};
MainDriver mainDriver(const PostureScores& scores, Language language);

/// What a RULA or REBA sub-score is and why: "97°, raised".
std::string rulaReason(const SideScores& scores, Rula::Index index, Language language);
std::string rulaPart(Rula::Index index, mannequin::Side side, Language language);
std::string rebaReason(const SideScores& scores, Reba::Index index, Language language);
std::string rebaPart(Reba::Index index, mannequin::Side side, Language language);

/// What an action level asks for, in two or three words: "Change soon".
std::string rulaAdvice(int score, Language language);
std::string rebaAdvice(int score, Language language);
std::string owasAdvice(int category, Language language);

/// "The right upper arm scores 5: 97°, raised."
std::string whySentence(const PostureScores& scores, Language language);

/// What was taken for granted: boundaries, thresholds, what was not entered.
std::vector<std::string> assumptionsOf(const PostureScores& scores, const WorkTask& task, Language language);

/// The rule that is printed in each report (docs/user/ergonomics.md).
inline constexpr const char* kBoundaryRule =
    "Boundaries: an inner boundary belongs to the lower class; the last class of RULA includes its boundary.";

}  // namespace hapticell::ergonomics
