// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using test::boxMesh;
using test::sphereMesh;

/// Three moved parts among twelve standing ones, every moved one checked against every standing one.
class SceneTest : public testing::Test {
 protected:
  SceneTest() {
    for (std::uint32_t i = 0; i < 3; ++i) {
      moved_.push_back(
          scene_.addPart({1, i}, MeshCollider::build(i == 1 ? sphereMesh(0.1) : boxMesh({0.2, 0.1, 0.1}))));
    }
    for (std::uint32_t i = 0; i < 12; ++i) {
      const std::uint32_t row = i / 4, column = i % 4;
      const Pose X_WE = Pose::translation({0.5 * column - 0.75, 0.6 * row - 0.6, 0.0});
      fixed_.push_back(scene_.addPart({2 + i, 0}, MeshCollider::build(sphereMesh(0.05 + 0.01 * i, 6, 9)), X_WE));
    }
    for (const PartIndex a : moved_) {
      for (const PartIndex b : fixed_) scene_.addPair(a, b, b);
    }
  }

  void shuffle() {
    for (const PartIndex part : moved_) scene_.setPose(part, test::randomPose(random_, 0.9));
  }

  /// The second method: each pair for itself, cold.
  std::vector<double> allDistances() const {
    std::vector<double> all;
    for (PairIndex i = 0; i < scene_.pairCount(); ++i) {
      const PartIndex a = scene_.moved(i), b = scene_.environment(i);
      all.push_back(
          distance(scene_.sharedCollider(a), scene_.pose(a), scene_.sharedCollider(b), scene_.pose(b)).distance);
    }
    return all;
  }

  std::mt19937 random_{3};
  Scene scene_;
  std::vector<PartIndex> moved_, fixed_;
};

TEST_F(SceneTest, NearestIsTheLeastOfAllPairs) {
  for (int i = 0; i < 200; ++i) {
    shuffle();
    const std::vector<double> all = allDistances();
    const double least = *std::min_element(all.begin(), all.end());
    const auto nearest = scene_.nearest();
    ASSERT_TRUE(nearest);
    EXPECT_NEAR(nearest->result.distance, least, 1e-9);
    EXPECT_NEAR(all[nearest->pair], least, 1e-9);
    EXPECT_EQ(scene_.collides(), least == 0.0);
    EXPECT_EQ(scene_.nearest(0.05).has_value(), least < 0.05);
  }
}

TEST_F(SceneTest, PairsWithinAreExactlyThoseBelowTheMargin) {
  std::vector<PairDistance> found;
  for (int i = 0; i < 200; ++i) {
    shuffle();
    found.clear();
    scene_.pairsWithin(0.3, found);
    const std::vector<double> all = allDistances();
    EXPECT_EQ(static_cast<std::ptrdiff_t>(found.size()),
              std::count_if(all.begin(), all.end(), [](double d) { return d < 0.3; }));
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k].result.distance, all[found[k].pair], 1e-9);
      EXPECT_LE(found[k == 0 ? 0 : k - 1].result.distance, found[k].result.distance);
    }
  }
}

TEST_F(SceneTest, IsEditedBetweenQueries) {
  shuffle();
  const auto first = scene_.nearest();
  ASSERT_TRUE(first);
  scene_.setEnabled(first->pair, false);
  const auto second = scene_.nearest();
  ASSERT_TRUE(second);
  EXPECT_NE(second->pair, first->pair);
  EXPECT_GE(second->result.distance, first->result.distance);

  const PartIndex gone = scene_.environment(second->pair);
  const std::size_t before = scene_.pairCount();
  scene_.removePart(gone);
  EXPECT_EQ(scene_.pairCount(), before - moved_.size());
  const auto third = scene_.nearest();
  ASSERT_TRUE(third);
  EXPECT_NE(scene_.environment(third->pair), gone);
  const PartIndex added =
      scene_.addPart({99, 0}, MeshCollider::build(boxMesh({0.01, 0.01, 0.01})), scene_.pose(moved_[0]));
  EXPECT_EQ(added, gone) << "the place is used again";
  scene_.addPair(moved_[0], added, 7);
  const auto fourth = scene_.nearest();
  ASSERT_TRUE(fourth);
  EXPECT_TRUE(fourth->result.colliding);
  EXPECT_EQ(scene_.tag(fourth->pair), 7u);
  scene_.clearPairs();
  EXPECT_FALSE(scene_.nearest());
}

TEST_F(SceneTest, AJointMotionStopsAtTheFirstObstacleOfAnyPart) {
  for (int i = 0; i < 300; ++i) {
    shuffle();
    if (scene_.collides()) continue;
    std::vector<MovedPart> motion;
    const Pose X_by = test::randomPose(random_, 0.8);
    for (const PartIndex part : moved_) {
      const Pose X_WEnd{scene_.pose(part).p + X_by.p, scene_.pose(part).q};
      motion.push_back({part, straightMotion(scene_.pose(part), X_WEnd, scene_.collider(part))});
    }
    const double begun = scene_.nearest()->result.distance, kept = std::min(begun, 0.002);
    const SceneStop stop = scene_.advance(motion, 0.002);
    for (int k = 0; k <= 40; ++k) {
      for (const MovedPart& part : motion) scene_.setPose(part.part, part.motion.at(stop.s * k / 40.0));
      EXPECT_GE(scene_.nearest()->result.distance, k == 40 ? kept - 1e-9 : 0.5 * kept - 1e-9);
    }
    if (!stop.stopped) continue;
    for (const MovedPart& part : motion) scene_.setPose(part.part, part.motion.at(stop.s + 1e-5));
    EXPECT_LT(scene_.distance(stop.pair).distance, 0.002) << "and no earlier than it must";
  }
}

TEST(Scene, PartsOfOneRobotAreCheckedAgainstEachOther) {
  Scene scene;
  const auto box = MeshCollider::build(boxMesh({0.1, 0.1, 0.1}));
  const PartIndex left = scene.addPart({1, 0}, box, Pose::translation({-0.5, 0, 0}));
  const PartIndex right = scene.addPart({1, 1}, box, Pose::translation({0.5, 0, 0}));
  scene.addPair(left, right);
  const MovedPart both[] = {{left, straightMotion(scene.pose(left), {}, *box)},
                            {right, straightMotion(scene.pose(right), {}, *box)}};
  const SceneStop stop = scene.advance(both, 0.0);
  EXPECT_TRUE(stop.stopped);
  EXPECT_NEAR(stop.s, 0.9, 1e-4);
}

/// Against the distance of each pair, cold, at many places of the motion.
TEST_F(SceneTest, FindsPairsNearerThanTheirClearanceOnTheWay) {
  std::vector<double> clearance(fixed_.back() + 1, 0.0);
  for (std::size_t i = 0; i < fixed_.size(); ++i) clearance[fixed_[i]] = i % 3 == 0 ? 0.0 : 0.004 * static_cast<double>(i);
  int free = 0, found = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<MovedPart> moved;
    for (const PartIndex part : moved_) {
      const Pose X_WStart = test::randomPose(random_, 0.9), X_WEnd = test::randomPose(random_, 0.9);
      moved.push_back({part, straightMotion(X_WStart, interpolate(X_WStart, X_WEnd, 0.2), scene_.collider(part))});
    }
    const auto nearer = scene_.findNearer(moved, clearance, true);
    double least_of_all = 1.0, of_found = 1.0;  // Distance less clearance.
    for (int k = 0; k <= 12; ++k) {
      for (const MovedPart& part : moved) scene_.setPose(part.part, part.motion.at(k / 12.0));
      const std::vector<double> all = allDistances();
      for (PairIndex pair = 0; pair < all.size(); ++pair) {
        const double over = all[pair] - clearance[scene_.tag(pair)];
        if (all[pair] == 0.0 || over < 0.0) least_of_all = std::min(least_of_all, all[pair] == 0.0 ? -1.0 : over);
        if (nearer && pair == *nearer) of_found = std::min(of_found, over - 0.1 * clearance[scene_.tag(pair)]);
      }
    }
    if (nearer) {
      EXPECT_LT(of_found, 0.02) << "sampled 13 times";
      ++found;
    } else {
      EXPECT_GE(least_of_all, 0.0);
      ++free;
    }
  }
  EXPECT_GT(free, 3);
  EXPECT_GT(found, 3);
}

}  // namespace
}  // namespace hapticell::collision
