// SPDX-License-Identifier: Apache-2.0
// Robots that stand on a rail or a rotary table, dragged by their tool with these as external axes.
#include <gtest/gtest.h>

#include <algorithm>

#include "manipulation/checks/path_check.h"
#include "manipulation/manipulators/robot_manipulator.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/document/document.h"

namespace hapticell::manipulation {
namespace {

/// A UR5e on a plate that a rail of 2 x 1 m carries along x, a box in its flange; or on a table that turns.
struct Cell {
  workcell::Document document;
  workcell::EntityId axis = 0, robot = 0, part = 0;
};

workcell::EntityId add(workcell::Document& document, workcell::Entity entity) {
  return document.execute(workcell::AddEntity{std::move(entity)}).value();
}

Cell cellWith(workcell::MechanismJointType type) {
  Cell cell;
  const auto bed = add(cell.document,
                       test::solid(0, "bed", geometry::makeBox({3.0, 0.3, 0.1}), Pose::translation({0.0, 0.0, -0.5})));
  const auto plate = add(cell.document, test::solid(0, "plate", geometry::makeBox({0.3, 0.3, 0.05}),
                                                    Pose::translation({0.0, 0.0, -0.35})));
  workcell::MechanismJoint joint;
  joint.name = "drive";
  joint.type = type;
  joint.parent = "bed";
  joint.child = "plate";
  joint.axis_M = type == workcell::MechanismJointType::kPrismatic ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
  joint.lower = -1.0;
  joint.upper = 1.0;
  joint.velocity = 2.0;
  cell.axis = cell.document.execute(workcell::MakeMechanism{"axis", {bed, plate}, {joint}}).value();
  workcell::Entity robot;
  robot.name = "robot";
  robot.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(kinematics::test::ur5e()),
                                .joints = {0.2, -0.9, 1.0, 0.3, 1.1, 0.1},
                                .tip_link = "flange"}};
  robot.X_WE = Pose::translation({0.0, 0.0, -0.32});
  cell.robot = add(cell.document, std::move(robot));
  EXPECT_TRUE(cell.document.execute(workcell::Attach{cell.robot, cell.axis, "plate"}));
  std::vector<Pose> X_BL;
  const workcell::Entity& placed = *cell.document.find(cell.robot);
  kinematics::forwardKinematics(*placed.robot(), placed.joints(), X_BL);
  cell.part = add(cell.document, test::solid(0, "part", geometry::makeBox(dvec3(0.04)), placed.X_WE * X_BL.back()));
  EXPECT_TRUE(cell.document.execute(workcell::Attach{cell.part, cell.robot, "flange"}));
  return cell;
}

Expected<std::unique_ptr<HeldEntity>> taken(const Cell& cell, const std::string& moved_by) {
  HoldOptions options;
  options.moved_by = parseMovedBy(moved_by).value();
  return HeldEntity::take(PreparedScene::prepare(cell.document.snapshotEntities(), {}, {}), cell.robot, {}, options,
                          config::Configuration{});
}

/// Follows the hand straight by `way` (m) in the cell; gives how far the tool stays behind at the end.
double drag(HeldEntity& held, const dvec3& way) {
  MotionMapping mapping;
  mapping.anchor(held.movedFrame(), held.movedFrame());
  const Pose X_DFrom = held.movedFrame();
  constexpr int kSteps = 400;
  for (int step = 1; step <= kSteps; ++step) {
    const Pose wanted{X_DFrom.p + way * (static_cast<double>(step) / kSteps), X_DFrom.q};
    held.follow(wanted, mapping, nullptr);
  }
  return glm::length(held.movedFrame().p - (X_DFrom.p + way));
}

TEST(ExternalAxes, GoAlongWhereTheArmAloneIsTooShort) {
  const Cell cell = cellWith(workcell::MechanismJointType::kPrismatic);
  auto alone = taken(cell, "tcp");
  auto with_rail = taken(cell, "tcp_with_axes");
  ASSERT_TRUE(alone && with_rail) << (with_rail ? "" : with_rail.error().message());
  const dvec3 way{-1.1, 0.0, 0.0};
  EXPECT_GT(drag(**alone, way), 0.05);
  EXPECT_LT(drag(**with_rail, way), 1e-5);
  const auto axes = (*with_rail)->axes();
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_EQ(axes[0].first, cell.axis);
  EXPECT_LT(axes[0].second.joints.at(0), -0.2);
  EXPECT_EQ((*with_rail)->standing().joints.size(), 6u);
  EXPECT_NEAR((*with_rail)->standing().X_WE.p.x, axes[0].second.joints.at(0), 1e-12) << "the robot goes with its rail";
}

TEST(ExternalAxes, EverythingGoesAlongAndIsWrittenBackAsItStands) {
  Cell cell = cellWith(workcell::MechanismJointType::kRevolute);
  auto held = taken(cell, "tcp_with_axes");
  ASSERT_TRUE(held) << held.error().message();
  EXPECT_LT(drag(**held, {-0.1, 0.3, 0.05}), 1e-5);
  const Pose X_WM = (*held)->movedFrame();
  EXPECT_GT(std::abs((*held)->axes()[0].second.joints.at(0)), 0.01);
  for (const auto& [id, at] : (*held)->axes()) {
    ASSERT_TRUE(cell.document.execute(workcell::SetConfiguration{id, at.X_WE, at.joints}));
  }
  const EntityConfiguration own = (*held)->standing();
  ASSERT_TRUE(cell.document.execute(workcell::SetConfiguration{cell.robot, own.X_WE, own.joints}));
  const auto carried = (*held)->carried();
  const auto part = std::find_if(carried.begin(), carried.end(), [&](const auto& c) { return c.first == cell.part; });
  ASSERT_NE(part, carried.end());
  EXPECT_LT(glm::length(cell.document.find(cell.part)->X_WE.p - part->second.X_WE.p), 1e-9);
  EXPECT_LT(glm::length(part->second.X_WE.p - X_WM.p), 1e-9) << "the part hangs in the flange";
}

TEST(ExternalAxes, AJointsEndIsFeltWhicheverItBelongsTo) {
  const Cell cell = cellWith(workcell::MechanismJointType::kPrismatic);
  auto held = taken(cell, "tcp_with_axes");
  ASSERT_TRUE(held);
  EXPECT_GT(drag(**held, {3.0, 0.0, 0.0}), 0.3);
  EXPECT_NEAR((*held)->axes()[0].second.joints.at(0), 1.0, 1e-6);
  const auto limits = (*held)->manipulator().limits((*held)->accepted(), 0.05, 0.1);
  const auto rail = std::find_if(limits.begin(), limits.end(),
                                 [](const MotionLimit& limit) { return english(limit.text).find("drive is ") == 0; });
  ASSERT_NE(rail, limits.end());
  EXPECT_EQ((*held)->jointName(rail->joint), "drive");
  EXPECT_EQ((*held)->ownJoint(rail->joint), -1);
}

/// What the rail's plate or the robot's own links meet stops all of it.
TEST(ExternalAxes, AnObstacleBesideTheRailStopsThem) {
  Cell cell = cellWith(workcell::MechanismJointType::kPrismatic);
  add(cell.document,
      test::solid(0, "post", geometry::makeBox({0.1, 1.0, 0.05}), Pose::translation({-0.4, 0.0, -0.35})));
  auto held = taken(cell, "tcp_with_axes");
  ASSERT_TRUE(held);
  drag(**held, {-1.3, 0.0, 0.0});
  // The plate's edge is 0.2 m from the post's.
  EXPECT_GT((*held)->axes()[0].second.joints.at(0), -0.2 + 0.9e-3);
  EXPECT_LT((*held)->axes()[0].second.joints.at(0), -0.15);
}

TEST(ExternalAxes, AreToldOfByASessionAndSaidWhereThereAreNone) {
  Cell cell = cellWith(workcell::MechanismJointType::kPrismatic);
  SessionOptions options = test::sessionOf(
      cell.document.snapshotEntities(), "robot",
      test::handThrough({{0.0, dvec3(0.0)}, {0.3, dvec3(0.0)}, {1.5, {-0.06, 0, 0}}, {2.0, {-0.06, 0, 0}}}), 200.0,
      0.0);
  options.moved_by = parseMovedBy("tcp_with_axes").value();
  options.axes.mode = AxesMode::kCell;
  options.scale = parseScale("5").value();
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  ASSERT_EQ(report->end.axes.size(), 1u);
  EXPECT_EQ(report->end.axes[0].first, "axis");
  EXPECT_LT(report->end.axes[0].second.joints.at(0), -0.01);
  EXPECT_EQ(report->end.configuration.joints.size(), 6u);
  EXPECT_NEAR(report->end.configuration.X_WE.p.x, report->end.axes[0].second.joints.at(0), 1e-12);
  ASSERT_TRUE(cell.document.execute(workcell::Detach{cell.robot}));
  options.entities = cell.document.snapshotEntities();
  const auto refused = runSession(options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("it is not attached to anything that moves"), std::string::npos);
}

/// The rail drives 0.8 m along x, the arm still: a wall stands in the way of the arm, which only the rail brings there.
TEST(ExternalAxes, ACheckOfAMotionTakesTheAxesMotionsAlong) {
  Cell cell = cellWith(workcell::MechanismJointType::kPrismatic);
  const workcell::Entity robot = *cell.document.find(cell.robot);
  const auto held = taken(cell, "tcp_with_axes");
  ASSERT_TRUE(held) << held.error().message();
  const Pose X_WT = (*held)->movedFrame();
  add(cell.document,
      test::solid(0, "wall", geometry::makeBox({0.02, 3.0, 3.0}), Pose::translation({X_WT.p.x + 0.6, 0.0, 1.1})));
  const auto scene = PreparedScene::prepare(cell.document.snapshotEntities(), {}, {});

  trajectory::Trajectory arm, rail;
  for (const int joint : robot.robot()->moving)
    arm.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  rail.joint_names = {"drive"};
  rail.entity = "axis";
  for (const double x : {0.0, 0.8}) {
    arm.addFrame({x, Pose{X_WT.p + dvec3(x, 0.0, 0.0), X_WT.q}}, robot.joints());
    rail.addFrame({x, Pose::identity()}, std::span(&x, 1));
  }
  const auto still = checkPath(scene, "robot", arm, {}, {});
  ASSERT_TRUE(still) << still.error().message();
  for (const PathFinding& finding : still->findings) EXPECT_EQ(finding.kind, PathFinding::Kind::kOffPose);
  PathCheckOptions options;
  options.axes = {std::make_shared<const trajectory::Trajectory>(rail)};
  const auto driven = checkPath(scene, "robot", arm, options, {});
  ASSERT_TRUE(driven) << driven.error().message();
  const auto part = std::find_if(driven->findings.begin(), driven->findings.end(), [](const PathFinding& finding) {
    return finding.kind == PathFinding::Kind::kCollision && finding.first == "part";
  });
  ASSERT_NE(part, driven->findings.end()) << "the part in the flange meets the wall";
  EXPECT_EQ(part->second, "wall");
  for (const PathFinding& finding : driven->findings) EXPECT_EQ(finding.kind, PathFinding::Kind::kCollision);
  // The rail's own motion, which carries the robot and its part, ends at the same wall.
  const auto of_rail = checkPath(scene, "axis", rail, {}, {});
  ASSERT_TRUE(of_rail) << of_rail.error().message();
  EXPECT_TRUE(std::any_of(of_rail->findings.begin(), of_rail->findings.end(), [&](const PathFinding& finding) {
    return finding.first == "part" && finding.second == "wall" && std::abs(finding.t_in - part->t_in) < 1e-3;
  }));
}

}  // namespace
}  // namespace hapticell::manipulation
