// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/pose_batch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/shapes/shapes.h"

namespace hapticell::collision {
namespace {

struct Balls {
  Scene scene;
  PartIndex moving = 0;
};

/// A ball of 0.1 m that moves, and a box of 0.2 m at the origin.
Balls balls() {
  Balls made;
  made.moving = made.scene.addPart({1, 0}, MeshCollider::build(geometry::makeSphere(0.1)));
  const PartIndex box = made.scene.addPart({2, 0}, MeshCollider::build(geometry::makeBox({0.2, 0.2, 0.2})));
  made.scene.addPair(made.moving, box);
  return made;
}

std::vector<Pose> path(std::size_t count) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(count);
    poses.push_back(Pose::translation({1.0 - s, 0.3 * std::sin(9.0 * s), 0.02}));
  }
  return poses;
}

TEST(PoseBatch, HasTheAnswersOfSingleQueriesForAnyNumberOfThreads) {
  Balls made = balls();
  const auto poses = path(1000);
  PoseBatchOptions options;
  options.threads = 1;
  const PoseBatch one = nearestAtPoses(made.scene, made.moving, poses, options);
  options.threads = 3;
  const PoseBatch three = nearestAtPoses(made.scene, made.moving, poses, options);
  ASSERT_EQ(one.nearest.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(one.nearest[i]->result.distance, three.nearest[i]->result.distance);
    made.scene.setPose(made.moving, poses[i]);
    EXPECT_NEAR(one.nearest[i]->result.distance, made.scene.nearest()->result.distance, 1e-12);
  }
}

TEST(PoseBatch, EndsAtTheFirstContact) {
  const Balls made = balls();
  const auto poses = path(1000);
  PoseBatchOptions options;
  const PoseBatch all = nearestAtPoses(made.scene, made.moving, poses, options);
  std::size_t first = 0;
  while (!all.nearest[first]->result.colliding) ++first;
  options.until_contact = true;
  const PoseBatch ended = nearestAtPoses(made.scene, made.moving, poses, options);
  ASSERT_EQ(ended.nearest.size(), first + 1);
  EXPECT_EQ(ended.query_us.size(), first + 1);
  for (std::size_t i = 0; i <= first; ++i)
    EXPECT_EQ(ended.nearest[i]->result.distance, all.nearest[i]->result.distance);
}

TEST(PoseBatch, ReportsNothingBeyondTheLimit) {
  const Balls made = balls();
  PoseBatchOptions options;
  options.limit = 0.05;
  const PoseBatch batch = nearestAtPoses(made.scene, made.moving, path(10), options);
  EXPECT_FALSE(batch.nearest.front());
  EXPECT_TRUE(nearestAtPoses(made.scene, made.moving, {}, options).nearest.empty());
}

}  // namespace
}  // namespace hapticell::collision
