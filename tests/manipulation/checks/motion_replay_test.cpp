// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/motion_replay.h"

#include <gtest/gtest.h>

#include <numbers>

#include "kinematics/closed_form/inverse_factory.h"
#include "manipulation/checks/kept_free.h"
#include "manipulation/manipulators/arm_configuration.h"
#include "tests/manipulation/session/test_cells.h"
#include "tests/support/test_data.h"
#include "trajectory/editing/smoothing.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using test::handThrough;
using test::solid;
using trajectory::Trajectory;

workcell::Entity libraryRobot(const std::string& name) {
  Diagnostics diagnostics;
  auto entity = workcell::EntityLoader({}).load("library:" + name, 0.0, diagnostics);
  EXPECT_TRUE(entity.has_value());
  entity->id = 1;
  entity->name = "robot";
  entity->setJoints(kinematics::restPositions(*entity->robot()));
  return *entity;
}

Pose toolOf(const workcell::Entity& robot, const std::vector<double>& joints) {
  int tip = robot.robot()->findLink(robot.jointed().tip_link);
  if (tip < 0) tip = robot.robot()->defaultTip();
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), joints, X_BL);
  return robot.X_WE * X_BL[static_cast<std::size_t>(tip)] * robot.jointed().X_LT;
}

TEST(MotionReplay, BringsARobotWhereThePosesSay) {
  const workcell::Entity robot = libraryRobot("ur5e");
  const std::vector<std::shared_ptr<const workcell::Entity>> cell{std::make_shared<workcell::Entity>(robot)};
  Trajectory with, without;
  with.entity = without.entity = "robot";
  with.moved = without.moved = "tcp";
  for (const int joint : robot.robot()->moving)
    with.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  std::vector<double> start = robot.joints();
  // Bent, and away from the straight wrist on the whole way.
  start[1] = -1.3;
  start[2] = 1.4;
  start[3] = -1.5;
  start[4] = -1.2;
  for (int i = 0; i <= 50; ++i) {
    std::vector<double> q = start;
    for (std::size_t j = 0; j < q.size(); ++j) q[j] += 0.01 * i * (j % 2 == 0 ? 1.0 : -0.5);
    with.addFrame({0.02 * i, toolOf(robot, q)}, q);
    without.addFrame({0.02 * i, toolOf(robot, q)});
  }
  const auto by_joints = MotionReplay::create(cell, "robot", std::make_shared<Trajectory>(with));
  const auto by_poses = MotionReplay::create(cell, "robot", std::make_shared<Trajectory>(without), start);
  ASSERT_TRUE(by_joints && by_poses);
  for (const double t : {0.0, 0.33, 0.71, 1.0}) {
    const auto a = by_joints->at(t), b = by_poses->at(t);
    const auto off = trajectory::distanceBetween(toolOf(robot, a.joints), toolOf(robot, b.joints));
    EXPECT_LT(off.position, 1e-4) << t;
    for (std::size_t j = 0; j < a.joints.size(); ++j) EXPECT_NEAR(a.joints[j], b.joints[j], 1e-3);
  }
  EXPECT_LT(by_poses->offPose().position, 1e-6);
  const Trajectory found = by_poses->withJoints();
  ASSERT_TRUE(found.hasJoints());
  EXPECT_NEAR(found.joints(50)[0], start[0] + 0.5, 1e-6);
}

TEST(MotionReplay, PosesAndJointsAgreeAfterEither) {
  const workcell::Entity robot = libraryRobot("kuka_kr6_r900");
  Trajectory motion;
  motion.entity = "robot";
  motion.moved = "tcp";
  for (const int joint : robot.robot()->moving)
    motion.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  for (int i = 0; i <= 20; ++i) {
    std::vector<double> q = robot.joints();
    q[0] += 0.02 * i;
    q[4] += 0.5 + 0.01 * i;
    Pose X_WT = toolOf(robot, q);
    X_WT.p.z += 0.0005;  // What smoothing of both by themselves may leave.
    motion.addFrame({0.02 * i, X_WT}, q);
  }
  const auto joints = jointsFromPoses(robot, motion), poses = posesFromJoints(robot, motion);
  ASSERT_TRUE(joints && poses);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const auto q = joints->joints(i);
    EXPECT_LT(glm::distance(toolOf(robot, {q.begin(), q.end()}).p, motion[i].X_WT.p), 1e-6);
    EXPECT_NEAR(glm::distance((*poses)[i].X_WT.p, motion[i].X_WT.p), 0.0005, 1e-9);
  }
}

TEST(MotionReplay, PlacesASolidByItsMovedFrame) {
  auto box = solid(1, "box", geometry::makeBox(dvec3(0.1)), Pose::translation({1, 0, 0}));
  box.frames = {{"grip", Pose::translation({0, 0, 0.05})}};
  const std::vector<std::shared_ptr<const workcell::Entity>> cell{std::make_shared<workcell::Entity>(box)};
  auto motion = std::make_shared<Trajectory>();
  motion->entity = "box";
  motion->moved = "frame:grip";
  motion->addFrame({0.0, Pose::translation({2, 0, 0.05})});
  motion->addFrame({1.0, {{2, 0, 0.05}, quaternionFromRotationVector({0, std::numbers::pi / 2, 0})}});
  const auto replay = MotionReplay::create(cell, "box", motion);
  ASSERT_TRUE(replay.has_value());
  EXPECT_LT(glm::distance(replay->at(0.0).X_WE.p, dvec3(2, 0, 0)), 1e-12);
  EXPECT_LT(glm::distance(replay->at(1.0).X_WE.p, dvec3(1.95, 0, 0.05)), 1e-12);
  EXPECT_FALSE(MotionReplay::create(cell, "ghost", motion).has_value());
  motion->moved = "frame:nowhere";
  EXPECT_FALSE(MotionReplay::create(cell, "box", motion).has_value());
}

/// A recording that goes round the corner of a block: smoothed with a wide tolerance it would cut it.
TEST(KeptFree, IsNearerToTheRecordingWhereSmoothingWouldCollide) {
  const auto scene =
      PreparedScene::prepare({solid(1, "block", geometry::makeBox({0.2, 0.2, 0.2})),
                              solid(2, "box", geometry::makeBox(dvec3(0.02)), Pose::translation({-0.2, -0.1115, 0}))},
                             {}, {});
  Trajectory recording;
  recording.entity = "box";
  for (int i = 0; i <= 200; ++i) {
    const double s = 0.0025 * i;
    const dvec3 p = s < 0.31 ? dvec3(-0.2 + s, -0.1115, 0) : dvec3(0.1115, -0.1115 + (s - 0.3115), 0);
    recording.addFrame({0.01 * i, Pose::translation(p)});
  }
  const auto smooth = trajectory::smoothed(recording, {{0.02, 0.1}});
  const auto cut = checkPath(scene, "box", smooth.trajectory, {}, {});
  ASSERT_TRUE(cut.has_value());
  ASSERT_FALSE(cut->findings.empty()) << "the test needs a corner that is cut";
  const auto kept = keptFree(scene, recording, smooth.trajectory, {}, {});
  ASSERT_TRUE(kept.has_value());
  EXPECT_TRUE(kept->check.findings.empty());
  ASSERT_FALSE(kept->nearer.empty());
  // Far from the corner it is as it was smoothed; nowhere farther from the recording than before.
  EXPECT_EQ(kept->trajectory[0].X_WT.p, smooth.trajectory[0].X_WT.p);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    EXPECT_LE(glm::distance(kept->trajectory[i].X_WT.p, recording[i].X_WT.p),
              glm::distance(smooth.trajectory[i].X_WT.p, recording[i].X_WT.p) + 1e-12);
  }
}

/// The same corner with new times: every given frame is passed, so that frames asked far apart do not cut it.
TEST(RetimedFree, GoesRoundTheCornerHoweverFarApartFramesAreAsked) {
  const auto scene =
      PreparedScene::prepare({solid(1, "block", geometry::makeBox({0.2, 0.2, 0.2})),
                              solid(2, "box", geometry::makeBox(dvec3(0.02)), Pose::translation({-0.2, -0.1115, 0}))},
                             {}, {});
  Trajectory recording;
  recording.entity = "box";
  for (int i = 0; i <= 500; ++i) {
    const double s = 0.001 * i;
    const dvec3 p = s < 0.3115 ? dvec3(-0.2 + s, -0.1115, 0) : dvec3(0.1115, -0.1115 + (s - 0.3115), 0);
    recording.addFrame({0.01 * i, Pose::translation(p)});
  }
  ASSERT_TRUE(checkPath(scene, "box", recording, {}, {})->findings.empty());
  trajectory::RetimingOptions wide;
  wide.limits = {{0.5, 0.5, 0.5, 2, 2, 2}, {5, 5, 5, 20, 20, 20}, {}};
  wide.sample_s = 0.15;
  const auto plain = trajectory::retimed(recording, wide);
  ASSERT_TRUE(plain.has_value());
  EXPECT_TRUE(checkPath(scene, "box", plain->trajectory, {}, {})->findings.empty());
  ASSERT_EQ(plain->given.size(), plain->trajectory.size());
  for (std::size_t i = 0; i < plain->given.size(); ++i) {
    EXPECT_EQ(plain->given[i].t, plain->trajectory[i].t);
    EXPECT_LT(glm::distance(plain->given[i].X_WT.p, plain->trajectory[i].X_WT.p), 1e-4);
  }
  const auto kept = retimedFree(scene, recording, wide, {}, {});
  ASSERT_TRUE(kept.has_value()) << kept.error().message();
  EXPECT_TRUE(kept->kept.check.findings.empty());
  EXPECT_EQ(kept->kept.trajectory.size(), plain->trajectory.size()) << "nothing has to be closer together";
  EXPECT_NEAR(kept->kept.trajectory.duration(), plain->trajectory.duration(), 1e-6);
  wide.limits.velocity.clear();
  EXPECT_FALSE(retimedFree(scene, recording, wide, {}, {}).has_value());
  recording.entity = "nobody";
  EXPECT_FALSE(retimedFree(scene, recording, wide, {}, {}).has_value());
}

/// The tool at the end of a long arm is farther off than its joints are.
TEST(RetimedByJoints, PassesTheGivenPlacesOfTheTool) {
  const workcell::Entity robot = libraryRobot("kuka_kr16_2");
  const auto placed = [&](const Trajectory& motion) { return posesFromJoints(robot, motion); };
  Trajectory motion;
  motion.entity = "robot";
  motion.moved = "tcp";
  for (const int joint : robot.robot()->moving)
    motion.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  for (int i = 0; i <= 6; ++i) {
    std::vector<double> q = robot.joints();
    for (std::size_t j = 0; j < q.size(); ++j) q[j] += 0.3 * ((i * (static_cast<int>(j) + 2)) % 5);
    motion.addFrame({0.5 * i, toolOf(robot, q)}, q);
  }
  ASSERT_TRUE(posesFollowJoints(motion, placed));
  trajectory::RetimingOptions options;
  options.limits = {std::vector<double>(6, 2.0), std::vector<double>(6, 8.0), {}};
  options.tolerance = {2e-5, 2e-4, 1e-3};  // As closely as 0.02 mm, where joints may be 1 mrad off.
  const auto made = retimedByJoints(motion, options, placed);
  ASSERT_TRUE(made.has_value()) << made.error().message();
  for (std::size_t k = 0; k < motion.size(); ++k) {  // By forward kinematics between the new frames.
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < made->trajectory.size(); ++i) {
      const dvec3 a = made->trajectory[i].X_WT.p, b = made->trajectory[i + 1].X_WT.p, p = motion[k].X_WT.p;
      const double share = a == b ? 0.0 : std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(p, a + share * (b - a)));
      const auto q = made->trajectory.joints(i);
      EXPECT_LT(glm::distance(toolOf(robot, {q.begin(), q.end()}).p, a), 1e-9) << i;
    }
    EXPECT_LE(nearest, 2e-5 * (1.0 + 1e-6)) << k;
  }
  EXPECT_LE(made->report.max_deviation.position, 2e-5);

  Trajectory other = motion.emptyCopy();
  for (std::size_t i = 0; i < motion.size(); ++i) {
    Trajectory::Frame frame = motion[i];
    frame.X_WT.p.x += 0.1;
    other.addFrame(frame, motion.joints(i));
  }
  EXPECT_FALSE(posesFollowJoints(other, placed));
  EXPECT_TRUE(retimedByJoints(other, options, placed).has_value());
  EXPECT_FALSE(posesFollowJoints(motion, {}));
}

TEST(PathCheck, CanBeEndedAndTellsHowFarItIs) {
  const auto scene = PreparedScene::prepare(
      {solid(1, "wall", geometry::makeBox({0.001, 1, 1})), solid(2, "box", geometry::makeBox(dvec3(0.02)))}, {}, {});
  Trajectory motion;
  for (int i = 0; i <= 1000; ++i) motion.addFrame({0.01 * i, Pose::translation({0.1 + 0.0001 * i, 0, 0})});
  PathCheckOptions options;
  std::vector<double> told;
  options.progress = [&](double share) {
    told.push_back(share);
    return share < 0.5;
  };
  const auto result = checkPath(scene, "box", motion, options, {});
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->cancelled);
  EXPECT_GT(told.size(), 10u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

TEST(PathCheck, TellsWhereTheArmChangesItsConfiguration) {
  workcell::Entity robot = libraryRobot("kuka_kr6_r900");
  const auto chain = sixAxisChain(robot);
  ASSERT_TRUE(chain.has_value());
  Trajectory motion;
  motion.entity = "robot";
  for (const int joint : robot.robot()->moving)
    motion.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  for (int i = 0; i <= 20; ++i) {
    std::vector<double> q = robot.joints();
    q[4] = 0.4 - 0.04 * i;  // The wrist goes through its straight position.
    motion.addFrame({0.1 * i, toolOf(robot, q)}, q);
  }
  robot.checked = false;
  const auto result = checkPath(PreparedScene::prepare({robot}, {}, {}), "robot", motion, {}, {});
  ASSERT_TRUE(result.has_value()) << result.error().message();
  const auto change = std::find_if(result->findings.begin(), result->findings.end(),
                                   [](const auto& f) { return f.kind == PathFinding::Kind::kConfiguration; });
  ASSERT_NE(change, result->findings.end());
  EXPECT_NEAR(change->t_in, 1.05, 0.06);
  EXPECT_EQ(change->first, "wrist");
}

}  // namespace
}  // namespace hapticell::manipulation
