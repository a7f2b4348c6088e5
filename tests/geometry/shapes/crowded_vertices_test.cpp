// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/crowded_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace hapticell::geometry {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// `count` places in a cube of 2 m about the origin; every tenth one beside the one before it, up to `reach` (m) away.
std::vector<dvec3> placesWithNeighbours(std::size_t count, double reach) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<dvec3> places;
  for (std::size_t k = 0; k < count; ++k) {
    const dvec3 by(place(random), place(random), place(random));
    places.push_back(k % 10 == 9 ? places.back() + reach * by : by);
  }
  return places;
}

/// The same question by a sweep along x.
Numbers crowdedBySweep(const std::vector<dvec3>& places, double tolerance) {
  Numbers order(places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return places[a].x < places[b].x; });
  std::vector<bool> crowded(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && places[order[j]].x - places[order[i]].x <= tolerance; ++j) {
      if (glm::distance(places[order[i]], places[order[j]]) <= tolerance) crowded[order[i]] = crowded[order[j]] = true;
    }
  }
  Numbers numbers;
  for (std::uint32_t k = 0; k < places.size(); ++k)
    if (crowded[k]) numbers.push_back(k);
  return numbers;
}

TEST(CrowdedVertices, AreThoseThatASweepFinds) {
  constexpr double kTolerance = 1e-3;
  const std::vector<dvec3> places = placesWithNeighbours(50'000, kTolerance);  // For more than one thread.
  const Numbers crowded = crowdedVertices(places, kTolerance), swept = crowdedBySweep(places, kTolerance);
  EXPECT_EQ(crowded, swept);
  EXPECT_GT(swept.size(), 4000u);
  EXPECT_LT(swept.size(), 10'000u) << "not each that was put beside another is near enough";
}

TEST(CrowdedVertices, AreTheSameInAnyOrder) {
  constexpr double kTolerance = 1e-3;
  const std::vector<dvec3> places = placesWithNeighbours(50'000, kTolerance);
  std::vector<dvec3> turned(places.rbegin(), places.rend());
  Numbers numbers = crowdedVertices(turned, kTolerance);
  for (std::uint32_t& number : numbers) number = static_cast<std::uint32_t>(places.size()) - 1 - number;
  std::reverse(numbers.begin(), numbers.end());
  EXPECT_EQ(numbers, crowdedVertices(places, kTolerance));
}

TEST(CrowdedVertices, WithoutToleranceAreEqualOnesOnly) {
  EXPECT_EQ(crowdedVertices({{10, 0, 0}, {1, 0, 0}, {1, 1e-12, 0}, {10, 0, 0}, {1, 0, 2}}, 0.0), (Numbers{0, 3}));
  EXPECT_TRUE(crowdedVertices({}, 1e-3).empty());
  EXPECT_TRUE(crowdedVertices({{1, 2, 3}}, 1e-3).empty());
}

TEST(CrowdedVertices, ReachAcrossTheOriginAndUpToTheToleranceItself) {
  EXPECT_EQ(crowdedVertices({{-0.25, 0, 0}, {0.25, 0, 0}, {0, 5, 0}}, 0.5), (Numbers{0, 1}));
  EXPECT_TRUE(crowdedVertices({{-0.25, 0, 0}, {0.25, 0, 0}, {0, 5, 0}}, 0.49).empty());
}

/// More in one place than are compared with each other: all of them count.
TEST(CrowdedVertices, InAHeapAreAll) {
  std::vector<dvec3> places = placesWithNeighbours(2000, 0.0);
  for (dvec3& place : places) place *= 1e-4;
  EXPECT_EQ(crowdedVertices(places, 1e-3).size(), places.size());
}

}  // namespace
}  // namespace hapticell::geometry
