// SPDX-License-Identifier: Apache-2.0
// Whole sessions with robots: joint speeds, singularities, limits that are told, links that meet each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "manipulation/manipulators/robot_manipulator.h"
#include "manipulation/manipulators/singularity_wall.h"
#include "manipulation/scene/own_pairs.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity robotOf(kinematics::RobotModel model, std::vector<double> joints) {
  workcell::Entity robot;
  robot.id = 1;
  robot.name = "robot";
  const std::string tip_link = model.links.back().name;
  robot.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(model)),
                                .joints = std::move(joints),
                                .tip_link = tip_link}};
  return robot;
}

/// Turns the tool so that joint 5 of a KR 120 passes zero a little beside it, and back.
SessionOptions throughTheWrist(double rate_hz) {
  workcell::Entity robot = robotOf(kinematics::test::kr120(), {0.0, -1.3, 1.4, 0.0, 0.1, 0.0});
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
  const dvec3 axis5 = X_BL[5].rotate(dvec3(0, 1, 0)), aside = dvec3(0, 0, 1);
  const dvec3 there = -0.2 * axis5 + 0.004 * aside;
  SessionOptions options = test::sessionOf({robot}, "robot",
                                           test::handThrough({{0.0, dvec3(0.0)},
                                                              {0.3, dvec3(0.0)},
                                                              {1.3, dvec3(0.0), there},
                                                              {2.3, dvec3(0.0), there},
                                                              {3.3, dvec3(0.0)},
                                                              {6.0, dvec3(0.0)}}),
                                           rate_hz, 0.0);
  options.axes.mode = AxesMode::kCell;
  return options;
}

double lowest(const SessionReport& report, std::size_t joint) {
  return report.joints.at(joint).lowest;
}

TEST(RobotSession, NoJointIsEverFasterThanItCanBeThroughTheWristSingularity) {
  for (const double rate : {60.0, 1000.0}) {
    for (const char* choice : {"keep_position", "keep_joint_4", "keep_orientation"}) {
      SessionOptions options = throughTheWrist(rate);
      options.configuration.robot.at_singularity = choice;
      std::optional<TraceRow> first;
      double off = 0.0;
      const auto report = runSession(options, [&](const TraceRow& row) {
        if (row.X_WM.p == dvec3(0.0)) return;  // Nothing is held yet.
        if (!first) first = row;
        // The hand only turns; what the proxy was pushed aside is no error of the robot.
        const dvec3 wanted = first->X_WM.p + (row.X_DP.p - first->X_DP.p);
        off = std::max(off, glm::length(row.X_WM.p - wanted));
      });
      ASSERT_TRUE(report) << report.error().message();
      ASSERT_EQ(report->joints.size(), 6u);
      for (const JointUse& use : report->joints) {
        EXPECT_LE(use.max_speed, use.greatest_speed * (1.0 + 1e-6)) << choice << " " << rate << " joint " << use.joint;
      }
      EXPECT_LT(lowest(*report, 4), 0.02) << "it went to the singularity";
      if (choice != std::string("keep_orientation")) {
        EXPECT_LT(off, 2e-4) << choice << " " << rate;
      }
      if (choice == std::string("keep_position")) {
        EXPECT_TRUE(std::any_of(report->limits.begin(), report->limits.end(), [](const LimitInterval& event) {
          return event.kind == LimitKind::kSpeed;
        })) << "it is told why the tool lags";
      }
    }
  }
}

TEST(RobotSession, SingularitiesAreWallsWhereTheUserWantsThat) {
  for (const double rate : {10.0, 500.0}) {
    SessionOptions options = throughTheWrist(rate);
    options.configuration.robot.at_singularity = "stop";
    const auto report = runSession(options);
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_GT(lowest(*report, 4), 0.005) << "joint 5 never passes zero";
    const auto told = std::find_if(report->limits.begin(), report->limits.end(),
                                   [](const LimitInterval& event) { return event.kind == LimitKind::kSingularity; });
    ASSERT_NE(told, report->limits.end());
    EXPECT_EQ(told->text, "The arm is near a singularity");
    EXPECT_NEAR(report->end.configuration.joints[4], 0.1, 0.01) << "and it comes back, " << rate;
  }
}

TEST(RobotSession, TellsWhichJointsLimitHoldsIt) {
  const workcell::Entity robot = robotOf(kinematics::test::kr120(), {0.0, -1.3, 1.4, 0.0, 2.15, 0.0});
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
  const dvec3 axis5 = X_BL[5].rotate(dvec3(0, 1, 0));
  SessionOptions options = test::sessionOf(
      {robot}, "robot",
      test::handThrough(
          {{0.0, dvec3(0.0)}, {0.3, dvec3(0.0)}, {1.3, dvec3(0.0), 0.3 * axis5}, {2.0, dvec3(0.0), 0.3 * axis5}}),
      200.0, 0.0);
  options.axes.mode = AxesMode::kCell;
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_LE(report->joints.at(4).highest, robot.robot()->joints[4].upper);
  const auto told = std::find_if(report->limits.begin(), report->limits.end(), [](const LimitInterval& event) {
    return event.kind == LimitKind::kJoint && event.joint == 4;
  });
  ASSERT_NE(told, report->limits.end());
  EXPECT_NE(told->text.find("a5 is "), std::string::npos) << told->text;
  EXPECT_NE(told->text.find("upper limit"), std::string::npos) << told->text;
  ASSERT_FALSE(report->end.limits.empty());
}

/// A column beside an arm, and a forearm below that arm which can turn into the column.
kinematics::RobotModel foldingArm() {
  using kinematics::JointType;
  kinematics::RobotModel model = kinematics::test::emptyModel();
  const auto box = [](const dvec3& size, const dvec3& at) {
    return std::vector<kinematics::LinkShape>{
        {std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(size)), Pose::translation(at), {}, "box"}};
  };
  kinematics::test::addJoint(model, 0, "j1", JointType::kRevolute, {0, 0, 1}, Pose::translation({0, 0, 0.25}));
  kinematics::test::addJoint(model, 1, "j2", JointType::kRevolute, {0, 0, 1}, Pose::translation({0.5, 0, -0.15}));
  model.joints[0].lower = model.joints[1].lower = -3.1;
  model.joints[0].upper = model.joints[1].upper = 3.1;
  kinematics::test::addJoint(model, 2, "end", JointType::kFixed, {0, 0, 1}, Pose::translation({0.48, 0, 0}));
  model.links[0].collisions = box({0.1, 0.1, 0.2}, {0.2, 0.35, 0.1});
  model.links[1].collisions = box({0.55, 0.06, 0.06}, {0.25, 0, 0});
  model.links[2].collisions = box({0.48, 0.05, 0.05}, {0.24, 0, 0});
  model.links.back().name = "tool0";
  return model;
}

TEST(RobotSession, ForearmRestsOnItsOwnColumn) {
  for (const bool checked : {true, false}) {
    const workcell::Entity robot = robotOf(foldingArm(), {0.0, 1.7});
    // The forearm is to turn to where the column stands.
    std::vector<Pose> X_BL, X_BEnd;
    kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
    kinematics::forwardKinematics(*robot.robot(), {0.0, 2.5}, X_BEnd);
    const dvec3 way = 0.25 * (X_BEnd[3].p - X_BL[3].p), turn(0, 0, 0.8);
    SessionOptions options = test::sessionOf(
        {robot}, "robot", test::handThrough({{0.0, dvec3(0.0)}, {0.3, dvec3(0.0)}, {2.0, way, turn}, {3.0, way, turn}}),
        250.0, 0.0);
    options.axes.mode = AxesMode::kCell;
    options.scale = {ScaleLevel::kNumber, 4.0};
    options.configuration.robot.self_collision = checked;
    const auto report = runSession(options);
    ASSERT_TRUE(report) << report.error().message();
    const bool met = std::any_of(report->contacts.begin(), report->contacts.end(), [](const ContactInterval& event) {
      return event.entity == event.other && event.moved_part == "base_link" && event.other_part == "j2_link";
    });
    EXPECT_EQ(met, checked);
    EXPECT_EQ(report->forces.penetration_max_m, 0.0);
    // Seen from joint 2 the column's middle lies at 2.28 rad, 0.46 m away; it and half the forearm take 0.2 rad.
    const double furthest = report->joints.at(1).highest;
    EXPECT_TRUE(checked ? furthest < 2.2 && furthest > 1.9 : furthest > 2.4) << furthest;
  }
}

TEST(OwnPairs, LeaveOutNeighboursAndWhatIsDisabled) {
  kinematics::RobotModel model = foldingArm();
  kinematics::test::addJoint(model, 2, "j3", kinematics::JointType::kRevolute, {0, 0, 1}, {});
  // base_link 0, j1_link 1, j2_link 2, tool0 3 (fixed to 2), j3_link 4 (turns on 2).
  const std::vector<OwnPart> parts{{0, false}, {1, false}, {2, false}, {3, false}, {4, false}, {3, true}};
  const auto has = [&](std::size_t a, std::size_t b) {
    for (const OwnPair& pair : ownPairs(model, parts)) {
      if (pair.first == a && pair.second == b) return true;
    }
    return false;
  };
  EXPECT_TRUE(has(0, 2) && has(0, 3) && has(0, 4) && has(1, 4));
  EXPECT_FALSE(has(0, 1)) << "one joint joins them";
  EXPECT_FALSE(has(1, 3)) << "tool0 is rigid with j2_link, which j2 joins to j1_link";
  EXPECT_FALSE(has(2, 3)) << "one rigid body";
  EXPECT_FALSE(has(3, 4)) << "j3 joins j2_link's body and j3_link";
  EXPECT_TRUE(has(1, 5) && has(4, 5)) << "a gripped part meets the neighbours too";
  EXPECT_FALSE(has(2, 5)) << "but not what it hangs on";
  model.disabled_pairs = {{4, 0, "Never"}};
  EXPECT_FALSE(has(0, 4));
}

TEST(SingularityWall, MeasuresTheAngleOfAWristAndStopsThere) {
  const kinematics::RobotModel model = kinematics::test::kr120();
  const SingularityWall wall(model, 7, {}, 1.5);
  const std::vector<double> from{0.0, -1.3, 1.4, 0.0, 0.3, 0.0};
  std::vector<double> to = from;
  to[4] = -0.3;
  const double share = wall.freeShare(from, to);
  std::vector<double> there = from;
  there[4] += share * (to[4] - from[4]);
  EXPECT_NEAR(wall.measure(there), SingularityWall::kWall, 1e-5);
  EXPECT_GT(there[4], 0.0);
  EXPECT_EQ(wall.freeShare(there, from), 1.0) << "the way back is free";
  // The gradient against a step along it.
  const std::vector<double> slope = wall.gradient(from);
  std::vector<double> moved = from;
  double expected = 0.0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] += 1e-4 * static_cast<double>(i + 1);
    expected += 1e-4 * static_cast<double>(i + 1) * slope[i];
  }
  EXPECT_NEAR(wall.measure(moved) - wall.measure(from), expected, 2e-6);
  // Behind the wall already: it may only get no worse.
  std::vector<double> behind = from;
  behind[4] = 0.005;
  std::vector<double> worse = behind;
  worse[4] = 0.001;
  EXPECT_LT(wall.freeShare(behind, worse), 1e-3);
  EXPECT_EQ(wall.freeShare(behind, from), 1.0);
}

}  // namespace
}  // namespace hapticell::manipulation
