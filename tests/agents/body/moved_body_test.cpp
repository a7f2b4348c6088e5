// SPDX-License-Identifier: Apache-2.0
#include "agents/body/moved_body.h"

#include <gtest/gtest.h>

#include "agents/body/follow.h"
#include "manipulation/scene/prepared_scene.h"
#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using test::arm;
using test::bodyOf;
using test::loaded;

/// The place of a point of a link after a small step of each variable, against the screw's velocity.
void expectScrewsAreSlopes(const workcell::Entity& entity, const MovedBody& body, int link, double tolerance) {
  const double kStep = 1e-6;
  const auto& at = body.configuration();
  const Pose X_WL = manipulation::PreparedScene::partPose(entity, at.X_WE, at.joints, link);
  const dvec3 p_LQ(0.02, -0.03, 0.05);
  for (std::size_t v = 0; v < body.size(); ++v) {
    std::vector<double> step(body.size(), 0.0);
    step[v] = kStep;
    const auto there = body.moved(step);
    ASSERT_TRUE(there) << body.nameOf(v);
    const auto& to = there->configuration();
    const Pose X_WL2 = manipulation::PreparedScene::partPose(entity, to.X_WE, to.joints, link);
    const dvec3 slope = (X_WL2 * p_LQ - X_WL * p_LQ) / kStep;
    const dvec3 expected = body.carries(v, link) ? body.screws()[v].at(X_WL * p_LQ) : dvec3(0.0);
    EXPECT_LT(glm::length(slope - expected), tolerance) << v << " " << body.nameOf(v);
  }
}

TEST(MovedBody, ScrewsOfARobotAreTheSlopesOfItsLinks) {
  const workcell::Entity robot = arm();
  const auto body = bodyOf(robot);
  for (const char* name : {"upper_arm_link", "wrist_1_link", "tool0"})
    expectScrewsAreSlopes(robot, *body, robot.robot()->findLink(name), 1e-5);
}

TEST(MovedBody, ScrewsOfAMannequinAreTheSlopesOfItsHandAndHead) {
  workcell::Entity worker = loaded("mannequin:male:50", 1, "worker");
  const auto standing = bodyOf(worker);
  // Bent a little, so that no joint is at its end.
  std::vector<double> step(standing->size(), 0.0);
  for (std::size_t v = 6; v < step.size(); ++v) step[v] = 0.05 + 0.01 * static_cast<double>(v % 5);
  step[2] = -0.08;
  const auto body = standing->moved(step);
  ASSERT_TRUE(body);
  const FigureView& figure = *body->figure();
  for (const auto segment : {mannequin::Segment::kRightHand, mannequin::Segment::kHead, mannequin::Segment::kThorax})
    expectScrewsAreSlopes(worker, *body, figure.link_of[mannequin::indexOf(segment)], 2e-4);
}

TEST(MovedBody, AMannequinsFeetStayWhereTheyAre) {
  const workcell::Entity worker = loaded("mannequin:female:50", 1, "worker");
  auto body = bodyOf(worker, "left_hand");
  const Pose before = mannequin::footPose(body->figure()->pose, mannequin::Side::kLeft);
  std::vector<double> step(body->size(), 0.0);
  step[0] = 0.004;
  step[2] = -0.006;
  step[4] = 0.01;
  for (int i = 0; i < 20; ++i) {
    auto there = body->moved(step);
    ASSERT_TRUE(there);
    body = std::move(there);
  }
  const Pose after = mannequin::footPose(body->figure()->pose, mannequin::Side::kLeft);
  EXPECT_LT(glm::length(after.p - before.p), 2e-4);
  EXPECT_LT(body->configuration().X_WE.p.z, -0.03);  // It went down.
}

TEST(MovedBody, FollowMovesThePointAsWished) {
  const auto body = bodyOf(arm());
  const Twist wanted{{0.05, -0.02, 0.03}, {0.1, 0.0, -0.2}};
  const auto v = follow(*body, {body->handleLink(), body->handle().p, wanted, true});
  std::vector<double> step(v);
  for (double& one : step) one *= 1e-4;
  const auto there = body->moved(step);
  const Twist made = difference(there->handle(), body->handle());
  EXPECT_LT(glm::length(made.linear / 1e-4 - wanted.linear), 0.01);
  EXPECT_LT(glm::length(made.angular / 1e-4 - wanted.angular), 0.03);
  EXPECT_LT(glm::length(velocityOf(*body, body->handleLink(), body->handle().p, v) - made.linear / 1e-4), 1e-3);
}

TEST(MovedBody, SolidsAreMovedByTheirMiddle) {
  const workcell::Entity box = loaded("box:0.1,0.2,0.3", 1, "box", Pose::translation({1.0, 0.0, 0.0}));
  const auto body = bodyOf(box);
  const auto there = body->moved(std::vector<double>{0.1, 0.0, 0.0, 0.0, 0.0, 0.5});
  EXPECT_LT(glm::length(there->handle().p - dvec3(1.1, 0.0, 0.0)), 1e-12);
  EXPECT_NEAR(glm::length(difference(there->handle(), body->handle()).angular), 0.5, 1e-12);
}

TEST(MovedBody, RefusesWhatItCannotMove) {
  workcell::Entity locked = arm();
  locked.locked = true;
  EXPECT_NE(MovedBody::create(locked, "").error().message().find("locked"), std::string::npos);
  EXPECT_NE(MovedBody::create(arm(), "right_hand").error().message().find("expected tcp"), std::string::npos);
  const auto delta = MovedBody::create(loaded("library:omnid_delta", 1, "delta"), "");
  ASSERT_FALSE(delta);
  EXPECT_NE(delta.error().message().find("closed loops"), std::string::npos);
}

TEST(MovedBody, TheLeastSingularValueFallsToZeroAtASingularPlace) {
  workcell::Entity robot = arm();
  EXPECT_GT(leastSingularValue(*bodyOf(robot)), 0.05);
  robot.setJoints({0.3, -1.2, 1.4, -1.6, 0.0, 0.2});  // The wrist is stretched.
  EXPECT_LT(leastSingularValue(*bodyOf(robot)), 1e-6);
}

}  // namespace
}  // namespace hapticell::agents
