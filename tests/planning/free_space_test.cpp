// SPDX-License-Identifier: Apache-2.0
#include "planning/free_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/shapes/shapes.h"
#include "manipulation/checks/joint_check.h"
#include "planning/own_pair_motion.h"
#include "planning/planned_motion.h"
#include "tests/planning/planning_cells.h"

namespace hapticell::planning {
namespace {

constexpr double kClearance = 0.01;

EntityConfiguration randomAt(const FreeSpace& space, std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-2.5, 2.5);
  EntityConfiguration at = space.present();
  for (double& q : at.joints) q = angle(random);
  return at;
}

TEST(FreeSpace, AgreesWithTheJointCheckAtConfigurations) {
  const auto scene = test::robotCell(true);
  auto space = FreeSpace::create(scene, 1, {});
  ASSERT_TRUE(space) << space.error().message();
  auto check = manipulation::JointCheck::create(scene, 1, {}, manipulation::RestContacts::kLeaveOutLasting);
  ASSERT_TRUE(check);
  space->setClearance(kClearance);
  std::mt19937 random(3);
  int free = 0;
  for (int i = 0; i < 200; ++i) {
    const EntityConfiguration at = randomAt(*space, random);
    const double distance = check->clearance(at.joints, 0.1);
    if (std::abs(distance - kClearance) < 1e-5) continue;
    EXPECT_EQ(space->isFree(at), check->isFree(at.joints, kClearance)) << distance;
    EXPECT_EQ(space->isFree(at), !space->blocker().has_value());
    EXPECT_NEAR(space->clearanceAt(at, 0.1), distance, 1e-9);
    free += space->isFree(at) ? 1 : 0;
  }
  EXPECT_GT(free, 20);
  EXPECT_LT(free, 180);
}

/// A motion that is called free keeps the clearance wherever it is looked at; one that is not comes nearer than 1.15
/// times that, or touches, at one of many places.
TEST(FreeSpace, ProvesWholeMotions) {
  const auto scene = test::robotCell(true);
  auto space = FreeSpace::create(scene, 1, {});
  ASSERT_TRUE(space);
  auto check = manipulation::JointCheck::create(scene, 1, {}, manipulation::RestContacts::kLeaveOutLasting);
  ASSERT_TRUE(check);
  space->setClearance(kClearance);
  std::mt19937 random(5);
  int free = 0, blocked = 0;
  for (int i = 0; i < 60; ++i) {
    const EntityConfiguration from = randomAt(*space, random);
    const EntityConfiguration to = space->between(from, randomAt(*space, random), 0.3);
    const bool is_free = space->isFree(from, to);
    double least = 0.1;
    bool touches = false;
    for (int k = 0; k <= 300; ++k) {
      const auto at = space->between(from, to, k / 300.0);
      least = std::min(least, check->clearance(at.joints, least));
      touches = touches || !check->isFree(at.joints);
    }
    if (is_free) {
      EXPECT_GE(least, kClearance - 1e-6);
      EXPECT_FALSE(touches);
      ++free;
    } else {
      EXPECT_TRUE(touches || least < 1.15 * kClearance) << least;
      ++blocked;
    }
  }
  EXPECT_GT(free, 5);
  EXPECT_GT(blocked, 5);
}

TEST(FreeSpace, NamesWhatIsInTheWay) {
  auto space = FreeSpace::create(test::boxWithBar(0.3), 1, {});
  ASSERT_TRUE(space);
  EXPECT_FALSE(space->hasJoints());
  const EntityConfiguration at = space->present();
  EXPECT_TRUE(space->isFree(at));
  EntityConfiguration beyond = at;
  beyond.X_WE.p.x += 0.5;
  EXPECT_TRUE(space->isFree(beyond));
  EXPECT_FALSE(space->isFree(at, beyond));
  ASSERT_TRUE(space->blocker());
  EXPECT_EQ(space->blocker()->met, "right");
  EXPECT_EQ(space->blocker()->other, 3U);
  EXPECT_EQ(english(space->blocker()->text()), "bar would touch right");
  EXPECT_NEAR(space->clearanceAt(at, 1.0), 0.05, 1e-6);
}

TEST(FreeSpace, AnswersNothingOnceStopped) {
  auto space = FreeSpace::create(test::boxWithBar(0.3), 1, {});
  ASSERT_TRUE(space);
  std::atomic<bool> stop{true};
  space->setStop(&stop);
  EXPECT_FALSE(space->isFree(space->present()));
  EXPECT_FALSE(space->blocker());
  stop = false;
  EXPECT_TRUE(space->isFree(space->present()));
}

TEST(FreeSpace, RefusesWhatItCannotMove) {
  const auto scene = test::boxWithBar(0.3);
  EXPECT_FALSE(FreeSpace::create(scene, 77, {}));
}

/// A ball that stays at (kArm, 0, 0), and one that turns about z on an arm as long: a pair whose way is known.
class TurningBall final : public manipulation::Manipulator {
 public:
  static constexpr double kArm = 0.3, kRadius = 0.05;
  Pose partPose(const EntityConfiguration& at, std::size_t part) const override {
    const double angle = part == 0 ? 0.0 : at.joints[0];
    Pose X_WP = Pose::translation(kArm * dvec3(std::cos(angle), std::sin(angle), 0.0));
    X_WP.q = glm::angleAxis(angle, dvec3(0, 0, 1));
    return X_WP;
  }
  void partPoses(const EntityConfiguration& at, std::span<Pose> X_WP) const override {
    ++asked;
    for (std::size_t i = 0; i < X_WP.size(); ++i) X_WP[i] = partPose(at, i);
  }
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override {
    EntityConfiguration at = from;
    at.joints[0] += s * (to.joints[0] - from.joints[0]);
    return at;
  }
  Pose movedFrame(const EntityConfiguration& at) const override { return partPose(at, 1); }
  EntityConfiguration propose(const EntityConfiguration& from, const Pose&, double) const override { return from; }
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                  std::span<const manipulation::PartSphere>, std::span<double> bounds) const override {
    bounds[0] = 0.0;
    bounds[1] = (kArm + kRadius) * std::abs(to.joints[0] - from.joints[0]);
  }
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override {
    return std::abs(to.joints[0] - from.joints[0]);
  }
  std::vector<manipulation::PartDifferential> differentiate(const EntityConfiguration&) const override { return {}; }
  std::vector<manipulation::MotionLimit> limits(const EntityConfiguration&, double, double) const override {
    return {};
  }
  mutable int asked = 0;
};

EntityConfiguration turnedTo(double angle) {
  return {Pose::identity(), {angle}};
}

TEST(PlannedMotion, GivesThePosesOfTheManipulatorAndAsksOnceForAllParts) {
  const TurningBall ball;
  const EntityConfiguration from = turnedTo(-1.0), to = turnedTo(2.0);
  PlannedMotion motion(ball, from, to, 2);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i <= 64; ++i) {
      for (const std::size_t part : {0u, 1u}) {
        const Pose X_WP = motion.poseOf(part, i / 64.0);
        EXPECT_EQ(X_WP.p, ball.partPose(ball.between(from, to, i / 64.0), part).p) << i;
      }
    }
  }
  EXPECT_EQ(ball.asked, 65) << "each place once, for both parts";
  for (const double s : {0.123, 0.5 + 1.0 / 256.0, 0.999})
    EXPECT_EQ(motion.poseOf(1, s).p, ball.partPose(ball.between(from, to, s), 1).p) << s;
  EXPECT_EQ(ball.asked, 65);
}

TEST(OwnPairMotion, TouchesWhereTheChordIsTwoRadii) {
  const TurningBall ball;
  const auto mesh = collision::MeshCollider::build(geometry::makeSphere(TurningBall::kRadius, 96));
  collision::ProximityQuery query(mesh, mesh);
  const double touching = 2.0 * std::asin(TurningBall::kRadius / TurningBall::kArm);  // 0.335 rad.
  const OwnPair pair{0, 1};
  const auto wayOf = [](double angle) { return (TurningBall::kArm + TurningBall::kRadius) * angle; };
  {
    const EntityConfiguration from = turnedTo(1.5), to = turnedTo(-1.5);
    PlannedMotion motion(ball, from, to, 2);
    EXPECT_TRUE(ownPairTouches(query, pair, motion, wayOf(3.0)));
    const auto stop = leadOwnPair(query, pair, motion, wayOf(3.0));
    EXPECT_TRUE(stop.stopped);
    EXPECT_NEAR(1.5 - 3.0 * stop.s, touching, 3e-3) << "the meshes lie up to 0.05 mm inside the balls";
    // Its second half begins in contact.
    EXPECT_TRUE(leadOwnPair(query, pair, motion, wayOf(3.0), {0.5, 1.0}).began_colliding);
    // The rest, from where they are apart again, is free.
    EXPECT_FALSE(leadOwnPair(query, pair, motion, wayOf(3.0), {0.65, 1.0}).stopped);
  }
  for (const double least : {0.30, 0.33, 0.34, 0.5, 1.0}) {
    const EntityConfiguration from = turnedTo(2.5), to = turnedTo(least);
    PlannedMotion motion(ball, from, to, 2);
    EXPECT_EQ(ownPairTouches(query, pair, motion, wayOf(2.5 - least)), least < touching) << least;
  }
  const Pose X_WA = ball.partPose(turnedTo(1.0), 0), X_WB = ball.partPose(turnedTo(1.0), 1);
  EXPECT_NEAR(spheresApart(query, X_WA, X_WB), 2.0 * TurningBall::kArm * std::sin(0.5) - 2.0 * TurningBall::kRadius, 1e-4);
}

/// Ends that were found free are not asked again; a larger clearance, or pairs that are heeded again, ask anew.
TEST(FreeSpace, WhatIsKnownToBeFreeIsForgottenWithTheClearance) {
  const auto scene = test::boxWithBar(0.3);
  auto space = FreeSpace::create(scene, 1, {});
  ASSERT_TRUE(space);
  EntityConfiguration at = space->present(), up = at;
  up.X_WE.p.z += 0.05;
  space->setClearance(0.02);
  EXPECT_TRUE(space->isFree(at));
  EXPECT_TRUE(space->isFree(at, up));
  EXPECT_TRUE(space->isFree(up));
  space->setClearance(0.06);  // The bar's ends are 0.05 m from the plates.
  EXPECT_FALSE(space->isFree(at));
  EXPECT_FALSE(space->isFree(up));
  EXPECT_FALSE(space->isFree(at, up));
  const auto near = space->gapsAt(up, 0.06);
  ASSERT_FALSE(near.empty());
  space->setChecked(near, false);
  EXPECT_TRUE(space->isFree(up));
  space->setChecked(near, true);
  EXPECT_FALSE(space->isFree(up));
}

}  // namespace
}  // namespace hapticell::planning
