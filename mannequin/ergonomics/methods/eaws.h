// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

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

/// The observations that select the line.
struct EawsObservation {
  double trunk_flexion = 0.0;  ///< Degrees, either way.
  bool hands_above_head = false;
  bool elbow_at_shoulder = false;  ///< Or above.
  bool seated = false;
  bool kneeling = false;
  bool walking = false;
  bool trunk_supported = false;
};

/// The line of an observed posture: bent from over 20 deg, strongly bent from over 60; raised arms take priority over a
/// bent trunk.
EawsPosture eawsPosture(const EawsObservation& observed);

/// The posture of the same kind (standing, sitting, kneeling) with the fewest points; other postures map to themselves.
EawsPosture easiestOfKind(EawsPosture posture);

/// An outline of the posture section of EAWS 1.3.6: points for the share of the cycle (0 to 1) spent in each posture,
/// linear between the worksheet's columns (5 % to 83 %, its last column beyond). Forces, loads and the upper limbs
/// have sections of their own that are not covered, and line 14 (kneeling, arms up) is left out because its printed
/// values are disputed: no complete EAWS score.
double eawsPosturePoints(const std::array<double, kEawsPostureCount>& shares);

/// The share of one line in the points, largest first; lines without points are omitted.
struct EawsDriver {
  EawsPosture posture;
  double share = 0.0;
  double points = 0.0;  ///< Of this line.
  double score = 0.0;   ///< All points if its share were spent in the easiest posture of its kind.
};
std::vector<EawsDriver> eawsDrivers(const std::array<double, kEawsPostureCount>& shares);

/// A share of the cycle moved to an easier posture of the same kind.
struct EawsShift {
  EawsPosture from, to;
  double share = 0.0;  ///< Moved, rounded up to a thousandth.
  double score = 0.0;  ///< All points with this shift and those before it.
};
/// The changes that lower the level: the lines in the order of eawsDrivers(), each completely except the last, which is
/// shifted only as much as needed. Empty at the least level, or if no shift within the kinds suffices.
std::vector<EawsShift> eawsNextLevel(const std::array<double, kEawsPostureCount>& shares);

/// 1 green (up to 25 points), 2 yellow (to 50), 3 red.
int eawsLevel(double points);

}  // namespace hapticell::ergonomics
