// SPDX-License-Identifier: Apache-2.0
// The view that goes along: with a robot's tool, through a mannequin's eyes; and the whole screen for the window.
#include <gtest/gtest.h>

#include <QAction>

#include "app/controls/pose_text.h"
#include "app/host/message_log.h"
#include "mannequin/shape/figure_model.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/vision.h"
#include "tests/app/pages/mannequin_page.h"

namespace hapticell::app {
namespace {

class FollowPage : public MannequinPage {
 public:
  const Camera& camera() { return window().viewport().camera(); }
  void turnFirstJoint(workcell::EntityId id, double angle) {
    std::vector<double> joints = document().document().find(id)->joints();
    joints[0] += angle;
    EXPECT_TRUE(document().execute(workcell::SetJoints{id, joints}));
  }
  dvec3 tool(workcell::EntityId id) {
    const workcell::Entity& robot = *document().document().find(id);
    return tcpPose_W(robot, robot.X_WE, robot.joints()).p;
  }
};

TEST(FollowCamera, GoesWithTheToolUntilItIsTold) {
  FollowPage page;
  const auto robot = page.addRobot("hc6");
  page.window().viewport().fitAll(false);
  const Camera before = page.camera();
  const dvec3 tool_before = page.tool(robot);
  page.trigger("actionFollowTool");
  page.turnFirstJoint(robot, 0.4);
  const dvec3 way = page.tool(robot) - tool_before;
  ASSERT_GT(glm::length(way), 0.1);
  EXPECT_TRUE(
      WindowPage::until([&] { return glm::length(page.camera().target_W - before.target_W - way) < 1e-9; }, 20000));
  EXPECT_EQ(page.camera().azimuth, before.azimuth) << "the view keeps its direction";
  page.trigger("actionFollowNothing");
  const Camera ended = page.camera();
  page.turnFirstJoint(robot, -0.4);
  WindowPage::settle();
  EXPECT_EQ(page.camera().target_W, ended.target_W);
}

TEST(FollowCamera, SaysWhatIsMissingAndKeepsWhatItFollows) {
  FollowPage page;
  page.trigger("actionFollowTool");
  ASSERT_FALSE(page.window().messages().messages().empty());
  EXPECT_EQ(page.window().messages().messages().back().title, "There is nothing to follow");
  EXPECT_TRUE(page.find<QAction>("actionFollowNothing")->isChecked());
  page.addRobot("hc6");
  page.trigger("actionFollowTool");
  page.trigger("actionFollowEyes");
  EXPECT_TRUE(page.window().messages().messages().back().text.contains("mannequin"));
  EXPECT_TRUE(page.find<QAction>("actionFollowTool")->isChecked()) << "the robot is followed as before";
}

TEST(FollowCamera, LooksThroughTheEyesAndComesBack) {
  FollowPage page;
  ASSERT_TRUE(page.addMannequin());
  const Camera before = page.camera();
  const workcell::Entity& person = *page.selected();
  const auto posture = mannequin::toPosture(*person.figure(), {person.X_WE, person.joints()});
  const Pose X_WEyes =
      mannequin::eyePose(*person.figure(), mannequin::forwardKinematics(*person.figure(), posture), posture.gaze);
  page.trigger("actionFollowEyes");
  EXPECT_TRUE(WindowPage::until([&] { return glm::length(page.camera().eye_W() - X_WEyes.p) < 1e-6; }, 20000));
  page.trigger("actionFollowNothing");
  EXPECT_LT(glm::length(page.camera().eye_W() - before.eye_W()), 1e-9);
}

TEST(FullScreen, IsSwitchedOnAndOff) {
  FollowPage page;
  page.trigger("actionFullScreen");
  EXPECT_TRUE(page.window().isFullScreen());
  page.trigger("actionFullScreen");
  EXPECT_FALSE(page.window().isFullScreen());
}

}  // namespace
}  // namespace hapticell::app
