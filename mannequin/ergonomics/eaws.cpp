// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/eaws.h"

#include <algorithm>

namespace hapticell::ergonomics {
namespace {

constexpr std::size_t kColumns = 10;
constexpr std::array<double, kColumns> kShares{0.05, 0.075, 0.10, 0.15, 0.20, 0.27, 0.33, 0.50, 0.67, 0.83};

struct Line {
  std::string_view name;
  std::array<double, kColumns> points;
};

constexpr std::array<Line, kEawsPostureCount> kLines{{
    {"standing and walking in turn", {0, 0, 0, 0, 0.5, 1, 1, 1, 1.5, 2}},
    {"standing without support", {0.7, 1, 1.5, 2, 3, 4, 6, 8, 11, 13}},
    {"standing, bent forward 20 to 60 deg", {2, 3, 5, 7, 9.5, 12, 18, 23, 32, 40}},
    {"standing, bent forward over 60 deg", {3.3, 5, 8.5, 12, 17, 21, 30, 38, 51, 63}},
    {"standing, elbow at or above shoulder", {3.3, 5, 8.5, 12, 17, 21, 30, 38, 51, 63}},
    {"standing, hands above head", {5.3, 8, 14, 19, 26, 33, 47, 60, 80, 100}},
    {"sitting with back support", {0, 0, 0, 0, 0, 0, 0.5, 1, 1.5, 2}},
    {"sitting upright", {0, 0, 0.5, 1, 1.5, 2, 3, 4, 5.5, 7}},
    {"sitting, bent forward", {0.7, 1, 1.5, 2, 3, 4, 6, 8, 11, 13}},
    {"sitting, elbow at or above shoulder", {2.7, 4, 7, 10, 13, 16, 23, 30, 40, 50}},
    {"sitting, hands above head", {4, 6, 10, 14, 20, 25, 35, 45, 60, 75}},
    {"kneeling or crouching upright", {3.3, 5, 7, 9, 12, 15, 21, 27, 36, 45}},
    {"kneeling or crouching, bent forward", {4, 6, 10, 14, 20, 25, 35, 45, 60, 75}},
    {"lying", {6, 9, 15, 21, 29, 37, 53, 68, 91, 113}},
    {"climbing", {6.7, 10, 22, 33, 50, 66, 66, 66, 66, 66}},
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

}  // namespace

std::string_view nameOf(EawsPosture posture) {
  return kLines[static_cast<std::size_t>(posture)].name;
}

double eawsPosturePoints(const std::array<double, kEawsPostureCount>& shares) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kEawsPostureCount; ++i) sum += pointsOf(kLines[i], shares[i]);
  return sum;
}

int eawsLevel(double points) {
  return points <= 25.0 ? 1 : points <= 50.0 ? 2 : 3;
}

}  // namespace hapticell::ergonomics
