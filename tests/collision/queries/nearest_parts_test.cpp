// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "collision/queries/near_pairs.h"
#include "collision/queries/nearest_search.h"
#include "collision/queries/triangle_pairs.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

class NearestParts : public testing::Test {
 protected:
  Corners placedCorners(const MeshCollider& mesh, std::uint32_t t, const Pose& X) const {
    return {X * mesh.mesh().corner(t, 0), X * mesh.mesh().corner(t, 1), X * mesh.mesh().corner(t, 2)};
  }
  double pairDistance(std::uint32_t i, std::uint32_t j, const Pose& X_AB) const {
    return std::sqrt(triangleDistance(a_->mesh().corners(i), placedCorners(*b_, j, X_AB)).squared);
  }
  double leastOfAll(const Pose& X_AB) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < a_->mesh().triangles.size(); ++i) {
      for (std::uint32_t j = 0; j < b_->mesh().triangles.size(); ++j) least = std::min(least, pairDistance(i, j, X_AB));
    }
    return least;
  }
  /// B at some distance from A.
  Pose apart() {
    Pose X = test::randomPose(random_, 0.2);
    X.p += dvec3(0.7, 0.0, 0.0);
    return X;
  }
  std::mt19937 random_{23};
  std::shared_ptr<const MeshCollider> a_ = MeshCollider::build(test::soupMesh(random_, 80, 0.3));
  std::shared_ptr<const MeshCollider> b_ = MeshCollider::build(test::sphereMesh(0.15, 6, 9));
};

TEST_F(NearestParts, TheSearchFindsTheNearestOfAllPairs) {
  for (int trial = 0; trial < 20; ++trial) {
    const Pose X_AB = trial % 4 == 0 ? test::randomPose(random_, 0.1) : apart();
    NearestSearch search(*a_, *b_, X_AB, {});
    search.run({static_cast<std::uint32_t>(trial), 3});
    ASSERT_TRUE(search.isFound());
    const double least = leastOfAll(X_AB);
    EXPECT_NEAR(std::sqrt(search.best().squared), least, 1e-9);
    EXPECT_NEAR(pairDistance(search.pair().a, search.pair().b, X_AB), least, 1e-9) << "and says which";
    EXPECT_NEAR(glm::distance(search.best().p, search.best().q), least, 1e-9) << "and where";
  }
}

TEST_F(NearestParts, ADemandLimitsWhatIsLookedFor) {
  for (int trial = 0; trial < 20; ++trial) {
    const Pose X_AB = apart();
    const double least = leastOfAll(X_AB);
    if (least < 1e-3) continue;
    NearestSearch within(*a_, *b_, X_AB, {.limit = 1.01 * least}), beyond(*a_, *b_, X_AB, {.limit = 0.99 * least});
    within.run({0, 0});
    beyond.run({0, 0});
    EXPECT_TRUE(within.isFound());
    EXPECT_FALSE(beyond.isFound()) << "nothing is nearer than the limit";
    NearestSearch rough(*a_, *b_, X_AB, {.exact_within = 0.0, .tolerance = 0.2});
    rough.run({0, 0});
    const double found = std::sqrt(rough.best().squared);
    EXPECT_GE(found, least - 1e-9);
    EXPECT_LE(found, 1.2 * least + 1e-9) << "too large by the tolerance at most";
    NearestSearch satisfied(*a_, *b_, X_AB, {.enough = 5.0});
    satisfied.run({7, 5});
    EXPECT_EQ(satisfied.pair(), (TriangleIndices{7, 5})) << "the first pair is near enough, nothing is searched";
  }
}

TEST_F(NearestParts, CornersOfBothAreInTheFrameOfA) {
  const Pose X_AB = apart();
  const NearestSearch search(*a_, *b_, X_AB, {});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(search.cornersA(4)[k], a_->mesh().corner(4, static_cast<int>(k)));
    EXPECT_LT(glm::distance(search.cornersB(4)[k], X_AB * b_->mesh().corner(4, static_cast<int>(k))), 1e-14);
  }
}

TEST_F(NearestParts, TheListHoldsAllNearPairsAndBoundsTheOthersWhileBMoves) {
  for (int trial = 0; trial < 10; ++trial) {
    const Pose X_AB = apart();
    NearPairs near;
    const double radius = leastOfAll(X_AB) + 0.03;
    if (!near.fill(*a_, *b_, X_AB, radius)) continue;
    EXPECT_EQ(near.reachAt(X_AB), radius);
    EXPECT_EQ(near.movedSince(X_AB), 0.0);
    const Pose X_moved = displaced(X_AB, {{0.004, -0.003, 0.002}, {0.02, 0.01, -0.02}});
    double farthest = 0.0;
    for (const dvec3& v : b_->mesh().vertices) farthest = std::max(farthest, glm::distance(X_AB * v, X_moved * v));
    EXPECT_GE(near.movedSince(X_moved), farthest) << "an upper bound";
    EXPECT_LT(near.movedSince(X_moved), 4.0 * farthest + 1e-9) << "and not a wild one";
    const double reach = near.reachAt(X_moved);
    for (std::uint32_t i = 0; i < a_->mesh().triangles.size(); ++i) {
      for (std::uint32_t j = 0; j < b_->mesh().triangles.size(); ++j) {
        const bool is_listed = std::any_of(near.pairs().begin(), near.pairs().end(), [&](const TrianglePair& pair) {
          return pair.triangle_a == i && pair.triangle_b == j;
        });
        if (is_listed) continue;
        EXPECT_GE(pairDistance(i, j, X_moved), reach - 1e-9);
        EXPECT_GT(pairDistance(i, j, X_AB), radius - 1e-9);
      }
    }
    near.clear();
    EXPECT_LT(near.reachAt(X_AB), 0.0) << "nothing is known any more";
  }
}

TEST_F(NearestParts, AListThatWouldBeTooLongIsNoneAndTheNextIsShorter) {
  NearPairs near;
  const double likely = near.likelyRadius();
  EXPECT_FALSE(near.fill(*a_, *b_, {}, 5.0)) << "720 pairs and more";
  EXPECT_LT(near.reachAt({}), 0.0);
  EXPECT_LT(near.likelyRadius(), 5.0);
  const double crowded = near.likelyRadius();
  near.forgive();
  EXPECT_GT(near.likelyRadius(), crowded);
  NearPairs roomy;
  ASSERT_TRUE(roomy.fill(*a_, *b_, Pose::translation({3, 0, 0}), 0.5 * likely));
  EXPECT_TRUE(roomy.pairs().empty());
  EXPECT_GE(roomy.likelyRadius(), 0.75 * likely);
}

TEST_F(NearestParts, PairsAreEqualWhereBothTrianglesAre) {
  EXPECT_EQ((TriangleIndices{1, 2}), (TriangleIndices{1, 2}));
  EXPECT_NE((TriangleIndices{1, 2}), (TriangleIndices{2, 1}));
}

}  // namespace
}  // namespace hapticell::collision
