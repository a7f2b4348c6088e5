// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace hapticell::ergonomics {

/// The postures of the EAWS worksheet's posture section.
enum class EawsPosture {
  kStandAndWalkAlternating,
  kStandNoSupport,
  kStandBentForward,
  kStandBentFar,
  kStandElbowAtShoulder,
  kStandHandsAboveHead,
  kSitBackSupport,
  kSitUpright,
  kSitBentForward,
  kSitElbowAtShoulder,
  kSitHandsAboveHead,
  kKneelUpright,
  kKneelBentForward,
  kLie,
  kClimb,
  kCount,
};

inline constexpr std::size_t kEawsPostureCount = static_cast<std::size_t>(EawsPosture::kCount);

std::string_view nameOf(EawsPosture posture);

/// An outline of the posture section of EAWS 1.3.6: points for the share of the cycle (0 to 1) spent in each posture,
/// linear between the worksheet's columns (5 % to 83 %, its last column beyond). Forces, loads and the upper limbs
/// have sections of their own that are not covered, and line 14 (kneeling, arms up) is left out because its printed
/// values are disputed: no complete EAWS score.
double eawsPosturePoints(const std::array<double, kEawsPostureCount>& shares);

/// 1 green (up to 25 points), 2 yellow (to 50), 3 red.
int eawsLevel(double points);

}  // namespace hapticell::ergonomics
