// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "mannequin/ergonomics/methods/scored_method.h"

namespace hapticell::ergonomics {

/// OWAS (Karhu, Kansi & Kuorinka, "Correcting working postures in industry", Applied Ergonomics 8(4), 1977): a code of
/// four digits (back, arms, legs, load) and its action category 1 to 4, which is both score and level.
class Owas final : public ScoredMethod {
 public:
  enum Index : std::size_t { kBack, kArms, kLegs, kLoad, kCount };
  using Values = std::array<std::optional<int>, kCount>;

  std::string_view name() const override { return "OWAS"; }
  std::string_view source() const override;
  std::span<const SubScore> subScores() const override;
  int score(std::span<const int> values) const override;
  Evaluation evaluate(std::span<const int> values) const override;
  int levelOf(int score) const override { return score; }
  std::string_view levelName(int level) const override;
  bool isOrdered() const override { return false; }

  /// The meaning of a digit, e.g. (kLegs, 4) "standing or squatting on two bent legs".
  static std::string_view meaning(Index digit, int value);
};

/// A whole posture for OWAS: both arms and both legs. Degrees; hands and elbows relative to the shoulders.
struct OwasPosture {
  double trunk_flexion = 0.0;
  double trunk_twist = 0.0;
  double trunk_side_bend = 0.0;
  int arms_at_or_above_shoulder = 0;  ///< 0 to 2.
  bool seated = false;
  bool walking = false;
  bool kneeling = false;
  bool on_one_leg = false;
  double left_knee_flexion = 0.0;
  double right_knee_flexion = 0.0;
  double load_kg = 0.0;
};

/// The digits: back bent or turned over 20 deg, knees bent over 30 deg (one of the readings in use), loads of 10 and
/// 20 kg as boundaries that belong to the lower class.
Owas::Values owasValues(const OwasPosture& posture);

}  // namespace hapticell::ergonomics
