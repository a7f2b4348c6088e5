// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/triangle_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hapticell::collision {
namespace {

/// The second method: alternating projections onto the two convex sets (Cheney & Goldstein 1959), from several starts.
double byAlternatingProjections(const Corners& a, const Corners& b) {
  double least = 1e9;
  for (const dvec3& start : a) {
    dvec3 p = start, q = start;
    for (int i = 0; i < 3000; ++i) {
      q = closestPointOnTriangle(b, p);
      p = closestPointOnTriangle(a, q);
    }
    least = std::min(least, glm::distance(p, q));
  }
  return least;
}

class TriangleDistance : public testing::Test {
 protected:
  Corners triangle(double spread) {
    std::normal_distribution<double> normal;
    const dvec3 middle(normal(random_), normal(random_), normal(random_));
    Corners corners;
    for (dvec3& corner : corners) corner = middle + spread * dvec3(normal(random_), normal(random_), normal(random_));
    return corners;
  }
  std::mt19937 random_{41};
};

TEST_F(TriangleDistance, AgreesWithAlternatingProjections) {
  int apart = 0, meeting = 0;
  for (int i = 0; i < 400; ++i) {
    const Corners a = triangle(0.8), b = triangle(0.8);
    const NearestPair pair = triangleDistance(a, b);
    const double distance = std::sqrt(pair.squared), expected = byAlternatingProjections(a, b);
    EXPECT_LE(distance, expected + 1e-9);
    EXPECT_GE(distance, expected - 2e-3) << "the projections converge slowly where edges cross";
    EXPECT_NEAR(glm::distance(pair.p, pair.q), distance, 1e-12);
    EXPECT_LT(glm::distance(closestPointOnTriangle(a, pair.p), pair.p), 1e-9);
    EXPECT_LT(glm::distance(closestPointOnTriangle(b, pair.q), pair.q), 1e-9);
    ++(distance == 0.0 ? meeting : apart);
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(meeting, 10);
}

TEST_F(TriangleDistance, KnownPlaces) {
  const Corners ground{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)};
  const auto at = [&](const Corners& other) { return std::sqrt(triangleDistance(ground, other).squared); };
  EXPECT_NEAR(at({dvec3(0.2, 0.2, 0.5), dvec3(0.3, 0.2, 1), dvec3(0.2, 0.3, 1)}), 0.5, 1e-15) << "corner over face";
  EXPECT_NEAR(at({dvec3(-1, 0.5, 1), dvec3(-1, -0.5, 1), dvec3(-2, 0, 2)}), std::sqrt(2.0), 1e-15) << "edge to edge";
  EXPECT_NEAR(at({dvec3(2, -1, 0), dvec3(3, -1, 0), dvec3(2, -2, 0)}), std::sqrt(2.0), 1e-15) << "coplanar, corners";
  EXPECT_EQ(at({dvec3(0.1, 0.1, 0), dvec3(0.2, 0.1, 0), dvec3(0.1, 0.2, 0)}), 0.0) << "coplanar, one in the other";
  EXPECT_EQ(at({dvec3(0.2, 0.2, -1), dvec3(0.2, 0.2, 1), dvec3(0.3, 0.3, 1)}), 0.0) << "pierced";
  EXPECT_EQ(at({dvec3(1, 0, 0), dvec3(2, 0, 0), dvec3(2, 1, 1)}), 0.0) << "a shared corner";
}

TEST_F(TriangleDistance, DegenerateTrianglesAreSegmentsAndPoints) {
  const Corners ground{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)};
  const dvec3 p(0.2, 0.2, 0.7);
  EXPECT_NEAR(triangleDistance(ground, {p, p, p}).squared, 0.49, 1e-15);
  EXPECT_NEAR(triangleDistance({p, p, p}, ground).squared, 0.49, 1e-15);
  const Corners segment{dvec3(0.2, 0.2, -0.5), dvec3(0.2, 0.2, 0.5), dvec3(0.2, 0.2, 0.1)};
  EXPECT_LT(triangleDistance(ground, segment).squared, 1e-24);
  EXPECT_NEAR(triangleDistance({p, p, p}, {dvec3(0.2, 0.2, 1.7), dvec3(0.2, 0.2, 1.7), dvec3(5, 5, 5)}).squared, 1.0,
              1e-14);
}

TEST_F(TriangleDistance, NeedlesAndNearlyParallelEdgesKeepMicrometres) {
  std::normal_distribution<double> normal;
  for (int i = 0; i < 500; ++i) {
    const double tilt = std::pow(10.0, -1.0 - 0.02 * i);
    const Corners a{dvec3(0, 0, 0), dvec3(2, 0, 0), dvec3(1, 1e-9 * normal(random_), -1)};
    const Corners b{dvec3(0, 0, 0.3), dvec3(2, tilt, 0.3), dvec3(1, 0, 1.3)};
    EXPECT_NEAR(std::sqrt(triangleDistance(a, b).squared), 0.3, 1e-9) << tilt;
  }
}

TEST_F(TriangleDistance, ASegmentGivenAsTriangleIsThatSegmentWhateverItsRounding) {
  // The middle of two corners is off their line by rounding only; the plane of such a triangle is nowhere.
  for (int i = 0; i < 2000; ++i) {
    Corners needle = triangle(0.3);
    needle[2] = needle[0] + (i % 3 == 0 ? 0.5 : 0.37) * (needle[1] - needle[0]);
    const Corners segment{needle[0], needle[1], needle[0]}, other = triangle(0.3);
    const double expected = std::sqrt(triangleDistance(segment, other).squared);
    EXPECT_NEAR(std::sqrt(triangleDistance(needle, other).squared), expected, 1e-9);
    EXPECT_NEAR(std::sqrt(triangleDistance(other, needle).squared), expected, 1e-9);
    NearestPair best;
    best.squared = expected * expected * 1.0001 + 1e-20;
    EXPECT_TRUE(improveTriangleDistance(needle, other, best)) << "pruned by a plane that is rounding";
  }
}

}  // namespace
}  // namespace hapticell::collision
