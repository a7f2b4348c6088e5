// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/gauss_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace hapticell::collision {
namespace {

using Arc = std::pair<dvec3, dvec3>;

/// Each end of one on different sides of the other's great circle, on the same half of the sphere.
bool cross(const Arc& a, const Arc& b) {
  const dvec3 na = glm::cross(a.first, a.second), nb = glm::cross(b.first, b.second);
  if (glm::dot(na, b.first) * glm::dot(na, b.second) >= 0.0) return false;
  if (glm::dot(nb, a.first) * glm::dot(nb, a.second) >= 0.0) return false;
  const dvec3 p = glm::cross(na, nb);
  return glm::dot(p, a.first + a.second) * glm::dot(p, b.first + b.second) > 0.0;
}

/// `longest` is about the length of an arc in rad.
std::vector<Arc> randomArcs(int count, double longest, std::mt19937& random) {
  std::normal_distribution<double> spread;
  const auto direction = [&] { return glm::normalize(dvec3(spread(random), spread(random), spread(random))); };
  std::vector<Arc> arcs;
  for (int i = 0; i < count; ++i) {
    const dvec3 n = direction();
    arcs.emplace_back(n, glm::normalize(n + longest * direction()));
  }
  return arcs;
}

TEST(GaussGrid, FindsEveryCrossingByBruteForceAndFewOthers) {
  std::mt19937 random(7);
  for (const double longest : {0.05, 0.15, 0.5, 1.5}) {
    const std::vector<Arc> first = randomArcs(800, longest, random), second = randomArcs(800, longest, random);
    GaussGrid grid;
    for (const Arc& arc : first) grid.add(arc.first, arc.second);
    std::size_t crossings = 0, offered = 0;
    std::vector<std::uint32_t> found;
    for (const Arc& arc : second) {
      grid.crossing(arc.first, arc.second, found);
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      offered += found.size();
      for (std::uint32_t i = 0; i < first.size(); ++i) {
        if (!cross(arc, first[i])) continue;
        ++crossings;
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i));
      }
    }
    EXPECT_GT(crossings, 0U);
    if (longest < 0.1) {
      EXPECT_LT(offered, first.size() * second.size() / 15);
    }
  }
}

}  // namespace
}  // namespace hapticell::collision
