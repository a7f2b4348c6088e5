// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/advice/lifting_advice.h"
#include "mannequin/ergonomics/advice/method_advice.h"
#include "mannequin/ergonomics/scores/score_words.h"

namespace hapticell::ergonomics {

/// "RULA 4", "REBA 8, high", "OWAS 2, soon", "EN 1005-4: conditionally acceptable", "EAWS 13 points".
std::string scoreWords(PostureMethod method, const MethodScore& score, Language language);

/// "trunk forward 65° to 20°", "shoulder raised: no".
std::string changeWords(const FieldChange& change, Language language);

/// The first `most` drivers with the resulting action level: "trunk forward 65° to 60° (conditionally acceptable)".
/// Empty without drivers.
std::string driverWords(const MethodAdvice& advice, Language language, std::size_t most = 3);

/// "trunk forward 65° to 60°, shoulder raised: no gives RULA 4"; says so if no change of posture alone helps; empty at
/// the least level.
std::string nextLevelWords(const MethodAdvice& advice, Language language);

/// "70 mm lower: RULA 4". `posture` defines the forward direction.
std::string placeWords(const BetterPlace& place, const mannequin::Posture& posture, PostureMethod method,
                       Language language);

/// "HM 0.63, VM 0.87": the multipliers below 1.
std::string liftingDriverWords(const LiftingAdvice& advice);

/// "hands at 42 cm to 30.5 cm, or load 12 kg to 9.1 kg: index at most 1".
std::string liftingNextWords(const LiftingAdvice& advice, Language language);

}  // namespace hapticell::ergonomics
