// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/vector.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/shapes/vertex_merge.h"

namespace hapticell {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Vector, ADegreeIsAThreeHundredAndSixtiethOfATurn) {
  EXPECT_NEAR(std::sin(30.0 * kDegree), 0.5, 1e-15);
  EXPECT_NEAR(360.0 * kDegree, 6.283185307179586, 1e-15);
}

TEST(Vector, IsFiniteLooksAtEachCoordinate) {
  EXPECT_TRUE(isFinite(dvec3(0.0, -1e308, 5e-324)));
  for (int i = 0; i < 3; ++i) {
    for (const double bad : {kInfinite, -kInfinite, kNotANumber}) {
      dvec3 v(1.0);
      v[i] = bad;
      EXPECT_FALSE(isFinite(v)) << i << " " << bad;
    }
  }
}

RC_GTEST_PROP(Vector, ShortenedKeepsTheDirectionAndNeverExceedsTheLimit, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1001) * 1e-2; };
  const double x = number(), y = number(), z = number(), limit = *rc::gen::inRange(0, 2000) * 1e-2;
  const dvec3 v(x, y, z), shorter = shortenedTo(v, limit);
  RC_ASSERT(glm::length(shorter) <= limit * (1.0 + 1e-15) || shorter == v);
  RC_ASSERT(glm::length(shorter) <= glm::length(v));
  RC_ASSERT(glm::length(glm::cross(v, shorter)) < 1e-9);
  RC_ASSERT(glm::dot(v, shorter) >= 0.0);
  if (glm::length(v) <= limit) RC_ASSERT(shorter == v);
}

TEST(Vector, ShorteningTheZeroVectorOrToNothingIsZero) {
  EXPECT_EQ(shortenedTo(dvec3(0.0), 0.0), dvec3(0.0));
  EXPECT_EQ(shortenedTo(dvec3(3.0, 4.0, 0.0), 0.0), dvec3(0.0));
}

namespace mesh {

using geometry::mergedVertices;

/// The promise of the header, one vertex after the other.
std::vector<std::uint32_t> mergedByTryingAll(const std::vector<dvec3>& vertices, double tolerance) {
  std::vector<std::uint32_t> kept, first_of(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    first_of[i] = i;
    for (const std::uint32_t k : kept) {
      if (glm::distance(vertices[k], vertices[i]) > tolerance) continue;
      first_of[i] = k;
      break;
    }
    if (first_of[i] == i) kept.push_back(i);
  }
  return first_of;
}

TEST(VertexMerge, NothingOfNothing) {
  EXPECT_TRUE(mergedVertices({}, 1e-6).empty());
}

TEST(VertexMerge, EqualVerticesAreMergedWithoutAnyTolerance) {
  const std::vector<dvec3> vertices{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {0, 0, -0.0}};
  EXPECT_EQ(mergedVertices(vertices, 0.0), (std::vector<std::uint32_t>{0, 1, 0, 1}));
}

RC_GTEST_PROP(VertexMerge, EachStandsForTheFirstKeptOneWithinTheTolerance, ()) {
  const auto numbers = *rc::gen::container<std::vector<int>>(90, rc::gen::inRange(-30, 30));
  std::vector<dvec3> vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    vertices.push_back(1e-4 * dvec3(numbers[i], numbers[i + 1], numbers[i + 2]));
  }
  const double tolerance = 1.05e-4 * *rc::gen::inRange(1, 8);
  RC_ASSERT(mergedVertices(vertices, tolerance) == mergedByTryingAll(vertices, tolerance));
}

TEST(VertexMerge, VerticesFarFromTheOriginAreMergedAsWell) {
  const std::vector<dvec3> vertices{{1e6, -1e6, 1e6}, {1e6 + 1e-7, -1e6, 1e6}, {1e6 + 1.0, -1e6, 1e6}};
  EXPECT_EQ(mergedVertices(vertices, 1e-6), (std::vector<std::uint32_t>{0, 0, 2}));
}

}  // namespace mesh
}  // namespace
}  // namespace hapticell
