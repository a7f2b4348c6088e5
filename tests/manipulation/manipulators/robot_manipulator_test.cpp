// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/robot_manipulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "kinematics/closed_form/inverse_factory.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::manipulation {
namespace {

RobotManipulator manipulatorOf(const std::shared_ptr<const kinematics::RobotModel>& model) {
  const int tip = model->defaultTip();
  auto inverse = kinematics::createInverse(*model, tip);
  EXPECT_TRUE(inverse);
  return {model, RobotManipulator::Tool{tip, Pose::identity()}, std::move(*inverse), RobotManipulator::partsOf({tip})};
}

double largestStep(const EntityConfiguration& a, const EntityConfiguration& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.joints.size(); ++i) largest = std::max(largest, std::abs(a.joints[i] - b.joints[i]));
  return largest;
}

TEST(RobotManipulator, ArrivesWhereTheHandAsksInOneStep) {
  const auto model = std::make_shared<const kinematics::RobotModel>(kinematics::test::kr120());
  const RobotManipulator manipulator = manipulatorOf(model);
  const EntityConfiguration from{Pose::translation({1, 2, 0}), {0.2, -1.2, 1.4, 0.3, 0.7, 0.1}};
  const Pose X_WM = displaced(manipulator.movedFrame(from), {{0.02, -0.01, 0.015}, {0.02, 0.01, -0.03}});
  const EntityConfiguration to = manipulator.propose(from, X_WM, 0.1);
  EXPECT_LT(glm::length(manipulator.movedFrame(to).p - X_WM.p), 1e-9);
  EXPECT_LT(largestStep(from, to), 0.1);
}

// Joint 5 passes zero beside its axis: the exact answer swings joints 4 and 6 by nearly half a turn between two steps.
TEST(RobotManipulator, SwingsTheWristRoundWithoutAJump) {
  const auto model = std::make_shared<const kinematics::RobotModel>(kinematics::test::kr120());
  const RobotManipulator manipulator = manipulatorOf(model);
  EntityConfiguration now{Pose::identity(), {0.0, -1.3, 1.4, 0.0, 0.06, 0.0}};
  const Pose X_0 = manipulator.movedFrame(now);
  // About the lower arm's axes: axis 5 is y at these joints, a little about z keeps the path beside j5 = 0.
  double worst_position = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double s = std::min(1.0, i / 500.0);
    const Pose X_WM =
        displaced(X_0, {dvec3(0.0), s * dvec3(0.0, -0.12, 0.0) + std::sin(std::numbers::pi * s) * dvec3(0, 0, 2e-3)});
    const EntityConfiguration next = manipulator.propose(now, X_WM, 5e-3);
    ASSERT_LE(largestStep(now, next), 3.0 * 5e-3 + 1e-12) << i;
    ASSERT_LE(manipulator.leastTime(now, next).seconds, 5e-3 + 1e-12);
    worst_position = std::max(worst_position, glm::length(manipulator.movedFrame(next).p - X_WM.p));
    now = next;
  }
  EXPECT_LT(worst_position, 2e-4);
  EXPECT_LT(glm::length(manipulator.movedFrame(now).p - X_0.p), 1e-6);
}

TEST(RobotManipulator, PathBoundsHoldAndAreNotLoose) {
  const auto model = std::make_shared<const kinematics::RobotModel>(kinematics::test::kr120());
  const RobotManipulator manipulator = manipulatorOf(model);
  const std::vector<PartSphere> spheres{{{0.1, 0.2, 0.05}, 0.3}};
  for (int i = 0; i < 40; ++i) {
    EntityConfiguration from{Pose::translation({1, 2, 0}), {0.2, -1.2, 1.4, 0.3, 0.7, 0.1}}, to = from;
    const double size = i < 20 ? 0.002 : 0.5;
    for (std::size_t k = 0; k < 6; ++k) to.joints[k] += size * std::sin(2.3 * i + 1.7 * static_cast<double>(k));
    double bound = 0.0;
    manipulator.pathBounds(from, to, spheres, {&bound, 1});
    double longest = 0.0;
    for (const dvec3& direction : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(-0.6, 0.8, 0)}) {
      double length = 0.0;
      dvec3 before{0.0};
      for (int step = 0; step <= 50; ++step) {
        Pose X_WP;
        manipulator.partPoses(manipulator.between(from, to, step / 50.0), {&X_WP, 1});
        const dvec3 p_WQ = X_WP * (spheres[0].p_PS + spheres[0].radius * direction);
        if (step > 0) length += glm::distance(p_WQ, before);
        before = p_WQ;
      }
      longest = std::max(longest, length);
    }
    EXPECT_LE(longest, bound) << i;
    // Joints that turn against each other cancel in the path only.
    if (i < 20) {
      EXPECT_LT(bound, 8.0 * longest) << i;
    }
  }
}

TEST(RobotManipulator, RestsOutOfReachAndSaysWhy) {
  const auto model = std::make_shared<const kinematics::RobotModel>(kinematics::test::kr120());
  const RobotManipulator manipulator = manipulatorOf(model);
  EntityConfiguration now{Pose::identity(), {0.0, -1.0, 1.0, 0.0, 0.6, 0.0}};
  const Pose X_0 = manipulator.movedFrame(now);
  EntityConfiguration before = now;
  for (int i = 0; i < 400; ++i) {
    before = now;
    now = manipulator.propose(now, {X_0.p + dvec3(0.01 * i, 0.0, 0.0), X_0.q}, 0.02);
    ASSERT_LE(largestStep(before, now), 3.0 * 0.02 + 1e-12) << i;
  }
  EXPECT_LT(largestStep(before, now), 0.02);
  const std::vector<MotionLimit> limits = manipulator.limits(now, 0.05, 0.25);
  ASSERT_FALSE(limits.empty());
  EXPECT_FALSE(limits[0].text.empty());
}

}  // namespace
}  // namespace hapticell::manipulation
