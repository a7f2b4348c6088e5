// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/proximity_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "collision/trees/box_tree.h"
#include "collision/trees/kernel_sweeps.h"
#include "collision/trees/kernel_triangles.h"
#include "collision/trees/triangle_distance.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

/// Every kind of kernels that this machine can run, against double arithmetic that shares no line with them.
class ProximityKernels : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    kernels_ = proximityKernels(GetParam());
    if (kernels_ == nullptr) GTEST_SKIP() << "this processor or build has no " << GetParam();
  }
  double unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  dvec3 anywhere(double reach) { return reach * dvec3(unit(), unit(), unit()); }

  /// Triangles of all shapes: fair ones, needles, caps, segments and points; apart, near and through each other.
  Corners triangle(int i, const dvec3& middle, double size) {
    Corners c{middle + anywhere(size), middle + anywhere(size), middle + anywhere(size)};
    if (i % 5 == 1) c[2] = 0.5 * (c[0] + c[1]) + anywhere(1e-4 * size);
    if (i % 5 == 2) c[2] = c[0] + anywhere(1e-3 * size);
    if (i % 11 == 3) c[1] = c[0];
    if (i % 23 == 4) c[1] = c[2] = c[0];
    return c;
  }

  const collision::ProximityKernels* kernels_ = nullptr;
  std::mt19937 random_{21};
};

float asFloat(double x) {
  return static_cast<float>(x);
}

/// The distance of two boxes: of their surfaces' triangles; 0 where one is inside the other.
double leastBetween(const OrientedBox& a, const OrientedBox& b) {
  const geometry::TriangleMesh unit = test::boxMesh({2.0, 2.0, 2.0});
  const auto corner = [&unit](const OrientedBox& box, std::size_t triangle, std::size_t c) {
    return box.center + box.R * (box.half * unit.corner(static_cast<std::uint32_t>(triangle), c));
  };
  if (lowerBoundSquared(a, b.center) == 0.0 || lowerBoundSquared(b, a.center) == 0.0) return 0.0;
  double least = 1e9;
  for (std::size_t i = 0; i < unit.triangles.size(); ++i) {
    const Corners first{corner(a, i, 0), corner(a, i, 1), corner(a, i, 2)};
    for (std::size_t k = 0; k < unit.triangles.size(); ++k) {
      least = std::min(least, triangleDistance(first, {corner(b, k, 0), corner(b, k, 1), corner(b, k, 2)}).squared);
    }
  }
  return std::sqrt(least);
}

/// Kernels are the same text for every width: by pairs of doubles they are as exact as the distance of one pair.
TEST(KernelTriangles, TwoPairsAtOnceAreAsFarApartAsOneByOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int through = 0;
  for (int round = 0; round < 5000; ++round) {
    double numbers[2][9][2];  // Face, coordinate, lane.
    Corners corners[2][2];    // Face, lane.
    for (int face = 0; face < 2; ++face) {
      for (int lane = 0; lane < 2; ++lane) {
        const double away = face == 0 ? 0.0 : 0.3 * (round % 8);
        for (int k = 0; k < 9; ++k) {
          numbers[face][k][lane] = unit(random) + (k % 3 == 0 ? away : 0.0);
          corners[face][lane][static_cast<std::size_t>(k / 3)][k % 3] = numbers[face][k][lane];
        }
      }
    }
    Face<Double2> first, second;
    loadFace(&numbers[0][0][0], 2, first);
    loadFace(&numbers[1][0][0], 2, second);
    const Double2 squared = distancesSquared(first, second);
    for (int lane = 0; lane < 2; ++lane) {
      const double expected = triangleDistance(corners[0][lane], corners[1][lane]).squared;
      ASSERT_NEAR(std::sqrt(squared[lane]), std::sqrt(expected), 1e-9) << round;
      through += expected == 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(through, 100) << "pairs that pass through each other were among them";
  EXPECT_LT(through, 9000);
}

TEST_P(ProximityKernels, PackedDistancesAreWithinTheirDoubt) {
  double worst_doubt = 0.0;
  for (int round = 0; round < 2000; ++round) {
    PackedPairs pairs;
    Corners first[kPackSize], second[kPackSize];
    for (int lane = 0; lane < kPackSize; ++lane) {
      const double away = std::pow(10.0, 1.5 * unit() - 1.0);
      first[lane] = triangle(round + lane, {}, 0.1);
      second[lane] = triangle(round + 3 * lane, anywhere(away), 0.1);
      for (std::size_t k = 0; k < 9; ++k) {
        // What the kernel is given is what it is judged by.
        pairs.first[k][lane] = asFloat(first[lane][k / 3][static_cast<int>(k % 3)]);
        pairs.second[k][lane] = asFloat(second[lane][k / 3][static_cast<int>(k % 3)]);
        first[lane][k / 3][static_cast<int>(k % 3)] = pairs.first[k][lane];
        second[lane][k / 3][static_cast<int>(k % 3)] = pairs.second[k][lane];
      }
    }
    PackedDistances found;
    const int count = 1 + round % kPackSize;
    kernels_->packedDistances(pairs, count, found);
    for (int lane = 0; lane < count; ++lane) {
      const double expected = triangleDistance(first[lane], second[lane]).squared;
      EXPECT_LE(std::abs(double{found.squared[lane]} - expected), double{found.doubt[lane]}) << expected;
      worst_doubt = std::max(worst_doubt, double{found.doubt[lane]} / std::max(expected, 0.01));
    }
  }
  EXPECT_LT(worst_doubt, 0.01) << "and the doubt is small";
}

TEST_P(ProximityKernels, ExactDistancesAreExact) {
  for (int round = 0; round < 2000; ++round) {
    ExactPairs pairs;
    Corners first[kTreeWidth], second[kTreeWidth];
    for (int lane = 0; lane < kTreeWidth; ++lane) {
      first[lane] = triangle(5 * round, {}, 0.1);
      second[lane] = triangle(5 * lane, anywhere(0.3), 0.1);
      for (std::size_t k = 0; k < 9; ++k) {
        pairs.first[k][lane] = first[lane][k / 3][static_cast<int>(k % 3)];
        pairs.second[k][lane] = second[lane][k / 3][static_cast<int>(k % 3)];
      }
    }
    double squared[kTreeWidth];
    kernels_->exactDistances(pairs, squared);
    for (int lane = 0; lane < kTreeWidth; ++lane) {
      EXPECT_NEAR(std::sqrt(squared[lane]), std::sqrt(triangleDistance(first[lane], second[lane]).squared), 1e-9);
    }
  }
}

TEST_P(ProximityKernels, GapsAlongALineAreTheLeastOfAllCorners) {
  int apart = 0;
  for (int round = 0; round < 500; ++round) {
    const Pose X = test::randomPose(random_, 0.3);
    const dvec3 line = glm::normalize(X.p + anywhere(0.1));
    const double line_A[3] = {line.x, line.y, line.z}, t[3] = {X.p.x, X.p.y, X.p.z};
    double R[9];
    for (int i = 0; i < 9; ++i) R[i] = X.R()[i % 3][i / 3];
    ExactPairs pairs, placed;
    Corners corners[2][kTreeWidth];
    for (int lane = 0; lane < kTreeWidth; ++lane) {
      for (int which = 0; which < 2; ++which) {
        corners[which][lane] = triangle(round + lane, dvec3(0.0), 0.1);
        for (std::size_t k = 0; k < 9; ++k) {
          (which == 0 ? pairs.first : pairs.second)[k][lane] = corners[which][lane][k / 3][static_cast<int>(k % 3)];
        }
      }
    }
    kernels_->placePairs(pairs, R, t, placed);
    double gaps[kTreeWidth], squared[kTreeWidth];
    kernels_->exactGaps(placed, line_A, gaps);
    kernels_->exactDistances(placed, squared);
    for (int lane = 0; lane < kTreeWidth; ++lane) {
      double least = 1e9;
      for (const dvec3& a : corners[0][lane]) {
        for (const dvec3& b : corners[1][lane]) least = std::min(least, glm::dot(line, X * b - a));
      }
      EXPECT_NEAR(gaps[lane], least, 1e-14);
      EXPECT_GE(std::sqrt(squared[lane]), gaps[lane] - 1e-14);
      if (gaps[lane] > 0.0) ++apart;
    }
  }
  EXPECT_GT(apart, 500);
}

TEST_P(ProximityKernels, BoxBoundsNeverExceedTheDistanceAndAreTight) {
  const geometry::TriangleMesh mesh = test::soupMesh(random_, 400, 0.5);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  const BoxTree tree(mesh, all);
  for (std::uint32_t index = 1; index < tree.nodes().size(); ++index) {
    const BoxNode& node = tree.node(index);
    const Pose X = test::randomPose(random_, 1.0);
    const OrientedBox other{X.R(), X.p, 0.1 * glm::abs(dvec3(unit(), unit(), unit()))};
    QueryBox query;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) query.axis[i][k] = asFloat(other.R[i][k]);
      query.center[i] = asFloat(other.center[i] - double{node.origin[i]});
      query.half[i] = asFloat(other.half[i]);
    }
    alignas(32) float squared[kTreeWidth];
    // Any line proves only what is so; the one that the nearest points are on is the usual one.
    const dvec3 line =
        glm::normalize(index % 3 == 1 ? anywhere(1.0) : other.center - tree.box(index * kTreeWidth).center);
    for (int i = 0; i < 3 && index % 3 != 0; ++i) query.line[i] = asFloat(line[i]);
    const float limit = asFloat(0.1 + 0.1 * unit());
    const std::uint32_t below = kernels_->boxBounds(node, query, limit, squared);
    for (std::uint32_t lane = 0; lane < kTreeWidth; ++lane) {
      EXPECT_EQ((below >> lane & 1u) != 0, squared[lane] < limit);
      if (lane >= node.count) {
        EXPECT_GT(squared[lane], 1e30f) << "lanes that are not used are infinitely far";
        continue;
      }
      const double expected = std::sqrt(lowerBoundSquared(tree.box(index * kTreeWidth + lane), other));
      EXPECT_LE(std::sqrt(double{squared[lane]}), leastBetween(tree.box(index * kTreeWidth + lane), other) + 1e-9);
      EXPECT_GE(std::sqrt(double{squared[lane]}), expected - 2e-5);
    }
    const dvec3 sweep = anywhere(0.5), turn = index % 2 == 0 ? anywhere(0.3) : dvec3(0.0);
    BoxSweep swept;
    for (int i = 0; i < 3; ++i) {
      swept.at[i] = asFloat(sweep[i]);
      swept.turn[i] = asFloat(turn[i]);
    }
    swept.margin = 0.05f;
    swept.turn_size = asFloat(1.000001 * glm::length(turn));
    const std::uint32_t met = kernels_->sweptBoxBounds(node, query, swept, squared);
    const dvec3 origin(node.origin[0], node.origin[1], node.origin[2]);
    for (std::uint32_t lane = 0; lane < node.count; ++lane) {
      const OrientedBox child = tree.box(index * kTreeWidth + lane);
      double least = 1e9;
      for (int k = -4; k <= 4; ++k) {
        OrientedBox there = other;
        there.center += k / 4.0 * (sweep + glm::cross(turn, child.center - origin));
        least = std::min(least, leastBetween(child, there));
      }
      const double bound = std::sqrt(double{squared[lane]}), near = 0.05 + glm::length(turn) * glm::length(child.half);
      EXPECT_LE(bound, least + 1e-5);
      const bool is_on_the_limit = std::abs(bound - near) < 1e-5;
      EXPECT_TRUE(is_on_the_limit || ((met >> lane & 1u) != 0) == (bound < near));
    }
  }
}

TEST(KernelSweeps, AChildSeesTheSweepOfItsOwnMiddle) {
  const BoxSweep sweep{{0.1f, 0.2f, 0.3f}, {0.0f, 0.0f, 0.5f}, 0.01f, 0.5f};
  const auto child = childSweep<Float4>({all<Float4>(2.0f), all<Float4>(0.0f), all<Float4>(0.0f)},
                                        {all<Float4>(0.03f), all<Float4>(0.04f), all<Float4>(0.0f)}, sweep);
  EXPECT_NEAR(child.sweep.x[0], 0.1, 1e-6);
  EXPECT_NEAR(child.sweep.y[1], 1.2, 1e-6) << "0.2 and 0.5 rad at 2 m";
  EXPECT_NEAR(child.sweep.z[2], 0.3, 1e-6);
  EXPECT_NEAR(std::sqrt(child.limit_squared[3]), 0.01 + 0.5 * 0.05, 1e-6);
}

TEST_P(ProximityKernels, LeavesAreBeyondABoxOnlyWhereAllTrianglesAre) {
  int beyond = 0, missed = 0;
  for (int round = 0; round < 5000; ++round) {
    LeafBlock leaf = {};
    leaf.count = static_cast<std::uint32_t>(1 + round % kLeafSize);
    Corners corners[kLeafSize];
    const dvec3 far_away = anywhere(round % 5 == 0 ? 20.0 : 0.0);
    for (int lane = 0; lane < kLeafSize; ++lane) {
      const auto own = std::min(lane, static_cast<int>(leaf.count) - 1);  // Unused lanes repeat the last one.
      if (own == lane) corners[lane] = triangle(round + lane, far_away, 0.3);
      for (std::size_t k = 0; k < 9; ++k) {
        leaf.corner[k][lane] = asFloat(corners[own][k / 3][static_cast<int>(k % 3)]);
        corners[own][k / 3][static_cast<int>(k % 3)] = double{leaf.corner[k][lane]};
      }
    }
    const Pose X = test::randomPose(random_, 0.4);
    const OrientedBox box{X.R(), far_away + X.p, 0.05 * glm::abs(dvec3(unit(), unit(), unit()))};
    QueryBox query;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) query.axis[i][k] = asFloat(box.R[i][k]);
      query.center[i] = asFloat(box.center[i]);
      query.half[i] = asFloat(box.half[i]);
    }
    double least = 1e9, bound = 1e9;
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
      bound = std::min(bound, lowerBoundSquared(box, corners[lane]));
      for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
          for (int k = -2; k <= 2; ++k) {
            const dvec3 p = box.center + box.R * (box.half * (0.5 * dvec3(i, j, k)));
            least = std::min(least, glm::distance(p, closestPointOnTriangle(corners[lane], p)));
          }
        }
      }
    }
    const double limit = least * (0.8 + 0.4 * std::abs(unit()));
    if (kernels_->isLeafBeyond(leaf, query, asFloat(limit * limit))) {
      ++beyond;
      EXPECT_GT(least, limit - 1e-7) << round;
    } else {
      // Not weaker than in double, but for the rounding, which matters for a needle now and then.
      missed += std::sqrt(bound) > limit + 1e-4;
    }
  }
  EXPECT_GT(beyond, 500);
  EXPECT_LT(missed, beyond / 200);
}

TEST_P(ProximityKernels, PlanesOnlyPassOverPairsThatAreFarther) {
  int passed_over = 0, kept = 0, swept_apart = 0;
  for (int round = 0; round < 3000; ++round) {
    LeafBlock leaves[2] = {};
    Corners corners[2][kLeafSize];
    for (int which = 0; which < 2; ++which) {
      leaves[which].count = static_cast<std::uint32_t>(1 + (round / (1 + 3 * which)) % kLeafSize);
      for (int lane = 0; lane < kLeafSize; ++lane) {
        corners[which][lane] = triangle(round + lane, which == 0 ? dvec3(0.0) : dvec3(0.05 * unit()), 0.05);
        for (std::size_t k = 0; k < 9; ++k) {
          leaves[which].corner[k][lane] = asFloat(corners[which][lane][k / 3][static_cast<int>(k % 3)]);
        }
      }
    }
    const Pose X = test::randomPose(random_, 0.1);
    LeafTransform transform;
    for (int i = 0; i < 9; ++i) transform.R[i] = asFloat(X.R()[i % 3][i / 3]);
    for (int i = 0; i < 3; ++i) transform.t[i] = asFloat(X.p[i]);
    const dvec3 line = glm::normalize(round % 3 == 1 ? anywhere(1.0) : X.p + dvec3(0.0, 0.0, 1e-3));
    for (int i = 0; i < 3 && round % 3 != 0; ++i) transform.line[i] = asFloat(line[i]);
    const double limit = 0.05 * std::abs(unit());
    alignas(16) float moved[9][kLeafSize];
    const std::uint32_t near = kernels_->leafPairs(leaves[0], leaves[1], transform, asFloat(limit * limit), moved);
    for (std::uint32_t bit = 0; bit < 16; ++bit) {
      const std::uint32_t i = bit % 4, j = bit / 4;
      if (i >= leaves[0].count || j >= leaves[1].count) {
        EXPECT_EQ(near >> bit & 1u, 0u);
        continue;
      }
      Corners b = corners[1][j];
      for (dvec3& corner : b) corner = X * corner;
      EXPECT_NEAR(double{moved[0][j]}, b[0].x, 1e-6);
      const double distance = std::sqrt(triangleDistance(corners[0][i], b).squared);
      if ((near >> bit & 1u) != 0) {
        ++kept;
      } else {
        ++passed_over;
        EXPECT_GT(distance, limit - 1e-6);
      }
    }
    const dvec3 sweep = anywhere(0.1);
    const float sweep_F[3] = {asFloat(sweep.x), asFloat(sweep.y), asFloat(sweep.z)};
    const std::uint32_t met =
        kernels_->sweptLeafPairs(leaves[0], leaves[1], transform, asFloat(limit * limit), sweep_F, moved);
    for (std::uint32_t bit = 0; bit < 16; ++bit) {
      const std::uint32_t i = bit % 4, j = bit / 4;
      if (i >= leaves[0].count || j >= leaves[1].count || (met >> bit & 1u) != 0) continue;
      for (int k = -10; k <= 10; ++k) {
        Corners b = corners[1][j];
        for (dvec3& corner : b) corner = X * corner + k / 10.0 * sweep;
        EXPECT_GT(std::sqrt(triangleDistance(corners[0][i], b).squared), limit - 1e-6);
      }
      ++swept_apart;
    }
  }
  EXPECT_GT(passed_over, 1000);
  EXPECT_GT(swept_apart, 500);
  EXPECT_GT(kept, 1000);
}

INSTANTIATE_TEST_SUITE_P(All, ProximityKernels, testing::Values("portable", "avx2", "avx512"));

}  // namespace
}  // namespace hapticell::collision
