// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "agents/runner/agent_loop.h"
#include "agents/runner/agent_run.h"
#include "agents/runner/deadlock_watch.h"
#include "agents/runner/planned_way.h"
#include "agents/runner/run_recorder.h"
#include "agents/wishes/operator_agent.h"
#include "collision/queries/proximity_query.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/path_check.h"
#include "tests/agents/test_bodies.h"
#include "tests/support/test_data.h"

namespace hapticell::agents {
namespace {

using manipulation::PreparedScene;
using test::bodyOf;
using test::boxBeforeWall;
using test::loaded;

std::shared_ptr<const AgentCell> shipped(const char* task) {
  auto cell = AgentCell::load(hapticell::test::sourceFile(std::string("config/agents/") + task), {});
  EXPECT_TRUE(cell) << (cell ? "" : cell.error().message());
  return *cell;
}

/// Least distance between the moved entity and the cell over the motion, looked at `between` times between frames by
/// single queries of poses from the playback: none of the code of agents, nor of checks.
double leastDistance(const AgentCell& cell, const trajectory::Trajectory& motion, std::size_t every, int between) {
  std::vector<std::shared_ptr<const workcell::Entity>> entities;
  for (const auto& entity : cell.scene()->entities()) entities.push_back(std::make_shared<workcell::Entity>(entity));
  const auto replay = manipulation::MotionReplay::create(entities, motion.entity,
                                                         std::make_shared<trajectory::Trajectory>(motion));
  EXPECT_TRUE(replay);
  double least = 1.0;
  for (std::size_t i = 0; i + 1 < motion.size(); i += every) {
    for (int k = 0; k < between; ++k) {
      const double t = motion[i].t + k * (motion[i + 1].t - motion[i].t) / between;
      const auto at = replay->at(t);
      for (const auto& part : cell.scene()->partsOf(cell.entity().id)) {
        const Pose X_WP = PreparedScene::partPose(cell.entity(), at.X_WE, at.joints, part.link);
        for (const auto& other : cell.scene()->parts()) {
          if (other.entity == cell.entity().id || !cell.scene()->isChecked(part, other)) continue;
          const workcell::Entity& owner = *cell.scene()->find(other.entity);
          if (!owner.attachment.to.empty() || owner.name == "pedestal") continue;
          const auto found = collision::distance(part.mesh.collider, X_WP, other.mesh.collider, owner.X_WE, least);
          if (!found.beyond_limit) least = std::min(least, found.colliding ? 0.0 : found.distance);
        }
      }
    }
  }
  return least;
}

TEST(AgentRuns, ARobotFindsItsWayThroughTheFieldWithoutContact) {
  const auto cell = shipped("obstacle-field.toml");
  const RecordedRun run = recordRun(*cell, 0, RunMode::kBoth, {});
  EXPECT_TRUE(run.result.solved) << english(run.result.reason);
  EXPECT_GE(run.result.clearance_m, 0.0);
  EXPECT_GE(leastDistance(*cell, run.motion, 5, 2), cell->task().clearance - 1e-3);
  manipulation::PathCheckOptions check;
  const auto found = manipulation::checkPath(cell->scene(), "robot", run.motion, check, {});
  ASSERT_TRUE(found) << found.error().message();
  for (const auto& finding : found->findings) EXPECT_NE(finding.kind, manipulation::PathFinding::Kind::kCollision);
  EXPECT_NE(run.wishes_csv.find("goal_x"), std::string::npos);
}

TEST(AgentRuns, AMannequinReachesTheBottleInTheTrunkAndSeesIt) {
  const auto cell = shipped("trunk-access.toml");
  const RecordedRun run = recordRun(*cell, 0, RunMode::kBoth, {});
  EXPECT_TRUE(run.result.solved) << english(run.result.reason);
  EXPECT_GE(run.result.seen, 0.5);
  EXPECT_GT(run.result.balance_m, 0.0);
  EXPECT_GT(leastDistance(*cell, run.motion, 10, 2), 1e-3);
  manipulation::PathCheckOptions check;
  check.hold.moved_by = manipulation::by::Whole{};
  const auto found = manipulation::checkPath(cell->scene(), "worker", run.motion, check, {});
  ASSERT_TRUE(found) << found.error().message();
  for (const auto& finding : found->findings) EXPECT_NE(finding.kind, manipulation::PathFinding::Kind::kCollision);
  EXPECT_GT(found->least_clearance, 0.0);
  // The same motion through a cell with a ball where the hand arrives: the check sees it, as it sees the whole body move.
  std::vector<workcell::Entity> entities = cell->scene()->entities();
  const dvec3 p_WHand = cell->task().goal.p_WG;
  entities.push_back(loaded("sphere:0.06", 900, "ball", Pose::translation(p_WHand)));
  const auto other = manipulation::checkPath(PreparedScene::prepare(std::move(entities), {}, {}), "worker", run.motion,
                                             check, {});
  ASSERT_TRUE(other) << other.error().message();
  EXPECT_TRUE(std::any_of(other->findings.begin(), other->findings.end(), [](const auto& finding) {
    return finding.kind == manipulation::PathFinding::Kind::kCollision && finding.second == "ball";
  }));
}

TEST(AgentRuns, TheSameSeedGivesTheSameBitsOnAnyNumberOfThreads) {
  const auto cell = shipped("obstacle-field.toml");
  const std::atomic<bool> cancelled{false};
  const auto one = runAgents(*cell, 2, {RunMode::kAgents}, {}, 1, cancelled, {});
  const auto two = runAgents(*cell, 2, {RunMode::kAgents}, {}, 2, cancelled, {});
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(two.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one[i].time_s, two[i].time_s);
    EXPECT_EQ(one[i].way_m, two[i].way_m);
    EXPECT_EQ(one[i].clearance_m, two[i].clearance_m);
  }
  EXPECT_NE(one[0].way_m, one[1].way_m);
  RunOptions other;
  other.seed = 2;
  EXPECT_NE(runOnce(*cell, 0, RunMode::kAgents, other).way_m, one[0].way_m);
}

TEST(AgentRuns, WeightsOfUnknownAgentsAreRefused) {
  const auto cell = shipped("obstacle-field.toml");
  RunOptions options;
  options.weights["goul"] = 1.0;
  const auto checked = checkWeights(cell->task(), options);
  ASSERT_FALSE(checked);
  EXPECT_NE(checked.error().message().find("goal, obstacles"), std::string::npos);
  options.weights = {{"goal", 0.5}};
  EXPECT_TRUE(checkWeights(cell->task(), options));
}

TEST(AgentRuns, ADeadlockIsRecognisedAndHandedOver) {
  RunOptions without_planner;
  without_planner.planner = false;
  const RunResult alone = runOnce(*boxBeforeWall(false), 0, RunMode::kAgents, without_planner);
  EXPECT_FALSE(alone.solved);
  EXPECT_EQ(alone.deadlocks, 1);
  EXPECT_LT(alone.time_s, 10.0);
  EXPECT_NE(english(alone.reason).find("no progress"), std::string::npos);
  EXPECT_NE(english(alone.reason).find("wall"), std::string::npos) << english(alone.reason);
  EXPECT_GE(alone.clearance_m, 0.0025);
  const RunResult led = runOnce(*boxBeforeWall(true), 0, RunMode::kBoth, {});
  EXPECT_TRUE(led.solved) << english(led.reason);
  EXPECT_GE(led.clearance_m, 0.0025);
}

TEST(AgentRuns, ADeadlockWithoutAnOperatorGoesToThePlanner) {
  const auto cell = boxBeforeWall(false);
  const RecordedRun run = recordRun(*cell, 0, RunMode::kAgents, {});
  EXPECT_TRUE(run.result.solved) << english(run.result.reason);
  EXPECT_GE(run.result.plans, 1);
  ASSERT_FALSE(run.result.handed_over.empty());
  EXPECT_NE(english(run.result.handed_over.front()).find("planner"), std::string::npos);
  EXPECT_GT(leastDistance(*cell, run.motion, 1, 2), 0.0);
}

/// Goes one way, whatever is asked.
class Pusher final : public Agent {
 public:
  void wish(const AgentView& view, Wish& wish) override {
    wish.v.assign(view.body.size(), 0.0);
    wish.v[0] = 0.05;
    wish.arrow_W = {0.05, 0.01, -0.02};
  }
};

TEST(AgentLoop, DrawsBackTheWayThatItCame) {
  const auto cell = boxBeforeWall(false);
  std::vector<WeightedAgent> agents(1);
  agents[0].name = "pusher";
  agents[0].agent = std::make_unique<Pusher>();
  AgentLoop loop(cell->start().placed(cell->start().configuration()), cell->clearances().fresh(), std::move(agents),
                 cell->task().goal, 0.003, 0);
  const dvec3 p_WStart = loop.body().handle().p;
  std::vector<double> came{p_WStart.x};
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(loop.step());
    came.push_back(loop.body().handle().p.x);
  }
  const double end = loop.body().handle().p.x;
  EXPECT_NEAR(end - p_WStart.x, 0.05, 1e-9);
  loop.drawBack(0.03);
  for (int i = 0; i < 20 && loop.isDrawingBack(); ++i) {
    const double t = loop.t(), before = loop.body().handle().p.x;
    loop.step();
    EXPECT_DOUBLE_EQ(loop.t(), t + AgentLoop::kStep);
    EXPECT_LE(before - loop.body().handle().p.x, 0.25 * AgentLoop::kStep + 0.01) << "no faster than it moves";
    EXPECT_NE(std::find(came.begin(), came.end(), loop.body().handle().p.x), came.end()) << "where it was before";
    EXPECT_EQ(loop.wishes()[0].strength, 0.0);
  }
  EXPECT_FALSE(loop.isDrawingBack());
  EXPECT_NEAR(end - loop.body().handle().p.x, 0.03, 1.1e-3);
  ASSERT_TRUE(loop.step()) << "then agents move it again";
  loop.drawBack(10.0);
  for (int i = 0; i < 50 && loop.isDrawingBack(); ++i) loop.step();
  EXPECT_FALSE(loop.isDrawingBack());
  EXPECT_EQ(loop.body().handle().p, p_WStart);
}

TEST(AgentRuns, ABodyThatIsCaughtDrawsBackBeforeThePlannerIsAskedAgain) {
  const auto cell = shipped("trunk-access.toml");
  EXPECT_EQ(backBeforePlan(cell->start(), 0), 0.0) << "the first way begins where it is";
  EXPECT_GT(backBeforePlan(cell->start(), 2), backBeforePlan(cell->start(), 1));
  EXPECT_EQ(backBeforePlan(boxBeforeWall(false)->start(), 2), 0.0) << "planned as a whole from where it is";
  constexpr std::uint64_t kCaughtAtTheSill = 5;
  const RunResult run = runOnce(*cell, kCaughtAtTheSill, RunMode::kBoth, {});
  EXPECT_TRUE(run.solved) << english(run.reason);
  EXPECT_GE(run.plans, 2) << "the first way did not free it";
}

TEST(RunRecorder, KeepsTheMiddleOfASolidAndWhatEachAgentWanted) {
  const auto cell = boxBeforeWall(false);
  std::vector<WeightedAgent> agents(1);
  agents[0].name = "pusher";
  agents[0].agent = std::make_unique<Pusher>();
  AgentLoop loop(cell->start().placed(cell->start().configuration()), cell->clearances().fresh(), std::move(agents),
                 cell->task().goal, 0.003, 0);
  RunRecorder recorder(*cell);
  recorder.add(loop);
  ASSERT_TRUE(loop.step());
  recorder.add(loop);
  recorder.addWishes(loop);
  const trajectory::Trajectory& motion = recorder.motion();
  EXPECT_EQ(motion.entity, "box");
  EXPECT_EQ(motion.moved, "geometric_center");
  EXPECT_TRUE(motion.joint_names.empty());
  ASSERT_EQ(motion.size(), 2u);
  EXPECT_EQ(motion[0].t, 0.0);
  EXPECT_DOUBLE_EQ(motion[1].t, AgentLoop::kStep);
  EXPECT_NEAR(motion[1].X_WT.p.x - motion[0].X_WT.p.x, 0.05 * AgentLoop::kStep, 1e-9);
  const std::string& csv = recorder.wishes();
  EXPECT_TRUE(csv.starts_with("t,pusher_x,pusher_y,pusher_z,pusher_strength\n")) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2) << "the head and one step";
  ASSERT_EQ(loop.wishes().size(), 1u);
  double t = 0.0, x = 0.0, y = 0.0, z = 0.0, strength = 0.0;
  ASSERT_EQ(std::sscanf(csv.c_str() + csv.find('\n'), "%lf,%lf,%lf,%lf,%lf", &t, &x, &y, &z, &strength), 5) << csv;
  EXPECT_EQ(t, loop.t());
  EXPECT_EQ(dvec3(x, y, z), loop.wishes()[0].arrow_W);
  EXPECT_EQ(strength, loop.wishes()[0].strength);
}

TEST(AgentCell, RefusesAStartInContact) {
  auto task = *AgentTask::parse("cell = \"c\"\nentity = \"box\"\n[goal]\nposition = [0.8, 0.0, 0.0]\n"
                                "[[agent]]\nwhat = \"goal\"\n",
                                "/t.toml");
  auto scene = PreparedScene::prepare({loaded("box:0.1,0.1,0.1", 1, "box"),
                                       loaded("box:1.0,1.0,0.1", 2, "table", Pose::translation({0.0, 0.0, -0.1}))},
                                      {}, {});
  const auto cell = AgentCell::create(std::move(task), scene, {});
  ASSERT_FALSE(cell);
  EXPECT_NE(cell.error().message().find("table are in contact at the start"), std::string::npos)
      << cell.error().message();
}

TEST(DeadlockWatch, WaitsASecondAtOnePlaceAndFiveWhileItMoves) {
  DeadlockWatch watch;
  double t = 0.0;
  const dvec3 here(1.0, 0.0, 0.0);
  for (double left = 1.0; left > 0.5; left -= 0.01, t += 0.02) EXPECT_FALSE(watch.update(t, {left, 0.0, 0.0}, left));
  const double stopped = t;
  while (!watch.update(t, here, 0.5)) t += 0.02;
  EXPECT_NEAR(t - stopped, DeadlockWatch::kPatience, 0.05);
  watch.restart(t, 0.5, 2.0);
  EXPECT_FALSE(watch.update(t + 2.9, here, 0.6));
  EXPECT_TRUE(watch.update(t + 3.1, here, 0.6));
  // Round and round.
  DeadlockWatch circle;
  t = 0.0;
  while (!circle.update(t, {std::cos(t), std::sin(t), 0.0}, 1.0)) t += 0.02;
  EXPECT_NEAR(t, DeadlockWatch::kLongPatience, 0.05);
}

/// An agent of somebody else: one class.
class Lifter final : public Agent {
 public:
  void wish(const AgentView& view, Wish& wish) override {
    wish.v.assign(view.body.size(), 0.0);
    wish.v[2] = 0.1;
    wish.arrow_W = {0.0, 0.0, 0.1};
  }
};

TEST(AgentLoop, SumsTheWishesOfAgentsByTheirWeights) {
  const auto cell = boxBeforeWall(false);
  std::vector<WeightedAgent> agents;
  agents.push_back({"lifter", 0.5, true, std::make_unique<Lifter>()});
  auto hand = std::make_unique<OperatorAgent>();
  hand->setHand(Twist{{0.0, 0.1, 0.0}, dvec3(0.0)});
  agents.push_back({"operator", 1.0, true, std::move(hand)});
  agents.push_back({"off", 9.0, false, std::make_unique<Lifter>()});
  AgentLoop loop(cell->start().placed(cell->start().configuration()), cell->clearances().fresh(), std::move(agents),
                 cell->task().goal, 0.003, 0);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(loop.step());
  EXPECT_NEAR(loop.body().handle().p.z, 0.05, 1e-6);
  EXPECT_NEAR(loop.body().handle().p.y, 0.1, 2e-3);
  ASSERT_EQ(loop.wishes().size(), 3U);
  EXPECT_NEAR(loop.wishes()[0].arrow_W.z, 0.05, 1e-12);
  EXPECT_NEAR(loop.wishes()[0].strength, 0.05 / 0.25, 1e-12);
  EXPECT_EQ(loop.wishes()[2].strength, 0.0);
}

}  // namespace
}  // namespace hapticell::agents
