// SPDX-License-Identifier: Apache-2.0
#include "agents/wishes/agent.h"

#include <gtest/gtest.h>

#include <set>

#include "agents/body/follow.h"
#include "agents/task/agent_section.h"
#include "agents/wishes/agent_makers.h"
#include "agents/wishes/figure_need.h"
#include "agents/wishes/followed_way.h"
#include "agents/wishes/operator_agent.h"
#include "agents/wishes/seeded_numbers.h"
#include "agents/wishes/simulated_hand.h"
#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/posture/support_polygon.h"
#include "mannequin/posture/vision.h"
#include "tests/agents/test_bodies.h"

namespace hapticell::agents {
namespace {

using manipulation::PreparedScene;
using test::bodyOf;
using test::loaded;

/// A cell with one agent of a kind, which can be asked for its wish.
struct Stage {
  std::shared_ptr<const PreparedScene> scene;
  std::unique_ptr<MovedBody> body;
  std::unique_ptr<Clearances> clearances;
  AgentTask task;
  workcell::EntityId look_at = 0;

  Stage(std::vector<workcell::Entity> entities, std::unique_ptr<MovedBody> at, const std::string& kind,
        const dvec3& goal = dvec3(0.0), workcell::EntityId seen = 0)
      : scene(PreparedScene::prepare(std::move(entities), {}, {})), body(std::move(at)), look_at(seen) {
    clearances = std::make_unique<Clearances>(std::move(*Clearances::create(scene, 1, body->configuration(), {})));
    task = *AgentTask::parse("cell = \"c\"\nentity = \"e\"\n[goal]\nposition = [0.0, 0.0, 0.0]\n[[agent]]\nwhat = \"" +
                                 kind + "\"\n",
                             "/t.toml");
    task.goal.p_WG = goal;
  }
  Expected<WeightedAgent> make() const {
    return makeAgent({task.agents[0], task, *body, look_at, clearances->obstacles(), 5});
  }
  Wish ask(Agent& agent, double t = 0.0) const {
    const LineOfSight lines(clearances->obstacles(), look_at);
    Wish wish;
    agent.wish({*body, clearances->look(body->configuration(), kLook), task.goal, lines, t}, wish);
    return wish;
  }
  Wish ask() const {
    const auto agent = make();
    EXPECT_TRUE(agent) << (agent ? "" : agent.error().message());
    return ask(*agent->agent);
  }
  /// Follows the wish for some seconds.
  void followFor(double seconds) {
    const auto agent = make();
    for (double t = 0.0; t < seconds; t += 0.02) {
      const Wish wish = ask(*agent->agent, t);
      if (wish.v.empty()) continue;
      std::vector<double> step(wish.v);
      for (double& one : step) one *= 0.02;
      if (auto there = body->moved(step)) body = std::move(there);
    }
  }
};

std::unique_ptr<MovedBody> bent(const workcell::Entity& worker) {
  auto body = bodyOf(worker);
  std::vector<double> step(body->size(), 0.0);
  for (const std::size_t flexion : {6U, 9U, 12U}) step[flexion] = 0.012;
  step[0] = 0.002;
  step[4] = 0.010;
  for (int i = 0; i < 30; ++i) {
    if (auto there = body->moved(step)) body = std::move(there);
  }
  return body;
}

TEST(FigureNeed, RefusesWhatIsNoMannequinAndNamesTheAgent) {
  const Stage robot({test::arm()}, bodyOf(test::arm()), "balance");
  const auto refused = needFigure({robot.task.agents[0], robot.task, *robot.body, 0, robot.clearances->obstacles(), 5});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("balance"), std::string::npos) << refused.error().message();
  const workcell::Entity worker = loaded("mannequin:male:50", 1, "worker");
  const Stage person({worker}, bodyOf(worker), "balance");
  EXPECT_TRUE(needFigure({person.task.agents[0], person.task, *person.body, 0, person.clearances->obstacles(), 5}));
}

TEST(FigureNeed, GivesEachVariableTheNumberOfItsRegion) {
  const auto body = bodyOf(loaded("mannequin:male:50", 1, "worker"));
  const std::vector<double> all = byRegion(*body, {1.0, 2.0, 3.0, 4.0, 5.0});
  // Of a mannequin: 3 for the pelvis' place, 3 for its turn, 9 of the spine, 18 of the arms, 9 of the neck.
  ASSERT_EQ(all.size(), 42u);
  const int counts[] = {3, 3, 9, 18, 9};
  std::size_t at = 0;
  for (int region = 0; region < 5; ++region) {
    for (int k = 0; k < counts[region]; ++k) EXPECT_EQ(all[at++], region + 1.0);
  }
}

TEST(Agents, EachKindHasItsOwnName) {
  std::set<std::string> names;
  for (const AgentKind& kind : agentKinds()) EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  const Stage stage({test::arm()}, bodyOf(test::arm()), "magic");
  const auto agent = stage.make();
  ASSERT_FALSE(agent);
  EXPECT_NE(agent.error().message().find("one of goal, obstacles"), std::string::npos) << agent.error().message();
}

TEST(Agents, TheGoalAttractsTheMovedFrame) {
  Stage stage({test::arm()}, bodyOf(test::arm()), "goal");
  stage.task.goal.p_WG = stage.body->handle().p + dvec3(0.02, 0.05, -0.04);
  stage.followFor(3.0);
  EXPECT_LT(glm::length(stage.body->handle().p - stage.task.goal.p_WG), 1e-3);
}

TEST(Agents, ObstaclesPushTheNearestPointStraightAway) {
  const workcell::Entity box = loaded("box:0.1,0.1,0.1", 1, "box");
  const Stage stage({box, loaded("box:0.1,0.1,0.1", 2, "wall", Pose::translation({0.13, 0.0, 0.0}))}, bodyOf(box),
                    "obstacles", {1.0, 0.0, 0.0});
  const Wish wish = stage.ask();
  ASSERT_EQ(wish.v.size(), 6U);
  EXPECT_LT(wish.v[0], -0.01);
  EXPECT_NEAR(wish.v[1], 0.0, 0.02);
  EXPECT_LT(wish.arrow_W.x, -0.01);
  const Stage far({box, loaded("box:0.1,0.1,0.1", 2, "wall", Pose::translation({0.5, 0.0, 0.0}))}, bodyOf(box),
                  "obstacles", {1.0, 0.0, 0.0});
  EXPECT_TRUE(far.ask().v.empty());
}

TEST(Agents, LimitsPushInwards) {
  workcell::Entity robot = test::arm();
  std::vector<double> joints = robot.joints();
  const kinematics::Joint& elbow = robot.robot()->joints[static_cast<std::size_t>(robot.robot()->moving[2])];
  joints[2] = elbow.upper - 0.02;
  robot.setJoints(joints);
  const Wish wish = Stage({robot}, bodyOf(robot), "limits").ask();
  EXPECT_LT(wish.v[2], -0.1);
}

TEST(Agents, LimitsLeaveASingularPlace) {
  workcell::Entity robot = test::arm();
  robot.setJoints({0.3, -1.2, 1.4, -1.6, -0.05, 0.2});
  Stage stage({robot}, bodyOf(robot), "limits");
  const double before = leastSingularValue(*stage.body);
  stage.followFor(1.0);
  EXPECT_GT(leastSingularValue(*stage.body), before + 0.005);
}

TEST(Agents, ComfortLowersTheScoreOfABentPosture) {
  const workcell::Entity worker = loaded("mannequin:male:50", 1, "worker");
  Stage stage({worker}, bent(worker), "comfort");
  const auto scores = [&] {
    const FigureView& figure = *stage.body->figure();
    return ergonomics::scorePosture(figure.figure, figure.posture, figure.pose, {});
  };
  const auto before = scores();
  stage.followFor(4.0);
  const auto after = scores();
  EXPECT_LE(after.rula(), before.rula());
  EXPECT_LT(after.worse().measured.trunk_flexion, before.worse().measured.trunk_flexion - 1.0);
}

TEST(Agents, BalanceBringsTheCentreOfMassBackOverTheSoles) {
  const workcell::Entity worker = loaded("mannequin:male:50", 1, "worker");
  auto aside = bodyOf(worker);
  std::vector<double> step(aside->size(), 0.0);
  step[2] = -0.004;  // Knees bent first: a pelvis over straight legs cannot go aside.
  for (int i = 0; i < 40; ++i) {
    if (i == 20) step[2] = 0.0;
    if (i == 20) step[1] = 0.004;
    if (auto there = aside->moved(step)) aside = std::move(there);
  }
  Stage stage({worker}, std::move(aside), "balance\"\nmargin = 0.15 #");
  const auto margin = [&] {
    const FigureView& figure = *stage.body->figure();
    const std::array<mannequin::SegmentPlace, 2> feet{figure.pose[mannequin::Segment::kLeftFoot],
                                                      figure.pose[mannequin::Segment::kRightFoot]};
    return mannequin::supportPolygon(figure.figure, feet)
        .margin(glm::dvec2(mannequin::centerOfMass(figure.figure, figure.pose)));
  };
  const double before = margin();
  stage.followFor(3.0);
  EXPECT_GT(margin(), before + 0.005);
}

TEST(Agents, SightTurnsTheHeadAndLeansPastWhatHides) {
  const workcell::Entity worker = loaded("mannequin:male:50", 1, "worker");
  const Pose X_WTarget = Pose::translation({1.2, 0.0, 1.55});
  // To the side.
  Stage turn({worker, loaded("box:0.1,0.1,0.1", 2, "target", Pose::translation({0.6, 1.0, 1.5}))}, bodyOf(worker),
             "sight", {}, 2);
  turn.followFor(4.0);
  const auto seen = mannequin::sightOf(turn.body->figure()->figure, turn.body->figure()->pose, {0.6, 1.0, 1.5});
  EXPECT_LT(std::abs(seen.azimuth), 20.0 * kDegree);
  // Behind a narrow board.
  Stage lean({worker, loaded("box:0.1,0.1,0.1", 2, "target", X_WTarget),
              loaded("box:0.02,0.12,0.5", 3, "board", Pose::translation({0.7, 0.0, 1.6}))},
             bodyOf(worker), "sight", {}, 2);
  const LineOfSight lines(lean.clearances->obstacles(), 2);
  const auto eyes = [&] { return mannequin::sightOf(lean.body->figure()->figure, lean.body->figure()->pose, X_WTarget.p).p_WEyes; };
  ASSERT_FALSE(lines.isFree(eyes(), X_WTarget.p));
  lean.followFor(4.0);
  EXPECT_TRUE(lines.isFree(eyes(), X_WTarget.p));
}

TEST(Agents, ReachBringsTheShoulderNearer) {
  const workcell::Entity worker = loaded("mannequin:male:50", 1, "worker");
  Stage stage({worker}, bodyOf(worker), "reach", {0.9, -0.2, 1.2});
  const auto shoulder = [&] { return stage.body->figure()->pose[mannequin::Segment::kRightUpperArm].p_WS; };
  const double before = glm::length(stage.task.goal.p_WG - shoulder());
  stage.followFor(2.0);
  EXPECT_LT(glm::length(stage.task.goal.p_WG - shoulder()), before - 0.05);
}

TEST(Agents, AgentsForMannequinsRefuseRobots) {
  for (const char* kind : {"balance", "comfort", "sight", "reach"}) {
    const auto agent = Stage({test::arm()}, bodyOf(test::arm()), kind).make();
    ASSERT_FALSE(agent) << kind;
    EXPECT_NE(agent.error().message().find("no mannequin"), std::string::npos);
  }
}

TEST(Agents, AnOperatorsHandIsFollowedUntilItGoesAway) {
  Stage stage({test::arm()}, bodyOf(test::arm()), "operator");
  OperatorAgent hand;
  EXPECT_TRUE(stage.ask(hand).v.empty());
  hand.setHand(Twist{{0.1, 0.0, 0.0}, dvec3(0.0)});
  const Wish wish = stage.ask(hand);
  const dvec3 made = velocityOf(*stage.body, stage.body->handleLink(), stage.body->handle().p, wish.v);
  EXPECT_LT(glm::length(made - dvec3(0.1, 0.0, 0.0)), 0.02);
  hand.setHand({});
  EXPECT_TRUE(stage.ask(hand).v.empty());
}

TEST(Agents, ASimulatedOperatorLetsAPlannersWayLead) {
  const Stage stage({test::arm()}, bodyOf(test::arm()), "operator", {0.8, 0.0, 0.3});
  const auto agent = stage.make();
  ASSERT_TRUE(agent);
  EXPECT_FALSE(stage.ask(*agent->agent).v.empty());
  const LineOfSight lines(stage.clearances->obstacles());
  const FollowedWay way({{Pose::translation({0.8, 0.0, 0.3}), {}}}, false);
  Wish led;
  agent->agent->wish({*stage.body, stage.clearances->look(stage.body->configuration(), kLook), stage.task.goal, lines,
                      0.02, 0.02, &way},
                     led);
  EXPECT_TRUE(led.v.empty());
  EXPECT_FALSE(stage.ask(*agent->agent, 0.04).v.empty()) << "it goes on where the way has ended";
  OperatorAgent person;
  person.setHand(Twist{{0.1, 0.0, 0.0}, dvec3(0.0)});
  Wish leads;
  person.wish({*stage.body, stage.clearances->look(stage.body->configuration(), kLook), stage.task.goal, lines, 0.02,
               0.02, &way},
              leads);
  EXPECT_FALSE(leads.v.empty()) << "a person leads whenever she likes";
}

TEST(SimulatedHand, GoesRoundWhatIsInTheWay) {
  const workcell::Entity box = loaded("box:0.04,0.04,0.04", 1, "box");
  Stage stage({box, loaded("box:0.05,0.5,0.5", 2, "wall", Pose::translation({0.4, 0.0, 0.0}))}, bodyOf(box),
              "operator", {0.8, 0.0, 0.0});
  SimulatedHand hand(11), again(11), other(12);
  const LineOfSight lines(stage.clearances->obstacles());
  double aside = 0.0;
  for (double t = 0.0; t < 15.0; t += 0.02) {
    const AgentView view{*stage.body, stage.clearances->look(stage.body->configuration(), kLook), stage.task.goal, lines,
                         t};
    const Twist velocity = hand.velocity(view);
    EXPECT_EQ(velocity.linear, again.velocity(view).linear);  // The seed decides.
    other.velocity(view);
    const std::vector<double> step{0.02 * velocity.linear.x, 0.02 * velocity.linear.y, 0.02 * velocity.linear.z, 0, 0, 0};
    stage.body = stage.body->moved(step);
    const dvec3 p = stage.body->handle().p;
    aside = std::max(aside, std::hypot(p.y, p.z));
    EXPECT_FALSE(std::abs(p.x - 0.4) < 0.025 && std::abs(p.y) < 0.25 && std::abs(p.z) < 0.25);
  }
  EXPECT_GT(aside, 0.25);
  EXPECT_LT(glm::length(stage.body->handle().p - stage.task.goal.p_WG), 0.02);
}

TEST(SeededNumbers, AreThePublishedOnes) {
  SeededNumbers numbers(1234567);  // From the reference implementation of SplitMix64.
  EXPECT_EQ(numbers.next(), 6457827717110365317U);
  EXPECT_EQ(numbers.next(), 3203168211198807973U);
  EXPECT_LT(std::abs(numbers.within(0.5)), 0.5);
}

}  // namespace
}  // namespace hapticell::agents
