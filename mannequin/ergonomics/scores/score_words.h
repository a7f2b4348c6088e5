// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/text.h"
#include "mannequin/ergonomics/scores/posture_scores.h"

namespace hapticell::ergonomics {

enum class Language { kEnglish, kFrench };

/// "en", "fr".
std::string_view codeOf(Language language);
/// The language of a code such as "fr" or "fr_FR"; English for any other.
Language languageOf(std::string_view code);

/// The words of scores and reports in a language; English is the key, and texts without a translation stay English. The
/// translations are those of app/translations, context Ergonomics.
std::string word(std::string_view english, Language language);
/// The same with the placeholders %1, %2, ... filled: phrase("%1: %2", {"trunk", "bent"}, language).
std::string phrase(std::string_view form, const std::vector<std::string>& values, Language language);

/// The sub-score whose reduction to its least lowers RULA most (of equal ones the worst in its range), in words.
struct MainDriver {
  Rula::Index index = Rula::kUpperArm;
  std::string part;    ///< "right upper arm"
  std::string reason;  ///< "97°, raised"
  int score = 0;       ///< RULA with that one at its least.
};
MainDriver mainDriver(const PostureScores& scores, Language language);

/// The observation behind a RULA or REBA sub-score: "97°, raised".
std::string rulaReason(const SideScores& scores, Rula::Index index, Language language);
std::string rulaPart(Rula::Index index, mannequin::Side side, Language language);
std::string rebaReason(const SideScores& scores, Reba::Index index, Language language);
std::string rebaPart(Reba::Index index, mannequin::Side side, Language language);

/// The action of a level, in two or three words: "Change soon".
std::string rulaAdvice(int score, Language language);
std::string rebaAdvice(int score, Language language);
std::string owasAdvice(int category, Language language);

/// "The right upper arm scores 5: 97°, raised."
std::string whySentence(const PostureScores& scores, Language language);

/// The assumptions: boundaries, thresholds, values that were not entered.
std::vector<std::string> assumptionsOf(const PostureScores& scores, const WorkTask& task, Language language);

/// The rule that is printed in each report (docs/user/ergonomics.md).
inline constexpr const char* kBoundaryRule = HAPTICELL_TRANSLATED(
    "Boundaries: an inner boundary belongs to the lower class; the last class of RULA includes its boundary.");

}  // namespace hapticell::ergonomics
