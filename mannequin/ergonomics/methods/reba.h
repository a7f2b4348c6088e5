// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/scored_method.h"

namespace hapticell::ergonomics {

/// REBA (Hignett & McAtamney, "Rapid Entire Body Assessment", Applied Ergonomics 31(2), 2000). Final score 1 to 15,
/// action level 0 to 4.
class Reba final : public ScoredMethod {
 public:
  enum Index : std::size_t { kNeck, kTrunk, kLegs, kUpperArm, kLowerArm, kWrist, kLoad, kCoupling, kActivity, kCount };
  using Values = std::array<std::optional<int>, kCount>;

  std::string_view name() const override { return "REBA"; }
  std::string_view source() const override;
  std::span<const SubScore> subScores() const override;
  int score(std::span<const int> values) const override;
  Evaluation evaluate(std::span<const int> values) const override;
  int levelOf(int score) const override;
  std::string_view levelName(int level) const override;
};

/// As rulaValues. Boundaries belong to the lower class throughout (20 deg is still 0 to 20).
Reba::Values rebaValues(const PostureAngles& angles, std::vector<std::string_view>& unknown);

}  // namespace hapticell::ergonomics
