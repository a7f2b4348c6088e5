// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/eaws.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/text.h"

namespace hapticell::ergonomics {
namespace {

constexpr double kTrunkBent = 20.0, kTrunkBentFar = 60.0;  ///< Degrees of the trunk.
constexpr std::size_t kColumns = 10;
constexpr std::array<double, kColumns> kShares{0.05, 0.075, 0.10, 0.15, 0.20, 0.27, 0.33, 0.50, 0.67, 0.83};

struct Line {
  std::string_view name;
  std::array<double, kColumns> points;
};

constexpr std::array<Line, kEawsPostureCount> kLines{{
    {HAPTICELL_TRANSLATED("standing and walking in turn"), {0, 0, 0, 0, 0.5, 1, 1, 1, 1.5, 2}},
    {HAPTICELL_TRANSLATED("standing without support"), {0.7, 1, 1.5, 2, 3, 4, 6, 8, 11, 13}},
    {HAPTICELL_TRANSLATED("standing, bent forward 20 to 60 deg"), {2, 3, 5, 7, 9.5, 12, 18, 23, 32, 40}},
    {HAPTICELL_TRANSLATED("standing, bent forward over 60 deg"), {3.3, 5, 8.5, 12, 17, 21, 30, 38, 51, 63}},
    {HAPTICELL_TRANSLATED("standing, elbow at or above shoulder"), {3.3, 5, 8.5, 12, 17, 21, 30, 38, 51, 63}},
    {HAPTICELL_TRANSLATED("standing, hands above head"), {5.3, 8, 14, 19, 26, 33, 47, 60, 80, 100}},
    {HAPTICELL_TRANSLATED("sitting with back support"), {0, 0, 0, 0, 0, 0, 0.5, 1, 1.5, 2}},
    {HAPTICELL_TRANSLATED("sitting upright"), {0, 0, 0.5, 1, 1.5, 2, 3, 4, 5.5, 7}},
    {HAPTICELL_TRANSLATED("sitting, bent forward"), {0.7, 1, 1.5, 2, 3, 4, 6, 8, 11, 13}},
    {HAPTICELL_TRANSLATED("sitting, elbow at or above shoulder"), {2.7, 4, 7, 10, 13, 16, 23, 30, 40, 50}},
    {HAPTICELL_TRANSLATED("sitting, hands above head"), {4, 6, 10, 14, 20, 25, 35, 45, 60, 75}},
    {HAPTICELL_TRANSLATED("kneeling or crouching upright"), {3.3, 5, 7, 9, 12, 15, 21, 27, 36, 45}},
    {HAPTICELL_TRANSLATED("kneeling or crouching, bent forward"), {4, 6, 10, 14, 20, 25, 35, 45, 60, 75}},
    {HAPTICELL_TRANSLATED("lying"), {6, 9, 15, 21, 29, 37, 53, 68, 91, 113}},
    {HAPTICELL_TRANSLATED("climbing"), {6.7, 10, 22, 33, 50, 66, 66, 66, 66, 66}},
}};

double pointsOf(const Line& line, double share) {
  if (share <= 0.0) return 0.0;
  if (share <= kShares.front()) return line.points.front() * share / kShares.front();
  if (share >= kShares.back()) return line.points.back();
  const auto after = std::upper_bound(kShares.begin(), kShares.end(), share);
  const auto i = static_cast<std::size_t>(after - kShares.begin());
  const double part = (share - kShares[i - 1]) / (kShares[i] - kShares[i - 1]);
  return line.points[i - 1] + part * (line.points[i] - line.points[i - 1]);
}

using Shares = std::array<double, kEawsPostureCount>;

/// With `share` of a posture spent in the easiest one of its kind.
Shares shifted(Shares shares, EawsPosture from, double share) {
  shares[static_cast<std::size_t>(from)] -= share;
  shares[static_cast<std::size_t>(easiestOfKind(from))] += share;
  return shares;
}

}  // namespace

std::string_view nameOf(EawsPosture posture) {
  return kLines[static_cast<std::size_t>(posture)].name;
}

EawsPosture eawsPosture(const EawsObservation& observed) {
  const double trunk = std::abs(observed.trunk_flexion);
  if (observed.kneeling) return trunk > kTrunkBent ? EawsPosture::kKneelBentForward : EawsPosture::kKneelUpright;
  if (observed.seated) {
    if (observed.hands_above_head) return EawsPosture::kSitHandsAboveHead;
    if (observed.elbow_at_shoulder) return EawsPosture::kSitElbowAtShoulder;
    if (trunk > kTrunkBent) return EawsPosture::kSitBentForward;
    return observed.trunk_supported ? EawsPosture::kSitBackSupport : EawsPosture::kSitUpright;
  }
  if (observed.hands_above_head) return EawsPosture::kStandHandsAboveHead;
  if (observed.elbow_at_shoulder) return EawsPosture::kStandElbowAtShoulder;
  if (trunk > kTrunkBentFar) return EawsPosture::kStandBentFar;
  if (trunk > kTrunkBent) return EawsPosture::kStandBentForward;
  return observed.walking ? EawsPosture::kStandAndWalkAlternating : EawsPosture::kStandNoSupport;
}

EawsPosture easiestOfKind(EawsPosture posture) {
  switch (posture) {
    case EawsPosture::kStandNoSupport:
    case EawsPosture::kStandBentForward:
    case EawsPosture::kStandBentFar:
    case EawsPosture::kStandElbowAtShoulder:
    case EawsPosture::kStandHandsAboveHead:
      return EawsPosture::kStandAndWalkAlternating;
    case EawsPosture::kSitUpright:
    case EawsPosture::kSitBentForward:
    case EawsPosture::kSitElbowAtShoulder:
    case EawsPosture::kSitHandsAboveHead:
      return EawsPosture::kSitBackSupport;
    case EawsPosture::kKneelBentForward:
      return EawsPosture::kKneelUpright;
    default:
      return posture;
  }
}

double eawsPosturePoints(const std::array<double, kEawsPostureCount>& shares) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kEawsPostureCount; ++i) sum += pointsOf(kLines[i], shares[i]);
  return sum;
}

std::vector<EawsDriver> eawsDrivers(const std::array<double, kEawsPostureCount>& shares) {
  std::vector<EawsDriver> drivers;
  for (std::size_t i = 0; i < kEawsPostureCount; ++i) {
    const double points = pointsOf(kLines[i], shares[i]);
    if (points <= 0.0) continue;
    const auto posture = static_cast<EawsPosture>(i);
    drivers.push_back({posture, shares[i], points, eawsPosturePoints(shifted(shares, posture, shares[i]))});
  }
  std::stable_sort(drivers.begin(), drivers.end(),
                   [](const EawsDriver& a, const EawsDriver& b) { return a.points > b.points; });
  return drivers;
}

std::vector<EawsShift> eawsNextLevel(const std::array<double, kEawsPostureCount>& shares) {
  const int level = eawsLevel(eawsPosturePoints(shares));
  std::vector<EawsShift> shifts;
  Shares now = shares;
  for (const EawsDriver& driver : eawsDrivers(shares)) {
    const EawsPosture to = easiestOfKind(driver.posture);
    if (level == 1 || to == driver.posture) continue;
    const auto levelAt = [&](double share) {
      return eawsLevel(eawsPosturePoints(shifted(now, driver.posture, share)));
    };
    double enough = driver.share, little = 0.0;
    const bool is_enough = levelAt(enough) < level;
    for (int i = 0; is_enough && i < 40; ++i) {
      const double middle = 0.5 * (enough + little);
      (levelAt(middle) < level ? enough : little) = middle;
    }
    enough = std::min(driver.share, std::ceil(1000.0 * enough - 1e-6) / 1000.0);
    now = shifted(now, driver.posture, enough);
    shifts.push_back({driver.posture, to, enough, eawsPosturePoints(now)});
    if (is_enough) return shifts;
  }
  return {};
}

int eawsLevel(double points) {
  if (points <= 25.0) return 1;
  return points <= 50.0 ? 2 : 3;
}

}  // namespace hapticell::ergonomics
