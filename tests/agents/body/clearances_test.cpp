// SPDX-License-Identifier: Apache-2.0
#include "agents/body/clearances.h"

#include <gtest/gtest.h>

#include <random>

#include "agents/body/line_of_sight.h"
#include "collision/queries/proximity_query.h"
#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using manipulation::PreparedScene;
using test::arm;
using test::loaded;

std::shared_ptr<const PreparedScene> cell() {
  return PreparedScene::prepare({arm(), loaded("box:0.2,0.6,0.4", 2, "block", Pose::translation({-0.65, 0.0, 0.25})),
                                 loaded("cylinder:0.03,1.2", 3, "post", Pose::translation({-0.35, -0.45, 0.6}))},
                                {}, {});
}

/// Least distance of any link to the obstacles, by single queries.
double leastDistance(const PreparedScene& scene, const manipulation::EntityConfiguration& at) {
  double least = 10.0;
  const workcell::Entity& robot = *scene.find(1);
  for (const auto& link : scene.partsOf(1)) {
    for (const auto& other : scene.parts()) {
      if (other.entity == 1) continue;
      const auto result = collision::distance(link.mesh.collider, PreparedScene::partPose(robot, at.X_WE, at.joints, link.link),
                                              other.mesh.collider, scene.find(other.entity)->X_WE);
      least = std::min(least, result.colliding ? 0.0 : result.distance);
    }
  }
  return least;
}

TEST(Clearances, AreTheExactDistancesAndSafeSharesStaySafe) {
  const auto scene = cell();
  const auto body = test::bodyOf(*scene->find(1));
  manipulation::EntityConfiguration upright = body->configuration();
  upright.joints = {0.0, -1.5708, 0.0, -1.5708, 0.0, 0.0};
  auto clearances = Clearances::create(scene, 1, upright, {});
  ASSERT_TRUE(clearances) << clearances.error().message();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-2.0, 2.0), step(-0.4, 0.4);
  int near_ones = 0, cut = 0;
  for (int i = 0; i < 60; ++i) {
    manipulation::EntityConfiguration from = body->configuration(), to = from;
    for (std::size_t j = 0; j < 6; ++j) {
      from.joints[j] += 0.5 * angle(random);
      to.joints[j] = from.joints[j] + step(random);
    }
    const double expected = leastDistance(*scene, from);
    double found = 0.5;
    for (const NearPair& pair : clearances->look(from, 0.5)) {
      if (pair.other_link < 0) found = std::min(found, pair.distance);
    }
    EXPECT_NEAR(found, std::min(expected, 0.5), 1e-9);
    if (expected <= 0.0) continue;
    ++near_ones;
    const double share = clearances->safeShare(to);
    cut += share < 1.0 ? 1 : 0;
    for (int k = 0; k <= 20; ++k) {
      manipulation::EntityConfiguration at = from;
      for (std::size_t j = 0; j < 6; ++j) at.joints[j] += share * k / 20.0 * (to.joints[j] - from.joints[j]);
      EXPECT_GT(leastDistance(*scene, at), 0.0);
    }
  }
  EXPECT_GT(near_ones, 20);
  EXPECT_GT(cut, 5);
}

TEST(Clearances, WhatTouchesAtTheStartIsLeftOutWithANote) {
  const auto scene = PreparedScene::prepare(
      {loaded("box:0.1,0.1,0.1", 1, "box", Pose::translation({0.0, 0.0, 0.05})),
       loaded("box:1.0,1.0,0.1", 2, "table", Pose::translation({0.0, 0.0, -0.05})),
       loaded("box:0.1,0.1,0.1", 3, "other", Pose::translation({0.15, 0.0, 0.05}))},
      {}, {});
  auto clearances = Clearances::create(scene, 1, {scene->find(1)->X_WE, {}}, {});
  ASSERT_TRUE(clearances);
  EXPECT_NE(english(clearances->note()).find("table"), std::string::npos);
  const auto& near = clearances->look({scene->find(1)->X_WE, {}}, 0.2);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_NEAR(near[0].distance, 0.05, 1e-9);
  EXPECT_NEAR(near[0].nhat_W.x, -1.0, 1e-9);
  EXPECT_NE(english(clearances->wordsOf(near[0])).find("other"), std::string::npos);
}

TEST(LineOfSight, IsBlockedByWhatIsBetweenUnlessThatIsLookedAt) {
  const auto scene = cell();
  const auto clearances = Clearances::create(scene, 1, test::bodyOf(*scene->find(1))->configuration(), {});
  ASSERT_TRUE(clearances);
  const LineOfSight all(clearances->obstacles()), ignoring(clearances->obstacles(), 2);
  const dvec3 before(-0.66, -1.0, 0.28), behind(-0.66, 1.0, 0.27);
  EXPECT_FALSE(all.isFree(before, behind));
  EXPECT_TRUE(ignoring.isFree(before, behind));
  const dvec3 beside(-0.75 - 0.04, -1.0, 0.25), far(-0.75 - 0.04, 1.0, 0.25);  // 40 mm past the block.
  EXPECT_TRUE(all.isFreeFor(0.035, beside, far));
  EXPECT_FALSE(all.isFreeFor(0.06, beside, far));
  EXPECT_LT(glm::length(*all.middleOf(2) - dvec3(-0.65, 0.0, 0.25)), 1e-9);
  EXPECT_FALSE(all.middleOf(99));
}

}  // namespace
}  // namespace hapticell::agents
