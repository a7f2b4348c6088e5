// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/closed_form/inverse_factory.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/manipulators/robot_manipulator.h"
#include "manipulation/manipulators/symmetric.h"
#include "workcell/document/document.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity load(const std::string& what) {
  Diagnostics notes;
  return workcell::EntityLoader(".").load(what, 1.0, notes).value();
}

struct Robot {
  std::shared_ptr<const kinematics::RobotModel> model;
  std::unique_ptr<RobotManipulator> manipulator;
  EntityConfiguration at;
  std::size_t parts = 0;
};

Robot closedRobot(const std::string& name) {
  Robot robot;
  robot.model = load(name).robot();
  const int tip = robot.model->defaultTip();
  std::vector<int> links;
  for (std::size_t k = 0; k < robot.model->links.size(); ++k) links.push_back(static_cast<int>(k));
  robot.parts = links.size();
  robot.manipulator = std::make_unique<RobotManipulator>(robot.model, RobotManipulator::Tool{tip, {}},
                                                         kinematics::createInverse(*robot.model, tip).value(),
                                                         RobotManipulator::partsOf(links));
  robot.at = {Pose::translation({0.3, -0.2, 1.0}), kinematics::restPositions(*robot.model)};
  return robot;
}

Twist alongXi(const std::array<double, 6>& xi) {
  return {{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}};
}

class ClosedRobot : public testing::TestWithParam<const char*> {};

// The parts' second-order motion, against the robot itself moved there by its inverse model.
TEST_P(ClosedRobot, ItsPartsFollowAsTheirDifferentialSays) {
  Robot robot = closedRobot(GetParam());
  const auto differential = robot.manipulator->differentiate(robot.at);
  std::vector<Pose> before(robot.parts), after(robot.parts);
  robot.manipulator->partPoses(robot.at, before);
  const bool turns = robot.model->dof() == 6;
  const double h = 2e-3;
  const std::array<double, 6> directions[] = {
      {h, 0, 0, 0, 0, 0}, {0, h, -h, 0, 0, 0}, {h, h, h, 0, 0, 0}, {0, 0, h, h, 0, h}, {h, 0, 0, 0, -h, h}};
  for (const auto& xi : directions) {
    if (!turns && (xi[3] != 0.0 || xi[4] != 0.0 || xi[5] != 0.0)) continue;
    const Pose X_WM = displaced(robot.manipulator->movedFrame(robot.at), alongXi(xi));
    const EntityConfiguration there = robot.manipulator->propose(robot.at, X_WM, 1.0);
    robot.manipulator->partPoses(there, after);
    for (std::size_t k = 0; k < robot.parts; ++k) {
      dvec3 moved(0.0);
      for (std::size_t i = 0; i < 6; ++i) {
        moved += xi[i] * differential[k].velocity[i].linear;
        for (std::size_t j = 0; j < 6; ++j) {
          const std::size_t at = i <= j ? packedIndex(i, j) : packedIndex(j, i);
          moved += 0.5 * xi[i] * xi[j] * differential[k].acceleration[at].linear;
        }
      }
      EXPECT_NEAR(glm::length(after[k].p - before[k].p - moved), 0.0, 2e-7) << robot.model->links[k].name;
    }
  }
}

TEST_P(ClosedRobot, PathBoundsHoldAndLimitsAreTold) {
  Robot robot = closedRobot(GetParam());
  EntityConfiguration to = robot.at;
  to.joints[0] += 0.01;
  to.joints[1] -= 0.02;
  std::vector<PartSphere> spheres(robot.parts, {{0.05, 0.0, 0.1}, 0.2});
  std::vector<double> bounds(robot.parts);
  robot.manipulator->pathBounds(robot.at, to, spheres, bounds);
  std::vector<Pose> before(robot.parts), after(robot.parts);
  robot.manipulator->partPoses(robot.at, before);
  std::vector<double> length(robot.parts, 0.0);
  for (int k = 1; k <= 50; ++k) {
    robot.manipulator->partPoses(robot.manipulator->between(robot.at, to, k / 50.0), after);
    for (std::size_t i = 0; i < robot.parts; ++i) {
      const dvec3 point = spheres[i].p_PS + dvec3(0.0, 0.2, 0.0);
      length[i] += glm::length(after[i] * point - before[i] * point);
    }
    std::swap(before, after);
  }
  for (std::size_t i = 0; i < robot.parts; ++i) EXPECT_LE(length[i], bounds[i] + 1e-12);
  // A joint's end that is near is a limit; so is what the closure says of itself.
  robot.at.joints[0] = robot.model->joints[static_cast<std::size_t>(robot.model->moving[0])].upper - 1e-3;
  const auto limits = robot.manipulator->limits(robot.at, 0.05, 0.1);
  const bool upper = std::any_of(limits.begin(), limits.end(), [](const MotionLimit& limit) {
    return limit.text.id() == "%1 is %2 from its upper limit";
  });
  EXPECT_TRUE(upper);
}

INSTANTIATE_TEST_SUITE_P(Library, ClosedRobot,
                         testing::Values("library:fanuc_dr_3ib", "library:omnid_delta", "library:hexapod_motion_base"));

TEST(Carried, AGrippedPartMovesWithTheRobotAndStopsAtWhatItMeets) {
  workcell::Document document;
  const auto add = [&](const std::string& what, const std::string& name, const Pose& X_WE) {
    workcell::Entity entity = load(what);
    entity.name = name;
    entity.X_WE = X_WE;
    if (entity.robot()) entity.editJointed().joints.assign(entity.robot()->dof(), 0.0);  // The flange ahead.
    return document.execute(workcell::AddEntity{std::move(entity)}).value();
  };
  const auto robot = add("library:fanuc_lr_mate_200id", "robot", {});
  const Pose X_WT = workcell::carrierPose(*document.find(robot), "tool0");
  // A rod in front of the flange, and a wall that only the rod can reach.
  const auto rod = add("box:0.02,0.02,0.3", "rod", X_WT * Pose::translation({0, 0, 0.16}));
  const auto wall = add("box:0.02,1,1", "wall", Pose::translation({X_WT.p.x + 0.36, 0, X_WT.p.z}));
  ASSERT_TRUE(document.execute(workcell::Attach{rod, robot, "tool0"}));
  const auto scene = PreparedScene::prepare(document.snapshotEntities(), {}, {});
  auto held = HeldEntity::take(scene, robot, {}, {}, config::Configuration{});
  ASSERT_TRUE(held) << held.error().message();
  const auto touches = [&](const HeldPair& pair) { return pair.owner == rod && pair.other == wall; };
  EXPECT_TRUE(std::any_of((*held)->pairs().begin(), (*held)->pairs().end(), touches));
  for (const HeldPair& pair : (*held)->pairs()) EXPECT_NE(pair.other, rod) << "it is not checked against its own part";
  MotionMapping mapping;
  mapping.anchor((*held)->movedFrame(), (*held)->movedFrame());
  Pose X_DP = (*held)->movedFrame();
  for (int step = 0; step < 100; ++step) {
    X_DP.p.x += 0.001;
    (*held)->follow(X_DP, mapping, nullptr);
  }
  const double travelled = (*held)->movedFrame().p.x - X_WT.p.x;
  EXPECT_GT(travelled, 0.03);
  EXPECT_LT(travelled, 0.0401) << "the rod's end is 40 mm before the wall";
  const auto carried = (*held)->carried();
  ASSERT_EQ(carried.size(), 1u);
  EXPECT_NEAR(carried[0].second.X_WE.p.x - (X_WT * dvec3(0, 0, 0.16)).x, travelled, 2e-3);
}

TEST(Carried, AMechanismIsDraggedByItsLeaf) {
  workcell::Document document;
  const auto add = [&](const std::string& name, const Pose& X_WE) {
    workcell::Entity entity = load("box:0.5,0.04,0.5");
    entity.name = name;
    entity.X_WE = X_WE;
    return document.execute(workcell::AddEntity{std::move(entity)}).value();
  };
  const auto frame = add("frame", {});
  const auto leaf = add("leaf", Pose::translation({0.6, 0, 0}));
  workcell::MechanismJoint hinge;
  hinge.name = "hinge";
  hinge.parent = "frame";
  hinge.child = "leaf";
  hinge.p_MJ = {0.3, 0, 0};
  hinge.lower = 0.0;
  hinge.upper = 1.5;
  hinge.friction = 0.6;  // N m
  const auto door = document.execute(workcell::MakeMechanism{"door", {frame, leaf}, {hinge}}).value();
  const auto scene = PreparedScene::prepare(document.snapshotEntities(), {}, {});
  auto held = HeldEntity::take(scene, door, {}, {}, config::Configuration{});
  ASSERT_TRUE(held) << held.error().message();
  MotionMapping mapping;
  mapping.anchor((*held)->movedFrame(), (*held)->movedFrame());
  Pose X_DP = (*held)->movedFrame();
  for (int step = 0; step < 200; ++step) {
    const double angle = 0.01 * step;  // The hand leads the leaf's middle on its circle, and beyond the limit.
    X_DP.p = {0.3 + 0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.0};
    X_DP.q = glm::angleAxis(angle, dvec3(0, 0, 1));
    (*held)->follow(X_DP, mapping, nullptr);
    EXPECT_NEAR((*held)->accepted().joints.at(0), std::min(angle, 1.5), 1e-6);
    // The hand draws it 0.3 m from the hinge.
    EXPECT_NEAR((*held)->jointFriction(), 2.0, 0.051);
  }
}

}  // namespace
}  // namespace hapticell::manipulation
