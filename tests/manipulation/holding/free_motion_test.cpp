// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/free_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/shapes/shapes.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "manipulation/manipulators/robot_manipulator.h"
#include "manipulation/manipulators/solid_manipulator.h"

namespace hapticell::manipulation {
namespace {

EntityConfiguration at(const dvec3& p, const dvec3& turn = dvec3(0.0)) {
  return {Pose{p, quaternionFromRotationVector(turn)}, {}};
}

/// A box of 60 mm that stands on a table whose top is z = 0, guarded upwards.
struct StandingBox {
  StandingBox()
      : motion({collision::MeshCollider::build(geometry::makeBox(dvec3(0.06)))},
               {{collision::MeshCollider::build(geometry::makeBox({1.0, 1.0, 0.1})), Pose::translation({0, 0, -0.05})}},
               {{0, 0, true}}) {
    motion.reset(box, at({0, 0, 0.03}));
    motion.guard(0, {0, 0, 1});
  }
  SolidManipulator box{Pose::identity(), {Pose::identity()}};
  FreeMotion motion;
};

TEST(FreeMotionGuard, StopsWhatTouchesFromSinkingIn) {
  StandingBox standing;
  ASSERT_TRUE(standing.motion.isSoft(0));
  const MotionAnswer answer = standing.motion.advance(standing.box, at({0, 0, 0.03}), at({0.01, 0, 0.025}));
  EXPECT_TRUE(answer.blocked);
  EXPECT_LE(answer.s * 0.005, FreeMotion::kGuard);
  EXPECT_NEAR(answer.contact.nhat_BA_W.z, 1.0, 1e-9);
}

TEST(FreeMotionGuard, StopsACornerThatTurnsIn) {
  StandingBox standing;
  const MotionAnswer answer = standing.motion.advance(standing.box, at({0, 0, 0.03}), at({0, 0, 0.031}, {0.2, 0, 0}));
  EXPECT_TRUE(answer.blocked);
  // The corner sinks by 30 mm a radian while the box rises by 1 mm.
  EXPECT_LE(answer.s * (0.03 * 0.2 - 0.001), 1.1 * FreeMotion::kGuard);
}

TEST(FreeMotionGuard, LetsItSlideAndLeave) {
  StandingBox standing;
  EXPECT_EQ(standing.motion.advance(standing.box, at({0, 0, 0.03}), at({0.1, 0, 0.03})).s, 1.0);
  EXPECT_EQ(standing.motion.advance(standing.box, at({0.1, 0, 0.03}), at({0.1, 0, 0.04})).s, 1.0);
  EXPECT_FALSE(standing.motion.isSoft(0));
  EXPECT_TRUE(standing.motion.advance(standing.box, at({0.1, 0, 0.04}), at({0.1, 0, 0.02})).blocked);
}

/// Four links of 0.2 m about changing axes, each a bar.
struct Arm {
  static constexpr int kLinks = 4;
  Arm() {
    kinematics::RobotModel model;
    model.name = "arm";
    model.links.emplace_back();
    model.links.back().name = "root";
    for (int i = 0; i < kLinks; ++i) {
      kinematics::Joint joint;
      joint.name = "j" + std::to_string(i);
      joint.type = kinematics::JointType::kRevolute;
      joint.parent_link = i;
      joint.child_link = i + 1;
      joint.X_PJ = Pose::translation({0, 0, i == 0 ? 0.0 : 0.2});
      joint.axis_J = i % 2 == 0 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
      joint.lower = -2.5;
      joint.upper = 2.5;
      joint.variable = i;
      model.moving.push_back(i);
      model.joints.push_back(joint);
      kinematics::Link link;
      link.name = "l" + std::to_string(i);
      link.parent_joint = i;
      model.links.push_back(link);
      auto bar = geometry::makeCylinder(0.03, 0.16, 16);
      for (dvec3& p : bar.vertices) p.z += 0.1;
      parts.push_back(collision::MeshCollider::build(bar));
    }
    const auto robot = std::make_shared<const kinematics::RobotModel>(std::move(model));
    auto inverse = kinematics::createInverse(*robot, kLinks, Pose::identity(), {});
    manipulator = std::make_unique<RobotManipulator>(robot, RobotManipulator::Tool{kLinks, {}}, std::move(*inverse),
                                                     RobotManipulator::partsOf({1, 2, 3, 4}));
  }
  std::vector<std::shared_ptr<const collision::MeshCollider>> parts;
  std::unique_ptr<RobotManipulator> manipulator;
};

/// Random motions of an arm among boxes, its links against those and against each other: what FreeMotion keeps from one
/// step to the next (near pairs, lower bounds) must not change where it stops, and it stops short of everything.
TEST(FreeMotionWithLinks, AnswersAsIfItHadKeptNothing) {
  Arm arm;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto box = collision::MeshCollider::build(geometry::makeBox({0.08, 0.1, 0.06}));
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 14; ++i) {
    const double around = 2.0 * std::numbers::pi * i / 14.0, away = 0.3 + 0.25 * std::abs(unit(random));
    obstacles.push_back({box,
                         {{away * std::cos(around), away * std::sin(around), 0.6 * unit(random)},
                          quaternionFromRotationVector({unit(random), unit(random), unit(random)})}});
  }
  std::vector<MotionPair> pairs;
  for (std::uint32_t part = 0; part < Arm::kLinks; ++part) {
    for (std::uint32_t k = 0; k < obstacles.size(); ++k) pairs.push_back({part, k, true});
    for (std::uint32_t other = part + 2; other < Arm::kLinks; ++other)
      pairs.push_back({part, 0, true, static_cast<int>(other)});
  }
  EntityConfiguration now{Pose::identity(), {0.0, 0.0, 0.0, 0.0}};
  FreeMotion kept(arm.parts, obstacles, pairs);
  kept.reset(*arm.manipulator, now);
  ASSERT_FALSE(kept.anySoft());
  // The exact distance of a pair with nothing kept.
  std::vector<Pose> X_WP(Arm::kLinks);
  const auto exact = [&](const MotionPair& pair, const EntityConfiguration& at) {
    arm.manipulator->partPoses(at, X_WP);
    const int other = pair.other_part;
    const auto& met = other < 0 ? obstacles[pair.obstacle].collider : arm.parts[static_cast<std::size_t>(other)];
    const Pose& X_WO = other < 0 ? obstacles[pair.obstacle].X_WO : X_WP[static_cast<std::size_t>(other)];
    return collision::distance(arm.parts[pair.part], X_WP[pair.part], met, X_WO).distance;
  };
  int blocked = 0, moved = 0;
  std::vector<double> way(Arm::kLinks);
  for (int step = 0; step < 400; ++step) {
    // Runs of small steps one way, now and then a large one.
    const double length = step % 40 == 0 ? 1.0 : 0.04;
    if (step % 8 == 0) {
      for (double& w : way) w = unit(random);
    }
    EntityConfiguration next = now;
    for (std::size_t j = 0; j < way.size(); ++j)
      next.joints[j] = std::clamp(now.joints[j] + length * way[j], -2.4, 2.4);
    FreeMotion fresh(arm.parts, obstacles, pairs);
    fresh.reset(*arm.manipulator, now);
    const MotionAnswer without = fresh.advance(*arm.manipulator, now, next);
    const MotionAnswer with = kept.advance(*arm.manipulator, now, next);
    ASSERT_EQ(with.blocked, without.blocked) << step;
    EXPECT_NEAR(with.s, without.s, 2e-2) << step;
    const EntityConfiguration end = arm.manipulator->between(now, next, with.s);
    double least = 1.0;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const EntityConfiguration at = arm.manipulator->between(now, next, share * with.s);
      for (const MotionPair& pair : pairs) least = std::min(least, exact(pair, at));
    }
    EXPECT_GT(least, 0.0) << step;
    if (with.blocked) {
      EXPECT_NEAR(exact(pairs[with.pair], end), with.contact.distance, 1e-9) << step;
      EXPECT_LT(with.contact.distance, 20 * FreeMotion::kStandOff) << step;
      ++blocked;
    }
    moved += with.s > 0.5;
    now = end;
  }
  EXPECT_GT(blocked, 20);
  EXPECT_GT(moved, 150);
}

/// Boxes here and there in a hall, so that most are far from the ball: each for itself says the same as all together.
TEST(FreeMotion, WhatIsFarStillStopsWhenItComesNear) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto ball = collision::MeshCollider::build(geometry::makeSphere(0.05, 12));
  const auto block = collision::MeshCollider::build(geometry::makeBox({0.2, 0.1, 0.1}));
  std::vector<Obstacle> obstacles;
  std::vector<MotionPair> pairs;
  for (std::uint32_t i = 0; i < 150; ++i) {
    const dvec3 p = 2.0 * dvec3(unit(random), unit(random), unit(random));
    if (glm::length(p) > 0.3) obstacles.push_back({block, Pose::translation(p)});
  }
  for (std::uint32_t i = 0; i < obstacles.size(); ++i) pairs.push_back({0, i, true});
  const SolidManipulator manipulator(Pose::identity(), {Pose::identity()});
  FreeMotion motion({ball}, obstacles, pairs);
  EntityConfiguration now = at(dvec3(0.0));
  motion.reset(manipulator, now);
  int blocked = 0;
  std::vector<FreeMotion::PairDistance> near;
  for (int step = 0; step < 400; ++step) {
    if (step % 7 == 0) {
      const auto i = static_cast<std::uint32_t>(random() % obstacles.size());
      const Pose X = Pose::translation(2.0 * dvec3(unit(random), unit(random), unit(random)));
      if (collision::distance(ball, now.X_WE, block, X).distance > 0.01) {
        obstacles[i].X_WO = X;
        motion.moveObstacle(i, X);
      }
    }
    const double length = step % 3 == 0 ? 1.0 : 0.02;
    const dvec3 wanted = now.X_WE.p + length * dvec3(unit(random), unit(random), unit(random));
    const EntityConfiguration next = at(glm::clamp(wanted, dvec3(-2.0), dvec3(2.0)));
    double first = 1.0;
    for (const Obstacle& obstacle : obstacles) {
      collision::ProximityQuery query(ball, obstacle.collider);
      first = std::min(first, collision::advance(query, collision::straightMotion(now.X_WE, next.X_WE, *ball),
                                                 collision::standingStill(obstacle.X_WO), {FreeMotion::kStandOff})
                                  .s);
    }
    const MotionAnswer answer = motion.advance(manipulator, now, next);
    ASSERT_NEAR(answer.s, first, 1e-4 / std::max(1e-3, glm::distance(now.X_WE.p, next.X_WE.p))) << step;
    blocked += answer.blocked;
    now = manipulator.between(now, next, answer.s);
    const double limit = step % 5 == 0 ? 0.7 : 0.05;
    motion.distances(limit, near);
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
      const double exact = collision::distance(ball, now.X_WE, block, obstacles[i].X_WO).distance;
      if (exact >= limit) continue;
      ASSERT_LT(found, near.size());
      EXPECT_EQ(near[found].pair, i) << "in the order of the pairs";
      EXPECT_NEAR(near[found++].result.distance, exact, 1e-9);
    }
    EXPECT_EQ(found, near.size());
  }
  EXPECT_GT(blocked, 20);
}

}  // namespace
}  // namespace hapticell::manipulation
