// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/closed_form/inverse_factory.h"
#include "manipulation/manipulators/robot_base_manipulator.h"
#include "manipulation/manipulators/symmetric.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

struct Subject {
  std::shared_ptr<const kinematics::RobotModel> model;
  EntityConfiguration at;
  std::unique_ptr<RobotBaseManipulator> manipulator;
  RobotManipulator::Tool tool;
  std::size_t parts = 0;

  Pose tcp(const EntityConfiguration& configuration) const {
    std::vector<Pose> X_EL;
    kinematics::forwardKinematics(*model, configuration.joints, X_EL);
    return configuration.X_WE * X_EL[static_cast<std::size_t>(tool.tip_link)] * tool.X_LT;
  }
};

Subject subjectOf(kinematics::RobotModel robot, std::vector<double> joints) {
  Subject subject;
  subject.model = std::make_shared<const kinematics::RobotModel>(std::move(robot));
  subject.tool = {subject.model->defaultTip(), Pose::translation({0.01, 0.02, 0.1})};
  subject.at = {{{0.4, -1.0, 0.2}, glm::angleAxis(0.8, glm::normalize(dvec3(0.1, 0.2, 1.0)))}, std::move(joints)};
  std::vector<int> links;
  for (std::size_t k = 0; k < subject.model->links.size(); ++k) links.push_back(static_cast<int>(k));
  subject.parts = links.size();
  auto inverse = kinematics::createInverse(*subject.model, subject.tool.tip_link, subject.tool.X_LT).value();
  subject.manipulator = std::make_unique<RobotBaseManipulator>(subject.model, subject.tool, std::move(inverse),
                                                               RobotManipulator::partsOf(links), subject.at);
  return subject;
}

double offTool(const Subject& subject, const EntityConfiguration& there) {
  const Twist off = difference(subject.tcp(there), subject.tcp(subject.at));
  return std::max(glm::length(off.linear), glm::length(off.angular));
}

TEST(RobotBase, GoesAboutWhileTheToolStaysWhereItIs) {
  for (const auto& make : {kinematics::test::kr120, kinematics::test::ur5e}) {
    const Subject subject = subjectOf(make(), {0.2, -1.1, 1.2, 0.3, 0.7, 0.1});
    EntityConfiguration now = subject.at;
    for (int i = 1; i <= 60; ++i) {
      const double t = i / 60.0;
      const Pose X_WE = displaced(subject.at.X_WE, {t * dvec3(0.06, -0.05, 0.04), t * dvec3(0.1, 0.05, -0.15)});
      const EntityConfiguration next = subject.manipulator->propose(now, X_WE, 0.02);
      EXPECT_LT(glm::length(next.X_WE.p - X_WE.p), 1e-12);
      EXPECT_LT(offTool(subject, next), 2e-6);
      EXPECT_LE(subject.manipulator->leastTime(now, next).seconds, 0.02 + 1e-9);
      // Half-way between two proposals the tool is where it was as far as so small a step tells.
      EXPECT_LT(offTool(subject, subject.manipulator->between(now, next, 0.5)), 1e-4);
      now = next;
    }
  }
}

TEST(RobotBase, StopsWhereTheToolCannotBeKept) {
  const Subject subject = subjectOf(kinematics::test::ur5e(), {0.2, -0.9, 1.0, 0.3, 1.1, 0.1});
  EntityConfiguration now = subject.at;
  const dvec3 away = glm::normalize(subject.at.X_WE.p - subject.tcp(subject.at).p);
  for (int i = 1; i <= 400; ++i) {
    now = subject.manipulator->propose(now, {subject.at.X_WE.p + 0.005 * i * away, subject.at.X_WE.q}, 0.02);
    ASSERT_LT(offTool(subject, now), 2e-6) << i;
  }
  const double gone = glm::length(now.X_WE.p - subject.at.X_WE.p);
  EXPECT_GT(gone, 0.05);
  EXPECT_LT(gone, 1.2) << "the arm is 0.95 m long";
}

TEST(RobotBase, PartsFollowAsTheirDifferentialSays) {
  const Subject subject = subjectOf(kinematics::test::kr120(), {0.2, -1.1, 1.2, 0.3, 0.7, 0.1});
  const auto parts = subject.manipulator->differentiate(subject.at);
  std::vector<Pose> before(subject.parts), after(subject.parts);
  subject.manipulator->partPoses(subject.at, before);
  const double h = 2e-3;
  const std::array<double, 6> directions[] = {{h, 0, 0, 0, 0, 0}, {0, h, -h, 0, 0, 0}, {h, 0, h, h, -h, h}};
  for (const auto& xi : directions) {
    const Twist twist{{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}};
    const EntityConfiguration there =
        subject.manipulator->propose(subject.at, displaced(subject.at.X_WE, twist), kinematics::kUnboundedDuration);
    subject.manipulator->partPoses(there, after);
    for (std::size_t k = 0; k < subject.parts; ++k) {
      dvec3 moved(0.0);
      for (std::size_t i = 0; i < 6; ++i) {
        moved += xi[i] * parts[k].velocity[i].linear;
        for (std::size_t j = 0; j < 6; ++j) {
          const std::size_t at = i <= j ? packedIndex(i, j) : packedIndex(j, i);
          moved += 0.5 * xi[i] * xi[j] * parts[k].acceleration[at].linear;
        }
      }
      EXPECT_LT(glm::length(after[k].p - before[k].p - moved), 1e-6) << subject.model->links[k].name;
    }
  }
}

TEST(RobotBase, JointLimitsAreFeltAsTheBaseMoves) {
  const Subject subject = subjectOf(kinematics::test::kr120(), {0.2, -1.1, 1.2, 0.3, 2.2, 0.1});
  const auto limits = subject.manipulator->limits(subject.at, 0.3, 0.1);
  const auto fifth =
      std::find_if(limits.begin(), limits.end(), [](const MotionLimit& limit) { return limit.joint == 4; });
  ASSERT_NE(fifth, limits.end());
  EXPECT_EQ(english(fifth->text), "a5 is 3.9 deg from its upper limit");
  // Along the gradient the joint goes away from its limit by as much as it says.
  const haptic::Vector6& a = fifth->constraint_W.gradient;
  const double step = 1e-4;
  const Twist xi{step * dvec3(a[0], a[1], a[2]), step * dvec3(a[3], a[4], a[5])};
  const EntityConfiguration there =
      subject.manipulator->propose(subject.at, displaced(subject.at.X_WE, xi), kinematics::kUnboundedDuration);
  EXPECT_LT(there.joints[4], subject.at.joints[4]);
}

TEST(RobotBase, IsAWayToMoveARobotInASession) {
  workcell::Entity robot;
  robot.id = 1;
  robot.name = "robot";
  robot.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(kinematics::test::ur5e()),
                                .joints = {0.2, -0.9, 1.0, 0.3, 1.1, 0.1}}};
  robot.editJointed().tip_link = robot.robot()->links.back().name;
  SessionOptions options = test::sessionOf(
      {robot}, "robot",
      test::handThrough({{0.0, dvec3(0.0)}, {0.3, dvec3(0.0)}, {1.2, {0.03, 0.02, -0.02}}, {1.6, {0.03, 0.02, -0.02}}}),
      200.0, 0.0);
  options.moved_by = parseMovedBy("base_keeping_tcp").value();
  options.axes.mode = AxesMode::kCell;
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  std::vector<Pose> before, after;
  kinematics::forwardKinematics(*robot.robot(), robot.joints(), before);
  kinematics::forwardKinematics(*robot.robot(), report->end.configuration.joints, after);
  EXPECT_GT(glm::length(report->end.configuration.X_WE.p), 0.02);
  EXPECT_LT(glm::length(report->end.configuration.X_WE * after.back().p - before.back().p), 1e-5);
}

}  // namespace
}  // namespace hapticell::manipulation
