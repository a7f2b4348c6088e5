// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/scene_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "collision/queries/pair_table.h"
#include "collision/queries/placed_bounds.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

TEST(PlacedBounds, HoldTheMeshAndAreNoFartherApartThanTheMeshesAre) {
  std::mt19937 random(6);
  const auto a = MeshCollider::build(test::boxMesh({0.4, 0.1, 0.05})), b = MeshCollider::build(test::sphereMesh(0.1));
  for (int i = 0; i < 200; ++i) {
    const Pose X_WA = test::randomPose(random, 0.5), X_WB = test::randomPose(random, 0.5);
    const PlacedBounds at_a = placedBounds(*a, X_WA), at_b = placedBounds(*b, X_WB);
    const double exact = distance(a, X_WA, b, X_WB).distance;
    EXPECT_LE(std::max(sphereGap(at_a, at_b), boxGap(at_a, at_b)), exact + 1e-9);
    const geometry::Bounds box = at_a.box_W();
    for (const dvec3& p : a->mesh().vertices) {
      EXPECT_TRUE(glm::all(glm::greaterThan(X_WA * p, box.min - 1e-6)) &&
                  glm::all(glm::lessThan(X_WA * p, box.max + 1e-6)));
    }
  }
}

TEST(PairTable, SaysWhatAMapSays) {
  std::mt19937 random(2);
  PairTable table;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected;
  for (int step = 0; step < 20000; ++step) {
    auto a = static_cast<std::uint32_t>(random() % 60), b = static_cast<std::uint32_t>(random() % 60);
    if (a == b) continue;
    const auto key = std::minmax(a, b);
    if (random() % 3 == 0) {
      table.erase(a, b);
      expected.erase(key);
    } else {
      table.set(a, b, static_cast<std::uint32_t>(step));
      expected[key] = static_cast<std::uint32_t>(step);
    }
    EXPECT_EQ(table.size(), expected.size());
    const auto c = static_cast<std::uint32_t>(random() % 60);
    if (c == a) continue;
    const auto found = expected.find(std::minmax(a, c));
    EXPECT_EQ(table.find(c, a), found == expected.end() ? PairTable::kNone : found->second);
  }
  table.clear();
  EXPECT_EQ(table.find(1, 2), PairTable::kNone);
}

TEST(ScenePairs, PairsKeepTheirNumbersInOrderWhenPartsGo) {
  std::mt19937 random(4);
  ScenePairs pairs;
  std::set<std::pair<PartIndex, PartIndex>> expected;
  for (int step = 0; step < 3000; ++step) {
    const auto a = static_cast<PartIndex>(random() % 30), b = static_cast<PartIndex>(random() % 30);
    if (random() % 20 == 0) {
      pairs.removePart(a);
      std::erase_if(expected, [a](const auto& pair) { return pair.first == a || pair.second == a; });
    } else if (a != b) {
      const PairIndex index = pairs.add(a, b, 7);
      EXPECT_EQ(pairs.known(b, a), index) << "either way round";
      expected.insert(std::minmax(a, b));
    }
    ASSERT_EQ(pairs.size(), expected.size());
  }
  for (PairIndex i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(expected.count(std::minmax(pairs[i].moved, pairs[i].environment)), 1u);
    EXPECT_EQ(pairs.known(pairs[i].moved, pairs[i].environment), i);
  }
}

TEST(ScenePairs, ASetGivesAPairItsNumberWhenAsked) {
  ScenePairs pairs;
  const PartIndex robot[] = {0, 1}, cell[] = {2, 3, 4}, others[] = {1, 4};
  pairs.addSet(robot, cell, 5);
  pairs.addSet(others, others, 6);
  EXPECT_EQ(pairs.size(), 0u);
  EXPECT_EQ(pairs.find(0, 1), ScenePairs::kNone);
  EXPECT_EQ(pairs.find(2, 3), ScenePairs::kNone);
  const PairIndex pair = pairs.find(3, 0);
  ASSERT_NE(pair, ScenePairs::kNone);
  EXPECT_EQ(pairs[pair].moved, 0u);
  EXPECT_EQ(pairs[pair].environment, 3u);
  EXPECT_EQ(pairs[pair].tag, 5u);
  EXPECT_EQ(pairs[pairs.find(1, 4)].tag, 6u) << "of two sets the later";
  EXPECT_EQ(pairs.size(), 2u);
  EXPECT_TRUE(pairs.isSought(2) && !pairs.isSeeker(2) && pairs.isSeeker(0) && !pairs.isSought(0));
  pairs.removePart(3);
  EXPECT_EQ(pairs.find(0, 3), ScenePairs::kNone);
}

}  // namespace
}  // namespace hapticell::collision
