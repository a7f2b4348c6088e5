// SPDX-License-Identifier: Apache-2.0
// What the window says of a copy that is further off than was asked, and of one that is not.
#include <gtest/gtest.h>

#include <random>

#include "app/style/theme.h"
#include "config/configuration.h"
#include "manipulation/checks/motion_replay.h"
#include "tests/app/pages/motion_page.h"

namespace hapticell::app {
namespace {

using trajectory::Trajectory;

/// The widest distance of frames of one time.
double widest(const Trajectory& one, const Trajectory& other) {
  double most = 0.0;
  for (const auto& frame : one.frames()) most = std::max(most, glm::distance(frame.X_WT.p, other.poseAt(frame.t).p));
  return most;
}

bool isRed(MotionPage& page) {
  const QLabel& label = *page.find<QLabel>("labelMotionResult");
  return label.palette().color(QPalette::WindowText) == themeOf(page.window().palette()).contact;
}

/// A take whose noise is five times the tolerance of Clean, 1 mm: its copy is within it all the same.
TEST(KeptMotion, ANoisyTakeIsSmoothedWithinTheTolerance) {
  MotionPage page;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.005);
  std::vector<std::pair<double, dvec3>> points;
  for (int i = 0; i <= 200; ++i) points.push_back({0.02 * i, {0.002 * i, noise(random), noise(random)}});
  ASSERT_TRUE(page.import(points, "noisy"));
  const Trajectory given = page.newest();
  ASSERT_TRUE(page.pressForMotion("buttonSmoothMotion"));
  EXPECT_LE(widest(given, page.newest()), 0.001 + 1e-9);
  EXPECT_EQ(page.newest().name.find("target missed"), std::string::npos) << page.newest().name;
  EXPECT_FALSE(isRed(page));
}

/// Poses that the arm does not reach are kept by the file alone: the tool is elsewhere, so the copy is marked.
TEST(KeptMotion, ACopyThatTheRobotDoesNotFollowIsMarkedAndRed) {
  MotionPage page;
  const auto file = config::findShippedFile("robots/hc6/robot.urdf");
  ASSERT_TRUE(file.has_value());
  ASSERT_TRUE(page.add(QString::fromStdString(*file)));
  const workcell::Entity& robot = *page.state().entities.back();
  ASSERT_TRUE(robot.robot());
  Trajectory given;
  given.entity = robot.name;
  given.moved = "tcp";
  for (const int joint : robot.robot()->moving)
    given.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  const std::vector<double> joints{0.1, 0.3, 0.4, 0.1, 0.9, 0.2};
  Trajectory start = given.emptyCopy();
  ASSERT_TRUE(start.addFrame({0.0, {}}, joints));
  const auto posed = manipulation::posesFromJoints(robot, start);
  ASSERT_TRUE(posed.has_value()) << posed.error().message();
  for (int i = 0; i <= 60; ++i) {
    Pose X = (*posed)[0].X_WT;
    X.p.x += 0.05 * i;  // Three metres away, further than it reaches.
    ASSERT_TRUE(given.addFrame({0.05 * i, X, false, 0.0, nullptr, i > 0}, joints));
  }
  ASSERT_TRUE(page.importMotion(given, "far"));
  ASSERT_TRUE(page.pressForMotion("buttonSmoothMotion"));
  const Trajectory& made = page.newest();
  const auto reached = manipulation::posesFromJoints(robot, made);
  ASSERT_TRUE(reached.has_value());
  ASSERT_GT(widest(given, *reached), 0.1) << "else it shows nothing";
  EXPECT_NE(made.name.find("target missed"), std::string::npos) << made.name;
  EXPECT_TRUE(page.words("labelMotionResult").startsWith("Missed")) << page.words("labelMotionResult").toStdString();
  EXPECT_TRUE(isRed(page));
}

}  // namespace
}  // namespace hapticell::app
