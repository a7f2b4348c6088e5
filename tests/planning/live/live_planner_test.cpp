// SPDX-License-Identifier: Apache-2.0
#include "planning/live/live_planner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "geometry/shapes/shapes.h"
#include "kinematics/model/robot_model.h"
#include "manipulation/checks/path_check.h"
#include "manipulation/session/session.h"
#include "planning/free_space.h"
#include "tests/manipulation/session/test_cells.h"
#include "tests/planning/live/window_cell.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning {
namespace {

using manipulation::PlanView;
using manipulation::test::solid;

using test::prepared;
using test::throughWindow;
using test::viewOf;
using test::windowCell;

/// Looks each 10 ms until there is a way other than `old`.
std::shared_ptr<const manipulation::PlannedWay> wayOf(LivePlanner& planner, PlanView& view, double seconds,
                                                      const manipulation::PlannedWay* old = nullptr) {
  for (int i = 0; i < std::lround(100.0 * seconds); ++i) {
    view.time_ns += 10'000'000;
    planner.look(view);
    if (const auto way = planner.newest(); way && way.get() != old) return way;
  }
  return nullptr;
}

void expectFree(const manipulation::PlannedWay& way) {
  test::expectFree(way.X_WM);
}

TEST(LivePlanner, LeadsThroughTheWindow) {
  LivePlanner planner(throughWindow());
  PlanView view = viewOf(prepared());
  const auto way = wayOf(planner, view, 5.0);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->X_WM.front().p, view.X_WM.p);
  EXPECT_LT(glm::distance(way->X_WM.back().p, dvec3(0.1, 0.0, 0.0)), 1e-6);
  expectFree(*way);
  EXPECT_FALSE(planner.isReached(view));
  view.standing.X_WE = view.X_WM = way->X_WM.back();
  EXPECT_TRUE(planner.isReached(view));
}

TEST(LivePlanner, GivesTheSameWaysInVirtualTime) {
  LivePlanner first(throughWindow()), second(throughWindow());
  PlanView one = viewOf(prepared()), two = viewOf(prepared());
  const auto a = wayOf(first, one, 5.0), b = wayOf(second, two, 5.0);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(one.time_ns, two.time_ns);
  ASSERT_EQ(a->X_WM.size(), b->X_WM.size());
  for (std::size_t i = 0; i < a->X_WM.size(); ++i) EXPECT_EQ(a->X_WM[i].p, b->X_WM[i].p);
}

/// A machine so slow that no wall time is left for a search.
TEST(LivePlanner, GivesTheSameWayInVirtualTimeHoweverSlowTheMachine) {
  LiveOptions slow = throughWindow();
  slow.most_seconds = 0.0;
  LivePlanner first(throughWindow()), second(slow);
  PlanView one = viewOf(prepared()), two = viewOf(prepared());
  const auto a = wayOf(first, one, 5.0), b = wayOf(second, two, 5.0);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(one.time_ns, two.time_ns);
  ASSERT_EQ(a->X_WM.size(), b->X_WM.size());
  for (std::size_t i = 0; i < a->X_WM.size(); ++i) EXPECT_EQ(a->X_WM[i].p, b->X_WM[i].p);
}

TEST(LivePlanner, AWayStaysWhileItIsFollowed) {
  LivePlanner planner(throughWindow());
  PlanView view = viewOf(prepared());
  const auto way = wayOf(planner, view, 5.0);
  ASSERT_TRUE(way);
  view.way_number = way->number;
  view.way_left = 0.3;
  for (int i = 0; i < 100; ++i) {
    view.time_ns += 10'000'000;
    view.way_left -= 0.002;
    view.standing.X_WE.p.x = view.X_WM.p.x += 0.0002;
    planner.look(view);
    EXPECT_EQ(planner.newest(), way);
  }
  EXPECT_GT(planner.figures().searches, 3U) << "it goes on planning all the time";
}

TEST(LivePlanner, PassesWhereTheHandInsists) {
  LivePlanner planner(throughWindow());
  PlanView view = viewOf(prepared());
  const auto way = wayOf(planner, view, 5.0);
  ASSERT_TRUE(way);
  view.way_number = way->number;
  view.way_left = 0.3;
  view.insistences = 1;
  view.push_W = {0.0, 0.0, 0.03};
  const auto answer = wayOf(planner, view, 5.0, way.get());
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->answers, 1U);
  double highest = 0.0;
  for (const Pose& X_WM : answer->X_WM) highest = std::max(highest, X_WM.p.z);
  EXPECT_GT(highest, 0.025) << "up, where the hand pushed";
  expectFree(*answer);
}

/// What is being searched for the hand as it was before is of no use.
TEST(LivePlanner, GivesUpASearchInVirtualTimeWhenTheHandInsists) {
  LiveOptions options = throughWindow();
  int searches = 0;
  options.cost_s = [&searches](const PlanResult&) { return ++searches == 1 ? 100.0 : 0.1; };
  LivePlanner planner(options);
  PlanView view = viewOf(prepared());
  EXPECT_EQ(wayOf(planner, view, 1.0), nullptr);
  view.insistences = 1;
  view.push_W = {0.0, 0.0, 0.03};
  const auto answer = wayOf(planner, view, 1.0);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->answers, 1U);
}

TEST(LivePlanner, LeavesAStartThatTouches) {
  auto entities = windowCell();
  entities[0].X_WE.p.x = -0.03 - 1e-4;  // 0.1 mm from the wall.
  LivePlanner planner(throughWindow());
  PlanView view = viewOf(manipulation::PreparedScene::prepare(entities, {}, {}));
  const auto way = wayOf(planner, view, 5.0);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->X_WM.front().p, view.X_WM.p);
  expectFree(*way);
}

TEST(LivePlanner, WorksInItsOwnThread) {
  LiveOptions options = throughWindow();
  options.in_virtual_time = false;
  LivePlanner planner(options);
  PlanView view = viewOf(prepared());
  std::shared_ptr<const manipulation::PlannedWay> way;
  while (!way) {  // Ends with the test's own limit.
    planner.look(view);
    way = planner.newest();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  expectFree(*way);
}

TEST(LivePlanner, SaysWhenThereIsNoWay) {
  auto entities = windowCell();
  entities.push_back(solid(6, "lid", geometry::makeBox({0.02, 0.5, 0.5}), Pose::translation({0.05, 0.0, 0.0})));
  entities[0].locked = false;
  LiveOptions options = throughWindow();
  options.goal = goal::ToPose{Pose::translation({0.05, 0.0, 0.0})};  // Inside the lid.
  LivePlanner planner(options);
  PlanView view = viewOf(manipulation::PreparedScene::prepare(entities, {}, {}));
  EXPECT_EQ(wayOf(planner, view, 2.0), nullptr);
  ASSERT_TRUE(planner.figures().failure.has_value());
  EXPECT_EQ(planner.figures().failure->blocked_by, "lid");
}

/// Seven links of 0.26 m, turning about z and y in turn, before a post: one joint more than a tool needs.
workcell::Entity sevenAxes() {
  kinematics::RobotModel model;
  model.name = "arm";
  model.links.emplace_back().name = "root";
  for (int i = 0; i < 7; ++i) {
    kinematics::Joint joint;
    joint.name = "joint" + std::to_string(i);
    joint.type = kinematics::JointType::kRevolute;
    joint.parent_link = i;
    joint.child_link = i + 1;
    joint.X_PJ = Pose::translation({0.0, 0.0, i == 0 ? 0.0 : 0.26});
    joint.axis_J = i % 2 == 0 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    joint.lower = -2.8;
    joint.upper = 2.8;
    joint.velocity = 3.0;
    joint.variable = i;
    geometry::TriangleMesh shape = geometry::makeBox({0.06, 0.06, 0.18});
    for (dvec3& vertex : shape.vertices) vertex.z += 0.13;
    kinematics::Link link;
    link.name = "link" + std::to_string(i);
    link.parent_joint = i;
    link.collisions.push_back({std::make_shared<const geometry::TriangleMesh>(std::move(shape)), {}, {}, ""});
    model.moving.push_back(i);
    model.joints.push_back(joint);
    model.links.push_back(std::move(link));
  }
  workcell::Entity robot;
  robot.id = 1;
  robot.name = "arm";
  robot.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(model)),
                                .joints = {0.7, 0.8, 0.2, 0.6, 0.1, 0.5, 0.0}}};
  return robot;
}

struct ArmMove {
  std::vector<workcell::Entity> entities;
  Pose X_WT, X_WG;
};

ArmMove roundThePost() {
  ArmMove move;
  move.entities = {sevenAxes(), solid(2, "post", geometry::makeBox({0.12, 0.12, 1.0}), Pose::translation({0.9, 0.0, 0.5}))};
  auto space = FreeSpace::create(manipulation::PreparedScene::prepare(move.entities, {}, {}), 1, {});
  EXPECT_TRUE(space.has_value());
  EntityConfiguration at = space->present();
  move.X_WT = space->toolAt(at);
  at.joints = {-0.8, 0.9, -0.1, 0.5, 0.2, 0.6, 0.3};
  move.X_WG = space->toolAt(at);
  return move;
}

/// A StraightHand at the robot, with the planner beside it.
manipulation::SessionReport leadArm(const ArmMove& move, std::uint64_t seed, double authority) {
  manipulation::SessionOptions options;
  options.entities = move.entities;
  options.entity = "arm";
  options.configuration.manipulation.rate_hz = 100.0;
  options.configuration.manipulation.edge_drift = 0.1;
  options.axes.mode = manipulation::AxesMode::kCell;
  // 5 cm of hand for all of it: a hand that is 8 mm beside the way would be 15 cm beside it.
  const double scale = glm::distance(move.X_WT.p, move.X_WG.p) / 0.05;
  options.scale = {manipulation::ScaleLevel::kNumber, scale};
  options.straight_hand = manipulation::seededHand(seed);
  options.straight_hand->X_WG = move.X_WG;
  options.straight_hand->scale = scale;
  options.hand = haptic::HandPath({{0.0, {}, 0}, {12.0, {}, 0}});
  LiveOptions live;
  live.goal = goal::ToPose{move.X_WG};
  live.clearance = 0.005;
  live.seed = seed;
  live.in_virtual_time = true;
  options.assistance = {std::make_shared<LivePlanner>(live), authority};
  auto report = manipulation::runSession(options);
  EXPECT_TRUE(report.has_value());
  return report ? std::move(*report) : manipulation::SessionReport{};
}

TEST(LivePlanner, LeadsAnArmOfSevenAxesRoundAPost) {
  const ArmMove move = roundThePost();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto led = leadArm(move, seed, 1.0);
    ASSERT_TRUE(led.plan.has_value());
    EXPECT_TRUE(led.plan->solved) << seed;
    EXPECT_LE(led.forces.penetration_blocked_m, 1e-6);
  }
  const auto alone = leadArm(move, 1, 0.0);
  ASSERT_TRUE(alone.plan.has_value());
  EXPECT_FALSE(alone.plan->solved) << "straight on there is the post";
}

TEST(LivePlanner, GivesTheJointsOfARobotsWay) {
  const ArmMove move = roundThePost();
  LiveOptions options = throughWindow();
  options.goal = goal::ToPose{move.X_WG};
  options.clearance = 0.004;
  LivePlanner planner(options);
  PlanView view = viewOf(manipulation::PreparedScene::prepare(move.entities, {}, {}));
  view.standing = {};
  view.standing.joints = move.entities[0].joints();
  view.X_WM = move.X_WT;
  view.trail = std::make_shared<const manipulation::Trail>(manipulation::Trail{view.standing});
  const auto way = wayOf(planner, view, 5.0);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->clearance, 0.004);
  ASSERT_EQ(way->postures.size(), way->X_WM.size());
  EXPECT_EQ(way->postures.front().joints, view.standing.joints);
  auto space = FreeSpace::create(view.scene, 1, {});
  ASSERT_TRUE(space.has_value());
  for (std::size_t i = 0; i < way->postures.size(); ++i) {
    const Pose X_WT = space->toolAt({{}, way->postures[i].joints});
    EXPECT_LT(glm::distance(X_WT.p, way->X_WM[i].p), 1e-5);
    if (i > 0) {
      EXPECT_TRUE(space->isFree({{}, way->postures[i - 1].joints}, {{}, way->postures[i].joints})) << i;
    }
  }
}

TEST(IsAtGoal, KnowsEachKindOfGoal) {
  const Pose there{{0.1, 0.2, 0.3}, quaternionFromRotationVector({0.0, 0.5, 0.0})};
  const geometry::Bounds bounds{dvec3(-1.0), dvec3(1.0)};
  EXPECT_TRUE(isAtGoal(goal::ToPose{there}, {there.p + dvec3(1e-3, 0, 0), there.q}, {}, bounds, 0.1));
  EXPECT_FALSE(isAtGoal(goal::ToPose{there}, {there.p + dvec3(3e-3, 0, 0), there.q}, {}, bounds, 0.1));
  EXPECT_FALSE(isAtGoal(goal::ToPose{there}, {there.p, dquat(1, 0, 0, 0)}, {}, bounds, 0.1));
  EXPECT_TRUE(isAtGoal(goal::ToJoints{{1.0, 2.0}}, {}, {1.01, 2.0}, bounds, 0.0));
  EXPECT_FALSE(isAtGoal(goal::ToJoints{{1.0, 2.0}}, {}, {1.1, 2.0}, bounds, 0.0));
  EXPECT_TRUE(isAtGoal(goal::ToRegion{there, dvec3(0.1), 0.2}, {there.p + dvec3(0.05), there.q}, {}, bounds, 0.0));
  EXPECT_FALSE(isAtGoal(goal::ToRegion{there, dvec3(0.1), 0.2}, {there.p + dvec3(0.3), there.q}, {}, bounds, 0.0));
  EXPECT_FALSE(isAtGoal(goal::OutOfCell{0.01}, Pose::translation({1.05, 0, 0}), {}, bounds, 0.1));
  EXPECT_TRUE(isAtGoal(goal::OutOfCell{0.01}, Pose::translation({1.12, 0, 0}), {}, bounds, 0.1));
}

}  // namespace
}  // namespace hapticell::planning
