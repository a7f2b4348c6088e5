// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_session.h"

#include <gtest/gtest.h>

#include "manipulation/checks/path_check.h"
#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using Phase = AgentSession::Phase;
using test::boxBeforeWall;

constexpr double kPatience = 120.0;  // s; only ends a test that would never end.

bool reaches(const AgentSession& session, Phase phase) {
  return session.waitUntil([phase](const AgentSession::State& state) { return state.phase == phase; }, kPatience);
}
bool leaves(const AgentSession& session, Phase phase) {
  return session.waitUntil([phase](const AgentSession::State& state) { return state.phase != phase; }, kPatience);
}
bool makes(const AgentSession& session, std::size_t steps) {
  return session.waitUntil([steps](const AgentSession::State& state) { return state.steps == steps; }, kPatience);
}

TEST(AgentSession, StepsOneByOneAndWithoutTheAgentsThatAreOff) {
  AgentSession session(boxBeforeWall(false), 1);
  EXPECT_EQ(session.state().phase, Phase::kPaused);
  session.stepOnce();
  ASSERT_TRUE(makes(session, 1));
  const double moved = session.state().X_WM.p.x;
  EXPECT_GT(moved, 0.0);
  EXPECT_DOUBLE_EQ(session.state().t, AgentLoop::kStep);
  session.setAgent("goal", false, 1.0);
  session.stepOnce();
  ASSERT_TRUE(makes(session, 2));
  EXPECT_EQ(session.state().X_WM.p.x, moved);
  EXPECT_EQ(session.motion().size(), 3U) << "the start and two steps";
}

TEST(AgentSession, ADeadlockWaitsForThePlannerWhoseWayIsFollowedToTheGoal) {
  const auto cell = boxBeforeWall(false);
  AgentSession session(cell, 1);
  session.run();
  ASSERT_TRUE(reaches(session, Phase::kDeadlocked));
  const auto stuck = session.state();
  EXPECT_NE(english(stuck.says).find("wall"), std::string::npos) << english(stuck.says);
  EXPECT_EQ(stuck.deadlocks, 1);
  EXPECT_LT(stuck.X_WM.p.x, 0.35 + 1e-9) << "before the wall";
  session.askPlanner();
  ASSERT_TRUE(leaves(session, Phase::kPlanning));
  EXPECT_EQ(session.state().plans, 1);
  ASSERT_TRUE(leaves(session, Phase::kRunning));
  EXPECT_EQ(session.state().phase, Phase::kArrived) << english(session.state().says);
  EXPECT_LE(session.state().remaining, cell->task().goal.tolerance);
  const auto found = manipulation::checkPath(cell->scene(), "box", session.motion(), {}, {});
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_GT(found->least_clearance, 0.0);
}

TEST(AgentSession, AHandLeadsOutOfADeadlock) {
  AgentSession session(boxBeforeWall(true), 1);
  session.run();
  ASSERT_TRUE(reaches(session, Phase::kDeadlocked));
  session.setHand(Twist{{0.0, 0.0, 0.2}, dvec3(0.0)});
  session.takeByHand();
  ASSERT_TRUE(session.waitUntil([](const AgentSession::State& state) { return state.X_WM.p.z > 0.4; }, kPatience));
  session.setHand({});
  ASSERT_TRUE(leaves(session, Phase::kRunning));
  EXPECT_EQ(session.state().phase, Phase::kArrived) << "over the wall the goal attracts again";
  session.pause();
  EXPECT_NE(session.wishes().find("operator_z"), std::string::npos);
}

TEST(AgentSession, WaitingEndsWithItsTime) {
  const AgentSession session(boxBeforeWall(false), 1);
  EXPECT_FALSE(session.waitUntil([](const AgentSession::State& state) { return state.steps > 0; }, 0.001)) << "it is paused";
}

TEST(AgentSession, EndsWhileThePlannerIsAsked) {
  AgentSession session(boxBeforeWall(false), 1);
  session.askPlanner();
}

}  // namespace
}  // namespace hapticell::agents
