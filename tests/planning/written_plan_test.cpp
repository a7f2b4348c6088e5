// SPDX-License-Identifier: Apache-2.0
#include "planning/written_plan.h"

#include <gtest/gtest.h>

#include <functional>

#include "geometry/system/scratch_folder.h"
#include "planning/axis_motions.h"
#include "planning/timed_plan.h"
#include "planning/written_poses.h"
#include "tests/planning/planning_cells.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::planning {
namespace {

struct Made {
  Problem problem;
  Plan plan;
  trajectory::Trajectory motion;
};

Made makeAroundTheWall() {
  Made made;
  made.problem.scene = test::robotCell(true);
  made.problem.entity = 1;
  std::vector<double> joints = made.problem.scene->find(1)->joints();
  joints[0] = -0.6;
  made.problem.goal = goal::ToJoints{joints};
  made.problem.clearance = 0.01;
  const auto space = FreeSpace::create(made.problem.scene, 1, {});
  const auto result = plan(made.problem, *space);
  made.plan = *result->plan;
  made.motion = *timedMotion(made.plan, *space);
  return made;
}

Promises measured(const Made& made, const trajectory::Trajectory& motion) {
  const auto folder = ScratchFolder::make();
  const auto file = folder->path() / "plan.htraj";
  EXPECT_TRUE(workcell::writeFileAtomically(file, trajectory::toJsonText(motion)));
  const auto promises = writtenPlanPromises(file, made.plan, made.problem.clearance, made.problem.scene, 1);
  EXPECT_TRUE(promises) << promises.error().message();
  return *promises;
}

TEST(WrittenPlan, KeepsItsPromises) {
  const Made made = makeAroundTheWall();
  const Promises promises = measured(made, made.motion);
  EXPECT_TRUE(promises.areKept()) << promises.missed("plan").message();
  EXPECT_GE(promises.list.front().measured, 0.01 - 1e-6);
  // Every joint keeps its greatest speed.
  const auto& robot = *made.problem.scene->find(1)->robot();
  for (std::size_t i = 1; i < made.motion.size(); ++i) {
    for (std::size_t j = 0; j < robot.dof(); ++j) {
      const double speed =
          (made.motion.joints(i)[j] - made.motion.joints(i - 1)[j]) / (made.motion[i].t - made.motion[i - 1].t);
      EXPECT_LE(std::abs(speed),
                kinematics::greatestSpeed(robot.joints[static_cast<std::size_t>(robot.moving[j])]) * 1.001);
    }
  }
}

/// What the robot touches as it stands in the cell is in the way of a plan that begins elsewhere like all else: it was
/// left out, and the plan led through it.
TEST(WrittenPlan, KeepsClearOfWhatTheRobotTouchesInTheCell) {
  Problem problem;
  std::vector<workcell::Entity> entities{test::loaded("library:ur5e", 1, "robot", {})};
  workcell::Entity& robot = entities.front();
  const std::vector<double> from{0.6, -1.2, 1.2, -1.5, -1.5, 0.0}, to{-0.6, -1.2, 1.2, -1.5, -1.5, 0.0};
  robot.setJoints({0.0, -1.2, 1.2, -1.5, -1.5, 0.0});  // Half way.
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
  const dvec3 p_W = X_BL[static_cast<std::size_t>(robot.robot()->defaultTip())].p;
  entities.push_back(test::loaded("box:0.1,0.1,0.1", 2, "block", Pose::translation(p_W)));
  // Link 1 turns in it wherever it is: that is no contact to plan for.
  entities.push_back(test::loaded("box:0.06,0.06,0.08", 3, "axle", Pose::translation({0.0, 0.0, 0.09})));
  problem.scene = manipulation::PreparedScene::prepare(std::move(entities), {}, {});
  problem.entity = 1;
  problem.start = EntityConfiguration{{}, from};
  problem.goal = goal::ToJoints{to};
  const auto space = FreeSpace::create(problem.scene, 1, {});
  ASSERT_TRUE(space);
  EXPECT_EQ(english(space->note()).find("block"), std::string::npos) << english(space->note());
  EXPECT_NE(english(space->note()).find("axle"), std::string::npos) << english(space->note());
  const auto result = plan(problem, *space);
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_TRUE(result->isSolved()) << english(result->failure->reason);
  EXPECT_NE(result->planner, "straight");
  const Made made{problem, *result->plan, *timedMotion(*result->plan, *space)};
  const Promises promises = measured(made, made.motion);
  EXPECT_TRUE(promises.areKept()) << promises.missed("plan").message();
  EXPECT_LT(promises.list.front().measured, 0.05);
}

double valueOf(const Promises& promises, const std::string& name) {
  for (const Promise& one : promises.list)
    if (one.name == name) return one.measured;
  ADD_FAILURE() << name;
  return -1.0;
}

/// The motions of a robot and of its rail as files; the rail's may be changed before it is written.
Expected<Promises> measuredOnRail(const std::function<double(double)>& change, const test::RailCell& cell,
                                  std::vector<trajectory::Trajectory>* written = nullptr) {
  Problem problem;
  problem.scene = cell.scene;
  problem.entity = cell.robot;
  problem.with_axes = true;
  problem.goal = goal::ToPose{test::farAlongTheRail()};
  const auto space = FreeSpace::create(cell.scene, cell.robot, {}, {}, {}, true);
  HAPTICELL_TRY(space);
  const auto result = plan(problem, *space);
  HAPTICELL_TRY(result);
  if (!result->isSolved()) return makeError({.found = result->failure->reason, .expected = "a plan"});
  const auto motion = timedMotion(*result->plan, *space);
  HAPTICELL_TRY(motion);
  std::vector<trajectory::Trajectory> motions = motionsOfEntities(*motion, *space);
  trajectory::Trajectory changed = motions[1].emptyCopy();
  for (std::size_t i = 0; i < motions[1].size(); ++i) {
    const double q = change(motions[1].joints(i)[0]);
    changed.addFrame(motions[1][i], std::span(&q, 1));
  }
  motions[1] = std::move(changed);
  const auto folder = ScratchFolder::make();
  const auto own = folder->path() / "robot.htraj", rail = folder->path() / "rail.htraj";
  EXPECT_TRUE(workcell::writeFileAtomically(own, trajectory::toJsonText(motions[0])));
  EXPECT_TRUE(workcell::writeFileAtomically(rail, trajectory::toJsonText(motions[1])));
  if (written != nullptr) *written = motions;
  return writtenPlanPromises({own, {rail}}, *result->plan, problem.clearance, cell.scene, cell.robot);
}

TEST(WrittenPlan, KeepsItsPromisesOnARail) {
  const test::RailCell cell = test::railCell();
  std::vector<trajectory::Trajectory> motions;
  const auto promises = measuredOnRail([](double q) { return q; }, cell, &motions);
  ASSERT_TRUE(promises) << promises.error().message();
  EXPECT_TRUE(promises->areKept()) << promises->missed("plan").message();
  EXPECT_GE(promises->list.front().measured, 0.005 - 1e-6);
  EXPECT_LE(valueOf(*promises, "axis_speed"), 1.0 + 1e-6);
  EXPECT_GT(valueOf(*promises, "axis_speed"), 0.1) << "the rail moves";
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[0].entity, "robot");
  EXPECT_EQ(motions[0].joint_names.size(), 6U);
  EXPECT_EQ(motions[1].entity, "rail");
  EXPECT_EQ(motions[1].joint_names, std::vector<std::string>{"drive"});
  EXPECT_EQ(motions[1].moved, "frame:plate");
  for (std::size_t i = 0; i < motions[1].size(); ++i) {
    EXPECT_EQ(motions[0][i].t, motions[1][i].t);
    EXPECT_NEAR(motions[1][i].X_WT.p.x, motions[1].joints(i)[0], 1e-12) << "the plate's pose";
  }
}

TEST(WrittenPlan, ARailThatMovesOtherwiseIsFound) {
  const test::RailCell cell = test::railCell();
  const auto shifted = measuredOnRail([](double q) { return q + 0.1; }, cell);
  ASSERT_TRUE(shifted) << shifted.error().message();
  EXPECT_NEAR(valueOf(*shifted, "start"), 0.1, 1e-9);
  EXPECT_NEAR(valueOf(*shifted, "pose"), 0.1, 1e-3);
  const auto fast = measuredOnRail([](double q) { return -1.5 + 2.0 * (q + 1.5); }, cell);
  ASSERT_TRUE(fast) << fast.error().message();
  EXPECT_FALSE(fast->areKept());
  EXPECT_GT(valueOf(*fast, "limits") + valueOf(*fast, "axis_speed") + valueOf(*fast, "goal"), 0.5);
}

/// A straight way of a metre that is passed at its middle, and turned by 0.02 rad against that pose.
TEST(WrittenPoses, MeasuresPlaceAndTurnBetweenFrames) {
  trajectory::Trajectory motion;
  motion.entity = "bar";
  for (int i = 0; i < 4; ++i) {
    trajectory::Trajectory::Frame frame;
    frame.t = i;
    frame.X_WT = Pose::translation({i / 3.0, 0.0, 0.0});
    motion.addFrame(frame, {});
  }
  const auto scene = test::boxWithBar(0.3);
  const auto poses = writtenPoses(motion, {}, *scene->find(1), {});
  ASSERT_EQ(poses.size(), 4u);
  Plan plan;
  plan.X_WThrough = {Pose{{0.5, 0.0, 0.0}, glm::angleAxis(0.02, dvec3(0.0, 0.0, 1.0))}};
  const auto turned = posePromises(motion, poses, plan);
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_NEAR(turned.front().measured, 0.002, 1e-9);
  EXPECT_FALSE(turned.front().isKept());
  plan.X_WThrough = {Pose::translation({0.5, 5e-4, 0.0})};
  plan.X_WGoal = Pose::translation({1.0, 0.0, 0.0});
  const auto passed = posePromises(motion, poses, plan);
  ASSERT_EQ(passed.size(), 2u);
  EXPECT_NEAR(passed.front().measured, 5e-4, 1e-9);
  EXPECT_TRUE(passed.front().isKept() && passed.back().isKept());
}

/// It ended at 0.05 m: a motion far from everything was called near.
TEST(WrittenPlan, SaysHowFarTheMotionKeepsAway) {
  Made made;
  made.problem.scene = manipulation::PreparedScene::prepare(
      {test::loaded("box:0.2,0.2,0.2", 1, "part", {}),
       test::loaded("box:0.2,0.2,0.2", 2, "block", Pose::translation({0.6, 0.0, 0.0}))},
      {}, {});
  made.problem.entity = 1;
  made.problem.goal = goal::ToPose{Pose::translation({0.0, 0.1, 0.0})};
  const auto space = FreeSpace::create(made.problem.scene, 1, {});
  const auto result = plan(made.problem, *space);
  ASSERT_TRUE(result && result->isSolved());
  made.plan = *result->plan;
  made.motion = *timedMotion(made.plan, *space);
  EXPECT_NEAR(valueOf(measured(made, made.motion), "clearance"), 0.4, 1e-6);
}

/// Poses that are passed in their order are found on the file; in another order, or beside the way, they are missed.
TEST(WrittenPlan, PassesItsPosesInTheirOrder) {
  Made made;
  made.problem.scene = test::boxWithBar(0.3);
  made.problem.entity = 1;
  made.problem.goal = goal::ToPose{Pose::translation({0.5, 0.0, 0.1})};
  made.problem.clearance = 0.02;
  made.problem.through = {Pose::translation({0.0, 0.0, 0.6}),
                          {{0.5, 0.0, 0.6}, glm::angleAxis(0.4, dvec3(0.0, 0.0, 1.0))}};
  const auto space = FreeSpace::create(made.problem.scene, 1, {});
  const auto result = plan(made.problem, *space);
  ASSERT_TRUE(result && result->isSolved());
  made.plan = *result->plan;
  made.motion = *timedMotion(made.plan, *space);
  const Promises promises = measured(made, made.motion);
  EXPECT_TRUE(promises.areKept()) << promises.missed("plan").message();
  EXPECT_LT(valueOf(promises, "through"), 1e-3);
  EXPECT_LT(valueOf(promises, "pose"), 1e-5);
  std::swap(made.plan.X_WThrough[0], made.plan.X_WThrough[1]);
  EXPECT_GT(valueOf(measured(made, made.motion), "through"), 0.1);
  std::swap(made.plan.X_WThrough[0], made.plan.X_WThrough[1]);
  made.plan.X_WThrough[1].p.y += 3e-3;
  EXPECT_NEAR(valueOf(measured(made, made.motion), "through"), 3e-3, 1e-3);
  made.plan.X_WGoal->q = glm::angleAxis(0.1, dvec3(1.0, 0.0, 0.0));
  EXPECT_NEAR(valueOf(measured(made, made.motion), "pose"), 0.01, 1e-4);
}

/// A bar that lies on a plate, flush or pressed in by `depth` (m), beside a wall.
Made makeFromThePlate(double depth) {
  Made made;
  std::vector<workcell::Entity> entities{
      test::loaded("box:0.2,0.04,0.04", 1, "bar", Pose::translation({0.0, 0.0, 0.02 - depth})),
      test::loaded("box:1.0,1.0,0.1", 2, "plate", Pose::translation({0.0, 0.0, -0.05})),
      test::loaded("box:0.02,1.0,0.3", 3, "wall", Pose::translation({0.25, 0.0, 0.15}))};
  made.problem.scene = manipulation::PreparedScene::prepare(std::move(entities), {}, {});
  made.problem.entity = 1;
  made.problem.goal = goal::ToPose{Pose::translation({0.5, 0.0, 0.02})};  // On the plate again, behind the wall.
  made.problem.leaves_contact = true;
  return made;
}

TEST(WrittenPlan, LeavesAndReachesContacts) {
  for (const double depth : {0.0, 8e-4}) {
    Made made = makeFromThePlate(depth);
    const auto space = FreeSpace::create(made.problem.scene, 1, {});
    const auto result = plan(made.problem, *space);
    ASSERT_TRUE(result && result->isSolved()) << english(result->failure->reason);
    made.plan = *result->plan;
    made.motion = *timedMotion(made.plan, *space);
    const auto folder = ScratchFolder::make();
    const auto file = folder->path() / "plan.htraj";
    ASSERT_TRUE(workcell::writeFileAtomically(file, trajectory::toJsonText(made.motion)));
    const auto check = checkWrittenPlan(file, made.plan, made.problem.clearance, made.problem.scene, 1);
    ASSERT_TRUE(check);
    EXPECT_TRUE(check->promises.areKept()) << check->promises.missed("plan").message();
    EXPECT_GE(check->promises.list.front().measured, made.problem.clearance - 1e-6);
    ASSERT_EQ(check->tight.size(), 2u);
    const TightPair &left = check->tight.front(), &reached = check->tight.back();
    EXPECT_EQ(left.moved + left.met, "barplate");
    EXPECT_NEAR(left.gap, -depth, 1e-5);
    EXPECT_TRUE(!left.is_reached && reached.is_reached);
    // By the height of the bar's under side, which the file has: clear in between, and only so.
    double high = -1.0;
    for (std::size_t i = 0; i < made.motion.size(); ++i) {
      const double height = made.motion[i].X_WT.p.z - 0.02;
      const bool is_flat = made.motion[i].X_WT.q.w > 1.0 - 1e-9;
      const bool is_between = made.motion[i].t > left.t && made.motion[i].t < reached.t;
      EXPECT_TRUE(!is_between || !is_flat || height > 0.004);
      if (made.motion[i].t > left.t) continue;
      EXPECT_GT(height, high - 1e-4);
      high = std::max(high, height);
    }
    EXPECT_GT(left.t, 0.0);
    EXPECT_LT(left.t, reached.t);
  }
}

TEST(WrittenPlan, RefusesWhatIsTooDeep) {
  Made made = makeFromThePlate(2e-3);
  const auto result = plan(made.problem);
  ASSERT_TRUE(result);
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kStart);
  const std::string reason = english(result->failure->reason);
  EXPECT_NE(reason.find("bar is 2.0 mm deep in plate"), std::string::npos) << reason;
  EXPECT_NE(reason.find("move bar out of it"), std::string::npos) << reason;
}

/// Along the plate, into it on the way, and never clear: the check finds each, whatever the plan claims.
TEST(WrittenPlan, FindsAContactThatIsNotLeft) {
  Made made = makeFromThePlate(0.0);
  made.plan.leaves_contact = true;
  const auto motionOf = [&](std::vector<dvec3> places) {
    made.motion = {};
    made.motion.entity = "bar";
    made.motion.moved = "self_origin";
    made.plan.waypoints.clear();
    for (const dvec3& p_W : places) {
      trajectory::Trajectory::Frame frame;
      frame.t = static_cast<double>(made.motion.size());
      frame.X_WT = Pose::translation(p_W);
      made.motion.addFrame(frame, {});
      made.plan.waypoints.push_back({frame.X_WT, {}});
    }
    return measured(made, made.motion);
  };
  EXPECT_TRUE(motionOf({{0.0, 0.0, 0.02}, {0.0, 0.0, 0.1}}).areKept());
  const Promises along = motionOf({{0.0, 0.0, 0.02}, {-0.2, 0.0, 0.02}, {-0.2, 0.0, 0.1}});
  EXPECT_FALSE(along.areKept());
  const Promises through = motionOf({{0.0, 0.0, 0.02}, {0.0, 0.0, 0.1}, {-0.2, 0.0, 0.0}, {-0.2, 0.0, 0.1}});
  ASSERT_FALSE(through.areKept());
  const std::string sentence = through.missed("plan").message();
  EXPECT_NE(sentence.find("bar touches plate"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("allow-miss"), std::string::npos) << sentence;
  const Promises into = motionOf({{0.0, 0.0, 0.02}, {0.0, 0.0, 0.0195}, {0.0, 0.0, 0.1}});
  ASSERT_FALSE(into.areKept());
  EXPECT_EQ(into.worst()->name, "closing") << into.missed("plan").message();
  EXPECT_NEAR(into.worst()->measured, 5e-4, 1e-5);
  EXPECT_FALSE(motionOf({{0.0, 0.0, 0.02}, {0.0, 0.0, 0.1}, {0.0, 0.0, 0.023}, {0.0, 0.0, 0.2}}).areKept());
}

/// The straight way leads through the wall: the check says so, whatever the plan claims.
TEST(WrittenPlan, FindsAMotionThroughTheWall) {
  Made made = makeAroundTheWall();
  trajectory::Trajectory straight = made.motion.emptyCopy();
  straight.addFrame(made.motion[0], made.motion.joints(0));
  auto last = made.motion[made.motion.size() - 1];
  straight.addFrame(last, made.motion.joints(made.motion.size() - 1));
  const Promises promises = measured(made, straight);
  EXPECT_FALSE(promises.areKept());
  EXPECT_EQ(promises.list[0].measured, 0.0);
  EXPECT_GT(promises.list[1].measured, 0.0);
}

TEST(WrittenPlan, FindsAnotherGoal) {
  Made made = makeAroundTheWall();
  made.plan.waypoints.back().joints[3] += 1e-3;
  const Promises promises = measured(made, made.motion);
  ASSERT_FALSE(promises.areKept());
  EXPECT_EQ(promises.worst()->name, "goal");
}

}  // namespace
}  // namespace hapticell::planning
