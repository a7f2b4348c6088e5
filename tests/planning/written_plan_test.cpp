// SPDX-License-Identifier: Apache-2.0
#include "planning/written_plan.h"

#include <gtest/gtest.h>

#include "geometry/system/scratch_folder.h"
#include "planning/timed_plan.h"
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
