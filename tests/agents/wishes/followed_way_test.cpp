// SPDX-License-Identifier: Apache-2.0
#include "agents/wishes/followed_way.h"

#include <gtest/gtest.h>

#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using test::bodyOf;
using test::loaded;

constexpr double kStep = 0.02;  // s

/// Moves the body along the way until it is done; the number of steps, at most `most`.
int follow(FollowedWay& way, std::unique_ptr<MovedBody>& body, int most) {
  int steps = 0;
  for (; !way.isDone() && steps < most; ++steps) {
    std::vector<double> step = way.velocities(*body, 0.25, 1.0);
    for (double& one : step) one *= kStep;
    if (auto there = body->moved(step)) body = std::move(there);
    way.update(*body);
  }
  return steps;
}

TEST(FollowedWay, AnEmptyOneIsDone) {
  FollowedWay way;
  EXPECT_TRUE(way.isDone());
  EXPECT_EQ(way.remaining(*bodyOf(loaded("box:0.1,0.1,0.1", 1, "box"))), 0.0);
}

TEST(FollowedWay, LeadsAFrameOverItsStops) {
  auto body = bodyOf(loaded("box:0.1,0.1,0.1", 1, "box"));
  const dvec3 p_W0 = body->handle().p;
  FollowedWay way({{Pose::translation(p_W0 + dvec3(0.3, 0.0, 0.0)), {}},
                   {Pose::translation(p_W0 + dvec3(0.3, 0.4, 0.0)), {}}},
                  false);
  EXPECT_NEAR(way.remaining(*body), 0.7, 1e-9);
  const std::vector<double> v = way.velocities(*body, 0.25, 1.0);
  EXPECT_NEAR(v[0], 0.25, 1e-3);
  EXPECT_NEAR(v[1], 0.0, 1e-6);
  // A quarter of a metre a second; the last stretch before a stop is slower.
  const int steps = follow(way, body, 1000);
  EXPECT_GE(steps, static_cast<int>((0.7 - 0.06) / 0.25 / kStep));
  EXPECT_LT(steps, 250);
  EXPECT_TRUE(way.isDone());
  EXPECT_LT(glm::length(body->handle().p - p_W0 - dvec3(0.3, 0.4, 0.0)), 0.03);
  EXPECT_EQ(way.remaining(*body), 0.0);
}

TEST(FollowedWay, PassesCornersAtFullSpeedAndSlowsDownAtTheEnd) {
  const auto body = bodyOf(loaded("box:0.1,0.1,0.1", 1, "box"));
  const dvec3 p_W0 = body->handle().p;
  const FollowedWay::Stop near{Pose::translation(p_W0 + dvec3(0.03, 0.0, 0.0)), {}};
  const FollowedWay::Stop corner{Pose::translation(p_W0 + dvec3(0.03, 0.4, 0.0)), {}};
  EXPECT_NEAR(FollowedWay({near}, false).velocities(*body, 0.25, 1.0)[0], 5.0 * 0.03, 1e-3);
  EXPECT_NEAR(FollowedWay({near, corner}, false).velocities(*body, 0.25, 1.0)[0], 0.25, 1e-3);
}

TEST(FollowedWay, LeadsARobotStraightBetweenJoints) {
  auto body = bodyOf(test::arm());
  const std::vector<double> from = body->configuration().joints;
  std::vector<double> to = from;
  to[0] += 0.4;
  to[3] -= 0.2;
  FollowedWay way({{body->handle(), to}}, true);
  EXPECT_NEAR(way.remaining(*body), 0.6, 1e-9);
  const std::vector<double> v = way.velocities(*body, 0.25, 1.0);
  EXPECT_NEAR(v[3], -0.5 * v[0], 1e-9);  // Both arrive together.
  for (std::size_t i = 0; i < v.size(); ++i) EXPECT_LE(std::abs(v[i]), body->speed(i) + 1e-9);
  follow(way, body, 1000);
  EXPECT_TRUE(way.isDone());
  for (std::size_t i = 0; i < to.size(); ++i) EXPECT_NEAR(body->configuration().joints[i], to[i], 0.021);
}

}  // namespace
}  // namespace hapticell::agents
