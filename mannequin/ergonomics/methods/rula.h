// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/scored_method.h"

namespace hapticell::ergonomics {

/// RULA (McAtamney & Corlett, "RULA: a survey method for the investigation of work-related upper limb disorders",
/// Applied Ergonomics 24(2), 1993). Final score 1 to 7, action level 1 to 4.
class Rula final : public ScoredMethod {
 public:
  enum Index : std::size_t {
    kUpperArm,
    kLowerArm,
    kWrist,
    kWristTwist,
    kNeck,
    kTrunk,
    kLegs,
    kMuscleUseArm,
    kForceArm,
    kMuscleUseBody,
    kForceBody,
    kCount
  };
  using Values = std::array<std::optional<int>, kCount>;

  std::string_view name() const override { return "RULA"; }
  std::string_view source() const override;
  std::span<const SubScore> subScores() const override;
  int score(std::span<const int> values) const override;
  Evaluation evaluate(std::span<const int> values) const override;
  int levelOf(int score) const override;
  std::string_view levelName(int level) const override;
};

/// Posture sub-scores of one side; muscle use and force stay empty, because angles do not show them. Boundaries: an
/// inner boundary belongs to the lower class, the last class includes its boundary ("or more"). A sub-score without an
/// angle is empty. `unknown` receives the names of modifiers that were not given and were taken as absent.
Rula::Values rulaValues(const PostureAngles& angles, std::vector<std::string_view>& unknown);

}  // namespace hapticell::ergonomics
