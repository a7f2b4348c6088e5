// SPDX-License-Identifier: Apache-2.0
#include "planning/plan.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include "planning/axis_places.h"
#include "planning/problem.h"
#include "tests/planning/planning_cells.h"

namespace hapticell::planning {
namespace {

Problem robotProblem(const std::shared_ptr<const manipulation::PreparedScene>& scene) {
  Problem problem;
  problem.scene = scene;
  problem.entity = 1;
  std::vector<double> joints = scene->find(1)->joints();
  joints[0] = -0.6;
  problem.goal = goal::ToJoints{joints};
  problem.clearance = 0.01;
  return problem;
}

void expectFree(const Problem& problem, const Plan& plan) {
  auto space = FreeSpace::create(problem.scene, problem.entity, {}, problem.placements);
  ASSERT_TRUE(space);
  space->setClearance(problem.clearance);
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    EXPECT_TRUE(space->isFree(plan.waypoints[i - 1], plan.waypoints[i])) << i;
    for (int k = 0; k <= 20; ++k) {
      const auto at = space->between(plan.waypoints[i - 1], plan.waypoints[i], k / 20.0);
      EXPECT_GE(space->clearanceAt(at, 0.1), problem.clearance);
    }
  }
}

TEST(Plan, GoesAroundAWallWithGripper) {
  const Problem problem = robotProblem(test::robotCell(true));
  const auto result = plan(problem);
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_TRUE(result->isSolved()) << english(result->failure->reason);
  EXPECT_EQ(result->plan->waypoints.front().joints, problem.scene->find(1)->joints());
  EXPECT_EQ(result->plan->waypoints.back().joints, std::get<goal::ToJoints>(problem.goal).joints);
  EXPECT_GT(result->plan->length, 0.3);
  EXPECT_GE(result->plan->clearance_min, 0.01);
  expectFree(problem, *result->plan);
}

TEST(Plan, IsTheSameForTheSameSeed) {
  Problem problem = robotProblem(test::robotCell());
  problem.seed = 9;
  problem.threads = 1;
  const auto one = plan(problem);
  problem.threads = 3;
  problem.time_limit_s = 1000.0;
  const auto two = plan(problem);
  ASSERT_TRUE(one && two && one->isSolved() && two->isSolved());
  ASSERT_EQ(one->plan->waypoints.size(), two->plan->waypoints.size());
  EXPECT_EQ(one->checks, two->checks);
  for (std::size_t i = 0; i < one->plan->waypoints.size(); ++i) {
    EXPECT_EQ(one->plan->waypoints[i].joints, two->plan->waypoints[i].joints);
  }
}

TEST(Plan, ReachesPosesAndPassesThroughOthers) {
  Problem problem = robotProblem(test::robotCell());
  const auto space = FreeSpace::create(problem.scene, 1, {});
  ASSERT_TRUE(space);
  EntityConfiguration at = space->present();
  at.joints[0] = -0.6;
  problem.goal = goal::ToPose{space->toolAt(at)};
  at.joints[0] = 1.5;
  problem.through = {space->toolAt(at)};
  const auto result = plan(problem, *space);
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_TRUE(result->isSolved()) << english(result->failure->reason);
  ASSERT_EQ(result->plan->through.size(), 1U);
  const auto& passed = result->plan->waypoints[result->plan->through[0]];
  EXPECT_LT(glm::length(space->toolAt(passed).p - problem.through[0].p), 1e-6);
  EXPECT_LT(glm::length(space->toolAt(result->plan->waypoints.back()).p - std::get<goal::ToPose>(problem.goal).X_WT.p),
            1e-6);
  expectFree(problem, *result->plan);
}

TEST(Plan, TakesASolidOutOfItsBox) {
  Problem problem;
  problem.scene = test::boxWithBar(0.3);
  problem.entity = 1;
  problem.goal = goal::OutOfCell{};
  const auto result = plan(problem);
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_TRUE(result->isSolved()) << english(result->failure->reason);
  const Pose& end = result->plan->waypoints.back().X_WE;
  EXPECT_GT(std::max({std::abs(end.p.x), std::abs(end.p.y), end.p.z}), 0.26);
  expectFree(problem, *result->plan);
}

/// The opening is 0.22 m wide; the bar lies along it and is 0.2 m long: it has to stay as it lies, or turn on end.
TEST(Plan, FindsWhatIsNarrow) {
  Problem problem;
  problem.scene = test::boxWithBar(0.22);
  problem.entity = 1;
  problem.goal = goal::ToPose{Pose::translation({0.0, 0.0, 0.8})};
  problem.clearance = 0.005;
  const auto result = plan(problem);
  ASSERT_TRUE(result && result->isSolved());
  expectFree(problem, *result->plan);
}

TEST(Plan, ExplainsWhatIsOutOfReach) {
  Problem problem = robotProblem(test::robotCell());
  problem.goal = goal::ToPose{Pose::translation({3.0, 0.0, 0.5})};
  const auto result = plan(problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kReach);
  EXPECT_STREQ(toString(result->failure->kind), "reach");
  EXPECT_FALSE(result->failure->reason.empty());
}

/// Wherever the goal is, the nearest place is free and nearer than the start.
TEST(Plan, ShowsTheNearestPlaceThatIsReached) {
  Problem problem = robotProblem(test::robotCell());
  auto space = FreeSpace::create(problem.scene, 1, {});
  ASSERT_TRUE(space);
  const Pose X_WStart = space->toolAt({problem.scene->find(1)->X_WE, problem.scene->find(1)->joints()});
  for (const dvec3& p : {dvec3(3.0, 0.0, 0.5), dvec3(0.0, 9.0, 0.1), dvec3(0.2, 0.1, -2.0), dvec3(-30.0, 0.0, 0.0)}) {
    problem.goal = goal::ToPose{{p, X_WStart.q}};
    const auto result = plan(problem);
    ASSERT_TRUE(result);
    ASSERT_FALSE(result->isSolved());
    ASSERT_TRUE(result->failure->nearest) << p.x;
    EXPECT_TRUE(space->isFree(*result->failure->nearest)) << p.x;
    EXPECT_LT(result->failure->nearest_distance, glm::length(p - X_WStart.p)) << p.x;
  }
}

TEST(Plan, NamesTheJointThatIsBeyondItsLimits) {
  Problem problem = robotProblem(test::robotCell());
  std::get<goal::ToJoints>(problem.goal).joints[1] = 7.0;
  const auto result = plan(problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(english(result->failure->reason),
            "joint 'shoulder_lift_joint' of the goal is at 401.1 deg, outside its limits of -360.0 deg to 360.0 deg");
}

TEST(Plan, ExplainsAGoalThatIsBlocked) {
  Problem problem;
  problem.scene = test::boxWithBar(0.3);
  problem.entity = 1;
  problem.goal = goal::ToPose{Pose::translation({0.1, 0.0, 0.1})};
  const auto result = plan(problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kBlocked);
  EXPECT_EQ(result->failure->blocked_by, "right");
  ASSERT_TRUE(result->failure->X_WT_nearest);
  // The bar's end is at 0.2, the wall at 0.15 less the clearance.
  EXPECT_NEAR(result->failure->nearest_distance, 0.1, 0.05);
}

TEST(Plan, ExplainsThatThereIsNoWay) {
  Problem problem;
  problem.scene = test::boxWithBar(0.3, true);
  problem.entity = 1;
  problem.goal = goal::ToPose{Pose::translation({0.0, 0.0, 0.5})};
  problem.most_checks = 600;
  const auto result = plan(problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kNoWay);
  EXPECT_FALSE(result->failure->blocked_by.empty());
  ASSERT_TRUE(result->failure->X_WT_nearest);
  EXPECT_LT(result->failure->X_WT_nearest->p.z, 0.3);
}

TEST(Plan, ExplainsAStartInContact) {
  Problem problem;
  problem.scene = test::boxWithBar(0.18);  // The bar does not fit between the walls.
  problem.entity = 1;
  problem.goal = goal::OutOfCell{};
  const auto stuck = plan(problem);
  ASSERT_TRUE(stuck);
  ASSERT_FALSE(stuck->isSolved());
  EXPECT_EQ(stuck->failure->kind, Failure::Kind::kStart);
  EXPECT_TRUE(stuck->failure->blocked_by == "left" || stuck->failure->blocked_by == "right");
}

TEST(Plan, GivesUpAfterItsChecks) {
  Problem problem = robotProblem(test::robotCell());
  problem.most_checks = 1;
  const auto result = plan(problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kNoWay);
  EXPECT_TRUE(result->failure->nearest);
}

TEST(Plan, EndsWhenStopped) {
  Problem problem = robotProblem(test::robotCell());
  std::atomic<bool> stop{true};
  problem.stop = &stop;
  const auto result = plan(problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kCancelled);
}

/// A plan given as hints is taken up: the search then has straight ways only.
TEST(Plan, FollowsHints) {
  Problem problem = robotProblem(test::robotCell());
  const auto first = plan(problem);
  ASSERT_TRUE(first && first->isSolved());
  problem.hints = first->plan->waypoints;
  problem.seed = 77;
  const auto again = plan(problem);
  ASSERT_TRUE(again && again->isSolved());
  EXPECT_EQ(again->planner, "hints");
  expectFree(problem, *again->plan);
}

TEST(Plan, RefusesNumbersThatDoNotFit) {
  Problem problem = robotProblem(test::robotCell());
  problem.goal = goal::ToJoints{{0.0, 1.0}};
  EXPECT_FALSE(plan(problem));
  problem.goal = goal::OutOfCell{};
  EXPECT_FALSE(plan(problem));
  problem.goal = goal::ToRegion{Pose(), dvec3(-1.0), 0.0};
  EXPECT_FALSE(plan(problem));
  problem.clearance = -1.0;
  EXPECT_FALSE(plan(problem));
}

Problem railProblem(const test::RailCell& cell) {
  Problem problem;
  problem.scene = cell.scene;
  problem.entity = cell.robot;
  problem.with_axes = true;
  problem.goal = goal::ToPose{test::farAlongTheRail()};
  return problem;
}

TEST(Plan, RobotsMoveWithTheRailThatCarriesThem) {
  const test::RailCell cell = test::railCell();
  Problem problem = railProblem(cell);
  const auto result = plan(problem);
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_TRUE(result->isSolved()) << english(result->failure->reason);
  const std::vector<double>& end = result->plan->waypoints.back().joints;
  ASSERT_EQ(end.size(), 7U) << "the rail's joint and the robot's own";
  EXPECT_GE(end[0], -2.0);
  EXPECT_LE(end[0], 2.0);
  // The robot's own kinematics, on its base where the rail puts it.
  const workcell::Entity& robot = *cell.scene->find(cell.robot);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), {end.begin() + 1, end.end()}, X_BL);
  const Pose X_WB = Pose::translation({end[0], 0.0, 0.31});
  const int tip = robot.robot()->findLink(robot.jointed().tip_link);
  const Pose X_WT = X_WB * X_BL[static_cast<std::size_t>(tip)] * robot.jointed().X_LT;
  EXPECT_LT(glm::length(X_WT.p - test::farAlongTheRail().p), 1e-6);
  EXPECT_GT(std::abs(glm::dot(X_WT.q, test::farAlongTheRail().q)), 1.0 - 1e-9);
  auto space = FreeSpace::create(cell.scene, cell.robot, {}, {}, {}, true);
  ASSERT_TRUE(space);
  space->setClearance(problem.clearance);
  for (std::size_t i = 1; i < result->plan->waypoints.size(); ++i) {
    EXPECT_TRUE(space->isFree(result->plan->waypoints[i - 1], result->plan->waypoints[i])) << i;
  }
  // On a rail that stays, it does not reach so far.
  problem.with_axes = false;
  const auto alone = plan(problem);
  ASSERT_TRUE(alone && alone->failure);
  EXPECT_EQ(alone->failure->kind, Failure::Kind::kReach);
}

/// One axis is passed in even steps no longer than a fraction of an arm, its ends too; two follow from the seed.
TEST(AxisPlaces, CoverTheWholeTravel) {
  const test::RailCell cell = test::railCell();
  const auto space = FreeSpace::create(cell.scene, cell.robot, {}, {}, {}, true);
  ASSERT_TRUE(space);
  const kinematics::RobotModel& robot = *space->entity().robot();
  const auto places = axisPlaces(robot, 1, space->present().joints, 1);
  EXPECT_EQ(places.front(), std::vector<double>{-1.5}) << "where it stands now";
  EXPECT_NEAR(places[1][0], -2.0, 1e-12);
  EXPECT_NEAR(places.back()[0], 2.0, 1e-12);
  for (std::size_t i = 2; i < places.size(); ++i) EXPECT_LE(places[i][0] - places[i - 1][0], 0.1 + 1e-12);
  const auto of_two = axisPlaces(robot, 2, space->present().joints, 7);
  EXPECT_EQ(of_two, axisPlaces(robot, 2, space->present().joints, 7));
  EXPECT_NE(of_two, axisPlaces(robot, 2, space->present().joints, 8));
  for (const auto& place : of_two) EXPECT_TRUE(place.size() == 2 && place[0] >= -2.0 && place[0] <= 2.0);
}

TEST(Plan, GoalsWithAxesAreExplained) {
  const test::RailCell cell = test::railCell();
  Problem problem = railProblem(cell);
  problem.goal = goal::ToPose{Pose::translation({4.5, 0.0, 0.6})};
  const auto far = plan(problem);
  ASSERT_TRUE(far && far->failure);
  EXPECT_EQ(far->failure->kind, Failure::Kind::kReach);
  EXPECT_NE(english(far->failure->reason).find("wherever its external axes are"), std::string::npos);
  ASSERT_TRUE(far->failure->nearest);
  EXPECT_NEAR(far->failure->nearest->joints[0], 2.0, 1e-9) << "the end of the rail is nearest";
  problem.goal = goal::ToPose{{{0.0, 0.5, 0.6}, dquat(0.0, 1.0, 0.0, 0.0)}};
  const auto blocked = plan(problem);
  ASSERT_TRUE(blocked && blocked->failure);
  EXPECT_EQ(blocked->failure->blocked_by, "post");
  EXPECT_TRUE(blocked->failure->nearest);
  problem.goal = goal::ToJoints{{0.0, 0.0}};
  const auto refused = plan(problem);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("7 joint positions, those of the external axes first, or 6 of its own"),
            std::string::npos)
      << refused.error().message();
  std::vector<double> joints{2.5};
  const std::vector<double>& own = cell.scene->find(cell.robot)->joints();
  joints.insert(joints.end(), own.begin(), own.end());
  problem.goal = goal::ToJoints{joints};
  const auto limit = plan(problem);
  ASSERT_TRUE(limit && limit->failure);
  EXPECT_EQ(limit->failure->kind, Failure::Kind::kLimit);
  EXPECT_NE(english(limit->failure->reason).find("drive"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::planning
