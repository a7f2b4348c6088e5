// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mannequin/ergonomics/scores/posture_scores.h"

namespace hapticell::ergonomics {

/// The methods that assign a level to a posture, and can therefore suggest how to lower it.
enum class PostureMethod { kRula, kReba, kOwas, kEn1005, kIso11226, kEaws };
inline constexpr std::array kPostureMethods{PostureMethod::kRula,   PostureMethod::kReba,     PostureMethod::kOwas,
                                            PostureMethod::kEn1005, PostureMethod::kIso11226, PostureMethod::kEaws};

/// "RULA", "EN 1005-4", ...
std::string_view nameOf(PostureMethod method);

/// The result of a method as two numbers that increase with the load.
struct MethodScore {
  /// RULA, REBA, OWAS's category; EN 1005-4 and ISO 11226: 1 acceptable, 2 conditionally, 3 not; EAWS: points of the
  /// posture held all the time.
  double score = 0.0;
  int level = 0;  ///< REBA from 0, the others from 1 on.
};
MethodScore scoreBy(const PostureScores& scores, PostureMethod method);
MethodScore scoreBy(const PostureScores& scores, PostureMethod method, mannequin::Side side);

/// The arm's side with the higher score by a method; if equal, that of PostureScores::worseSide().
mannequin::Side worseSide(const PostureScores& scores, PostureMethod method);

/// The least level of a method.
int leastLevel(PostureMethod method);

/// 1 acceptable, 2 conditionally, 3 not.
int levelOf(Zone zone);
/// The reverse.
Zone zoneOfLevel(double level);

}  // namespace hapticell::ergonomics
