// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/mouse_stylus.h"

#include <gtest/gtest.h>

#include "app/virtual_desktop/devices/two_pens.h"
#include "manipulation/holding/motion_mapping.h"

namespace hapticell::app {
namespace {

/// A stylus in the middle of the view, held through the cell's axes at a scale of 1 to 4.
class MouseStylusTest : public testing::Test {
 protected:
  void SetUp() override {
    camera.target_W = dvec3(0.5, 0.2, 0.8);
    camera.distance = 0.4;  // So near that a drag of some pixels stays within the workspace.
    state.usable = true;
    state.scale = 0.25;
    state.p_WTip = camera.target_W;
    mouse.setState(state);
    mouse.hold(true);
  }
  PointerEvent at(double x, double y, Qt::MouseButton button, Qt::MouseButtons held,
                  Qt::KeyboardModifiers keys = {}) const {
    PointerEvent event;
    event.pixel = {x, y};
    event.button = button;
    event.buttons = held;
    event.modifiers = keys;
    event.camera = camera;
    event.size = {1000, 600};
    return event;
  }
  Camera camera;
  MouseStylus::State state;
  haptic::HandTarget sent;
  MouseStylus mouse{[this](const haptic::HandTarget& target) { sent = target; }};
};

TEST_F(MouseStylusTest, OnlyAPressOnThePenTakesIt) {
  EXPECT_FALSE(mouse.press(at(100, 100, Qt::LeftButton, Qt::LeftButton)));
  EXPECT_TRUE(mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton)));
  EXPECT_TRUE(sent.holding);
}

/// Both within reach of the pointer, as when they cross: the nearer one is taken, whichever it is.
TEST_F(MouseStylusTest, OfTwoPensTheNearerIsTaken) {
  MouseStylus other([](const haptic::HandTarget&) {});
  MouseStylus::State beside = state;
  beside.p_WTip += 10.0 * camera.metresPerPixel(state.p_WTip, {1000, 600}) * camera.right_W();
  other.setState(beside);
  other.hold(true);
  for (const bool first : {true, false}) {
    TwoPens pens(mouse, other);
    const double x = first ? 502.0 : 508.0;
    const dvec3 mouse_at = mouse.target().X_DH.p, other_at = other.target().X_DH.p;
    ASSERT_TRUE(pens.press(at(x, 300, Qt::LeftButton, Qt::LeftButton)));
    pens.move(at(x + 5, 300, Qt::NoButton, Qt::LeftButton));
    EXPECT_EQ(mouse.target().X_DH.p != mouse_at, first);
    EXPECT_EQ(other.target().X_DH.p != other_at, !first);
    pens.release(at(x + 5, 300, Qt::LeftButton, {}));
  }
  mouse.setFollow(true);
  TwoPens pens(mouse, other);
  EXPECT_TRUE(pens.press(at(508, 300, Qt::LeftButton, Qt::LeftButton)));
  EXPECT_EQ(mouse.target().buttons, 1u) << "while it follows the mouse, the button is the first one's";
}

TEST_F(MouseStylusTest, TheTipFollowsTheCursorInThePlaneOfTheScreen) {
  mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton));
  EXPECT_TRUE(mouse.move(at(510, 280, Qt::NoButton, Qt::LeftButton)));
  // Where the tip is then, mapped as the manipulation loop does.
  const dvec3 p_WTip = state.p_WTip + state.scale * (state.q_WD * sent.X_DH.p);
  const glm::dvec2 seen = *camera.project(p_WTip, {1000, 600});
  EXPECT_NEAR(seen.x, 510.0, 0.05);
  EXPECT_NEAR(seen.y, 280.0, 0.05);
}

TEST_F(MouseStylusTest, TheSameWithTheAxesOfTheScreen) {
  const Pose X_WCamera{camera.eye_W(), glm::quat_cast(dmat3(camera.right_W(), camera.up_W(), -camera.forward_W()))};
  state.q_WD = manipulation::deviceAxes(manipulation::AxesMode::kScreen, X_WCamera, Pose::identity());
  mouse.setState(state);
  mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton));
  mouse.move(at(507, 300, Qt::NoButton, Qt::LeftButton));
  EXPECT_GT(sent.X_DH.p.x, 0.0) << "right on the screen is right in the hand";
  EXPECT_NEAR(sent.X_DH.p.y, 0.0, 1e-12);
  EXPECT_NEAR(sent.X_DH.p.z, 0.0, 1e-12);
}

TEST_F(MouseStylusTest, WheelIsDepthOnlyWhileDragging) {
  EXPECT_FALSE(mouse.wheel(at(500, 300, Qt::NoButton, {})));
  mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton));
  PointerEvent event = at(500, 300, Qt::NoButton, Qt::LeftButton);
  event.wheel_steps = 1.0;
  EXPECT_TRUE(mouse.wheel(event));
  EXPECT_GT(glm::dot(state.q_WD * sent.X_DH.p, camera.forward_W()), 0.0);
}

TEST_F(MouseStylusTest, ControlTurnsAndRightButtonIsTheStylussButton) {
  mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton));
  mouse.move(at(540, 300, Qt::NoButton, Qt::LeftButton, Qt::ControlModifier));
  EXPECT_NEAR(glm::length(rotationVector(sent.X_DH.q)), 0.24, 1e-6);
  EXPECT_EQ(sent.X_DH.p, dvec3(0.0));
  mouse.press(at(540, 300, Qt::RightButton, Qt::LeftButton | Qt::RightButton));
  EXPECT_EQ(sent.buttons, 1u);
  mouse.release(at(540, 300, Qt::RightButton, Qt::LeftButton));
  EXPECT_EQ(sent.buttons, 0u);
  EXPECT_TRUE(mouse.move(at(550, 300, Qt::NoButton, Qt::LeftButton))) << "the drag goes on";
}

TEST_F(MouseStylusTest, TheHandStaysNearTheWorkspaceAndWhereItWasLeft) {
  mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton));
  mouse.move(at(100000, 300, Qt::NoButton, Qt::LeftButton));
  EXPECT_LE(sent.X_DH.p.x, 1.06 * state.workspace_max.x);
  const dvec3 left = sent.X_DH.p;
  mouse.release(at(100000, 300, Qt::LeftButton, {}));
  EXPECT_TRUE(sent.holding);
  EXPECT_FALSE(mouse.move(at(500, 300, Qt::NoButton, {})));
  EXPECT_EQ(mouse.target().X_DH.p, left);
}

TEST_F(MouseStylusTest, FollowingNeedsNoButtonAndNothingWorksWithoutADevice) {
  mouse.setFollow(true);
  mouse.move(at(500, 300, Qt::NoButton, {}));
  EXPECT_TRUE(mouse.move(at(505, 300, Qt::NoButton, {})));
  EXPECT_NE(sent.X_DH.p, dvec3(0.0));
  EXPECT_FALSE(mouse.hint().isEmpty());
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::RightButton}) {
    EXPECT_TRUE(mouse.press(at(505, 300, button, button))) << "it leads the pen: both are the stylus's button";
    EXPECT_EQ(sent.buttons, 1u);
    mouse.release(at(505, 300, button, {}));
    EXPECT_EQ(sent.buttons, 0u);
  }
  mouse.setState({});
  EXPECT_FALSE(mouse.press(at(500, 300, Qt::LeftButton, Qt::LeftButton)));
  EXPECT_FALSE(mouse.press(at(500, 300, Qt::RightButton, Qt::RightButton)));
  EXPECT_TRUE(mouse.hint().isEmpty());
}

}  // namespace
}  // namespace hapticell::app
