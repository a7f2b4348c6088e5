// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/jointed_whole.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::manipulation {
namespace {

const Pose kMoved{dvec3(0.1, -0.2, 0.6), quaternionFromRotationVector({0.2, 0.5, -0.1})};
const Pose kPart{dvec3(0.05, 0.0, 0.1), quaternionFromRotationVector({0.0, 0.3, 0.0})};

JointedWhole wholeArm() {
  return {std::make_shared<const kinematics::RobotModel>(kinematics::test::kr120()),
          kMoved,
          {{0, {}}, {3, kPart}, {7, kPart}}};
}

const EntityConfiguration kFrom{Pose::translation({1, 2, 0}), {0.2, -1.2, 1.4, 0.3, 0.7, 0.1}};

TEST(JointedWhole, GoesWithTheHandAndKeepsItsJoints) {
  const JointedWhole whole = wholeArm();
  const Pose X_WM{dvec3(0.4, 0.3, 1.0), quaternionFromRotationVector({1.0, -0.4, 0.2})};
  const EntityConfiguration to = whole.propose(kFrom, X_WM, 0.01);
  EXPECT_LT(glm::length(whole.movedFrame(to).p - X_WM.p), 1e-12);
  EXPECT_EQ(to.joints, kFrom.joints);
  EXPECT_TRUE(whole.limits(to, 1.0, 0.25).empty());
  EXPECT_EQ(whole.leastTime(kFrom, to).seconds, 0.0);
  EXPECT_EQ(whole.leastTime(kFrom, to).joint, -1);
  EXPECT_EQ(whole.resistance(to, std::vector<double>(6, 5.0)), 0.0);
  EXPECT_EQ(whole.postureFinder(), nullptr);
}

TEST(JointedWhole, ItsPartsAreWhereItsLinksAre) {
  const JointedWhole whole = wholeArm();
  const kinematics::RobotModel model = kinematics::test::kr120();
  std::vector<Pose> X_BL, X_WP(3);
  kinematics::forwardKinematics(model, kFrom.joints, X_BL);
  whole.partPoses(kFrom, X_WP);
  EXPECT_LT(glm::length(X_WP[0].p - kFrom.X_WE.p), 1e-12);
  EXPECT_LT(glm::length(X_WP[2] * dvec3(1.0) - kFrom.X_WE * (X_BL[7] * (kPart * dvec3(1.0)))), 1e-12);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(glm::length(whole.partPose(kFrom, k) * dvec3(1.0) - X_WP[k] * dvec3(1.0)), 1e-12);
}

TEST(JointedWhole, PathBoundsHoldWhileBothMove) {
  const JointedWhole whole = wholeArm();
  const std::vector<PartSphere> spheres(3, {{0.1, 0.2, 0.05}, 0.3});
  for (int i = 0; i < 12; ++i) {
    const double size = i < 6 ? 0.02 : 0.5;
    EntityConfiguration to = kFrom;
    for (std::size_t k = 0; k < 6; ++k) to.joints[k] += size * std::sin(2.3 * i + 1.7 * static_cast<double>(k));
    to.X_WE =
        displaced(kFrom.X_WE, {size * dvec3(std::sin(1.0 * i), 0.3, -0.2), size * dvec3(0.4, std::cos(1.0 * i), 1.0)});
    std::vector<double> bounds(3);
    whole.pathBounds(kFrom, to, spheres, bounds);
    for (std::size_t part = 0; part < 3; ++part) {
      double longest = 0.0;
      for (const dvec3& direction : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(-0.6, 0.8, 0)}) {
        double length = 0.0;
        dvec3 before(0.0);
        for (int step = 0; step <= 50; ++step) {
          const Pose X_WP = whole.partPose(whole.between(kFrom, to, step / 50.0), part);
          const dvec3 p_WQ = X_WP * (spheres[part].p_PS + spheres[part].radius * direction);
          if (step > 0) length += glm::distance(p_WQ, before);
          before = p_WQ;
        }
        longest = std::max(longest, length);
      }
      EXPECT_LE(longest, bounds[part] * (1.0 + 1e-9)) << i << ", part " << part;
      EXPECT_LT(bounds[part], 20.0 * longest) << i << ", part " << part;
    }
    double turned = glm::length(difference(to.X_WE, kFrom.X_WE).angular);
    for (std::size_t k = 0; k < 6; ++k) turned += std::abs(to.joints[k] - kFrom.joints[k]);
    EXPECT_NEAR(whole.turnBound(kFrom, to), turned, 1e-9);
    EXPECT_LT(glm::length(whole.movedFrame(whole.between(kFrom, to, 1.0)).p - whole.movedFrame(to).p), 1e-12);
  }
}

TEST(JointedWhole, ItsPartsFollowRigidly) {
  const JointedWhole whole = wholeArm();
  const std::vector<PartDifferential> parts = whole.differentiate(kFrom);
  ASSERT_EQ(parts.size(), 3U);
  const double h = 1e-6;
  for (std::size_t i = 0; i < 6; ++i) {
    Twist step;
    (i < 3 ? step.linear : step.angular)[static_cast<int>(i % 3)] = h;
    const EntityConfiguration to = whole.propose(kFrom, displaced(whole.movedFrame(kFrom), step), 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Twist moved = difference(whole.partPose(to, k), whole.partPose(kFrom, k));
      EXPECT_LT(glm::length(moved.linear / h - parts[k].velocity[i].linear), 1e-5);
      EXPECT_LT(glm::length(moved.angular / h - parts[k].velocity[i].angular), 1e-5);
    }
  }
}

TEST(LimitKind, EachHasItsWord) {
  EXPECT_STREQ(toString(LimitKind::kJoint), "joint");
  EXPECT_STREQ(toString(LimitKind::kReach), "reach");
  EXPECT_STREQ(toString(LimitKind::kSingularity), "singularity");
  EXPECT_STREQ(toString(LimitKind::kLoop), "loop");
  EXPECT_STREQ(toString(LimitKind::kSpeed), "speed");
}

}  // namespace
}  // namespace hapticell::manipulation
