// SPDX-License-Identifier: Apache-2.0
#include "planning/search.h"

#include <gtest/gtest.h>

#include "planning/coordinates.h"
#include "planning/goal_states.h"
#include "planning/shortening.h"
#include "tests/planning/planning_cells.h"

namespace hapticell::planning {
namespace {

/// From one side of the wall to the other.
SearchJob jobAroundTheWall(FreeSpace& space) {
  SearchJob job;
  job.start = space.present();
  EntityConfiguration goal = space.present();
  goal.joints[0] = -0.6;
  job.goals = {goal};
  EXPECT_TRUE(space.isFree(job.start)) << english(space.blocker() ? space.blocker()->text() : Text());
  EXPECT_TRUE(space.isFree(goal)) << english(space.blocker() ? space.blocker()->text() : Text());
  EXPECT_FALSE(space.isFree(job.start, goal));
  return job;
}

TEST(Coordinates, OfJointsAreMetresOfThePartsAndComeBack) {
  auto space = FreeSpace::create(test::robotCell(), 1, {});
  ASSERT_TRUE(space);
  const SearchJob job = jobAroundTheWall(*space);
  const Coordinates coordinates(*space, job);
  const ompl::base::StateSpacePtr states = coordinates.makeSpace();
  ompl::base::State *a = states->allocState(), *b = states->allocState();
  std::mt19937_64 random(2), again(2);
  const auto& robot = *space->entity().robot();
  for (int i = 0; i < 200; ++i) {
    coordinates.sample(random, a);
    coordinates.sample(again, b);
    EXPECT_EQ(states->distance(a, b), 0.0) << "by the seed alone";
    EXPECT_TRUE(states->satisfiesBounds(a));
    const EntityConfiguration at = coordinates.read(a);
    for (std::size_t k = 0; k < at.joints.size(); ++k) {
      const auto& joint = robot.joints[static_cast<std::size_t>(robot.moving[k])];
      EXPECT_GE(at.joints[k], joint.lower - 1e-9);
      EXPECT_LE(at.joints[k], joint.upper + 1e-9);
    }
    coordinates.write(at, b);
    EXPECT_LT(states->distance(a, b), 1e-12);
    // One joint alone: what OMPL calls a distance is what the parts move at most, and at least what the tool does.
    EntityConfiguration turned = job.start;
    const std::size_t k = static_cast<std::size_t>(i) % turned.joints.size();
    turned.joints[k] += 0.1;
    coordinates.write(job.start, a);
    coordinates.write(turned, b);
    EXPECT_NEAR(states->distance(a, b), coordinates.distance(job.start, turned), 1e-12);
    std::vector<Pose> before, after;
    kinematics::forwardKinematics(robot, job.start.joints, before);
    kinematics::forwardKinematics(robot, turned.joints, after);
    EXPECT_GE(states->distance(a, b), glm::distance(before.back().p, after.back().p) - 1e-9) << "joint " << k;
  }
  states->freeState(a);
  states->freeState(b);
}

TEST(Coordinates, OfAPartArePosesInTheCell) {
  auto space = FreeSpace::create(test::boxWithBar(0.3), 1, {});
  ASSERT_TRUE(space);
  SearchJob job;
  job.start = space->present();
  const Coordinates coordinates(*space, job);
  const ompl::base::StateSpacePtr states = coordinates.makeSpace();
  ompl::base::State* state = states->allocState();
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    coordinates.sample(random, state);
    EXPECT_TRUE(states->satisfiesBounds(state));
    EXPECT_NEAR(glm::length(coordinates.read(state).X_WE.q), 1.0, 1e-12);
  }
  EntityConfiguration moved = job.start;
  moved.X_WE.p += dvec3(0.03, 0.0, 0.04);
  EXPECT_NEAR(coordinates.distance(job.start, moved), 0.05, 1e-12);
  moved.X_WE.q = glm::angleAxis(0.2, dvec3(0, 0, 1)) * moved.X_WE.q;
  EXPECT_NEAR(coordinates.distance(job.start, moved), 0.05 + 0.2 * space->radius(), 1e-9);
  states->freeState(state);
}

TEST(Search, DoesNotDependOnThreads) {
  auto space = FreeSpace::create(test::robotCell(), 1, {});
  ASSERT_TRUE(space);
  space->setClearance(0.01);
  SearchJob job = jobAroundTheWall(*space);
  job.seed = 5;
  const SearchResult one = search(*space, job);
  job.threads = 4;
  const SearchResult four = search(*space, job);
  ASSERT_GT(one.path.size(), 2U);
  ASSERT_EQ(one.path.size(), four.path.size());
  EXPECT_EQ(one.checks, four.checks);
  for (std::size_t i = 0; i < one.path.size(); ++i) EXPECT_EQ(one.path[i].joints, four.path[i].joints);
  for (std::size_t i = 1; i < one.path.size(); ++i) EXPECT_TRUE(space->isFree(one.path[i - 1], one.path[i]));
}

TEST(Search, OfBothKindsFindsAWay) {
  auto space = FreeSpace::create(test::robotCell(), 1, {});
  ASSERT_TRUE(space);
  SearchJob job = jobAroundTheWall(*space);
  for (const auto method : {SearchKind::Method::kRrtConnect, SearchKind::Method::kBiEst}) {
    job.kinds = {{method, 0.1}};
    const SearchResult found = search(*space, job);
    EXPECT_FALSE(found.path.empty()) << toString(method);
    EXPECT_EQ(found.planner, toString(method));
  }
}

TEST(Shortened, IsFasterAndStillFree) {
  auto space = FreeSpace::create(test::robotCell(), 1, {});
  ASSERT_TRUE(space);
  space->setClearance(0.01);
  const SearchResult found = search(*space, jobAroundTheWall(*space));
  ASSERT_GT(found.path.size(), 2U);
  const auto path = shortened(*space, found.path, 1);
  const auto timeOf = [&](const auto& way) {
    double sum = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) sum += leastTime(*space, way[i - 1], way[i]);
    return sum;
  };
  EXPECT_LE(timeOf(path), timeOf(found.path));
  EXPECT_EQ(path.front().joints, found.path.front().joints);
  EXPECT_EQ(path.back().joints, found.path.back().joints);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_TRUE(space->isFree(path[i - 1], path[i])) << i;
}

TEST(GoalStates, AreAllConfigurationsOfAPose) {
  auto space = FreeSpace::create(test::robotCell(), 1, {});
  ASSERT_TRUE(space);
  const EntityConfiguration start = space->present();
  const Pose X_WT = space->toolAt(start);
  const auto states = goalStates(goal::ToPose{X_WT}, *space, start, 1);
  ASSERT_TRUE(states) << states.error().message();
  EXPECT_GT(states->free.size(), 2U);
  for (const auto& one : states->free) {
    EXPECT_LT(glm::length(difference(space->toolAt(one), X_WT).linear), 1e-6);
    EXPECT_TRUE(space->isFree(one));
  }
}

}  // namespace
}  // namespace hapticell::planning
