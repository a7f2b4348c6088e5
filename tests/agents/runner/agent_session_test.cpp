// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "manipulation/checks/path_check.h"
#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using Phase = AgentSession::Phase;
using test::boxBeforeWall;

/// Waits; the patience only ends a test that would never end.
bool until(const std::function<bool()>& is_so) {
  constexpr int kPatience = 12000;  // Of 10 ms.
  for (int i = 0; i < kPatience && !is_so(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return is_so();
}

TEST(AgentSession, StepsOneByOneAndWithoutTheAgentsThatAreOff) {
  AgentSession session(boxBeforeWall(false), 1);
  EXPECT_EQ(session.state().phase, Phase::kPaused);
  session.stepOnce();
  ASSERT_TRUE(until([&] { return session.state().steps == 1; }));
  const double moved = session.state().X_WM.p.x;
  EXPECT_GT(moved, 0.0);
  EXPECT_DOUBLE_EQ(session.state().t, AgentLoop::kStep);
  session.setAgent("goal", false, 1.0);
  session.stepOnce();
  ASSERT_TRUE(until([&] { return session.state().steps == 2; }));
  EXPECT_EQ(session.state().X_WM.p.x, moved);
  EXPECT_EQ(session.motion().size(), 3U) << "the start and two steps";
}

TEST(AgentSession, ADeadlockWaitsForThePlannerWhoseWayIsFollowedToTheGoal) {
  const auto cell = boxBeforeWall(false);
  AgentSession session(cell, 1);
  session.run();
  ASSERT_TRUE(until([&] { return session.state().phase == Phase::kDeadlocked; }));
  const auto stuck = session.state();
  EXPECT_NE(english(stuck.says).find("wall"), std::string::npos) << english(stuck.says);
  EXPECT_EQ(stuck.deadlocks, 1);
  EXPECT_LT(stuck.X_WM.p.x, 0.35 + 1e-9) << "before the wall";
  session.askPlanner();
  ASSERT_TRUE(until([&] { return session.state().phase != Phase::kPlanning; }));
  EXPECT_EQ(session.state().plans, 1);
  ASSERT_TRUE(until([&] { return session.state().phase != Phase::kRunning; }));
  EXPECT_EQ(session.state().phase, Phase::kArrived) << english(session.state().says);
  EXPECT_LE(session.state().remaining, cell->task().goal.tolerance);
  const auto found = manipulation::checkPath(cell->scene(), "box", session.motion(), {}, {});
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_GT(found->least_clearance, 0.0);
}

TEST(AgentSession, AHandLeadsOutOfADeadlock) {
  AgentSession session(boxBeforeWall(true), 1);
  session.run();
  ASSERT_TRUE(until([&] { return session.state().phase == Phase::kDeadlocked; }));
  session.setHand(Twist{{0.0, 0.0, 0.2}, dvec3(0.0)});
  session.takeByHand();
  ASSERT_TRUE(until([&] { return session.state().X_WM.p.z > 0.4; }));
  session.setHand({});
  ASSERT_TRUE(until([&] { return session.state().phase != Phase::kRunning; }));
  EXPECT_EQ(session.state().phase, Phase::kArrived) << "over the wall the goal attracts again";
  session.pause();
  EXPECT_NE(session.wishes().find("operator_z"), std::string::npos);
}

TEST(AgentSession, EndsWhileThePlannerIsAsked) {
  AgentSession session(boxBeforeWall(false), 1);
  session.askPlanner();
}

}  // namespace
}  // namespace hapticell::agents
