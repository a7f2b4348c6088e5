// SPDX-License-Identifier: Apache-2.0
// What the device check and the input devices compute, without a window.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/devices/device_watch.h"
#include "app/virtual_desktop/devices/force_reason.h"
#include "app/virtual_desktop/devices/gloved_hand.h"
#include "app/virtual_desktop/devices/input_devices.h"
#include "mannequin/motion/free_hand.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

TEST(DeviceListing, ReadsWhatTheCommandWrites) {
  const auto listing =
      parseListing(R"({"drivers":[{"name":"falcon","title":"Novint Falcon","version":"1.0","library":"libusb 1.0.26",
    "note":null,"usable":true,"problem":null,"fix":null}],"devices":[{"device":"falcon:F1","driver":"falcon","id":"F1",
    "name":"Novint Falcon","kind":"stylus","simulated":false,"place":"usb 1-4","firmware":null,"usable":false,
    "reason":"no_permission","problem":"may not be opened","fix":"sudo cp"}],"permissions":[{"what":"udev rules","granted":false,
    "found":"not installed","fix":"sudo cp"}],"versions":{"hapticell":"0.1.0","driver_interface":1,"protocol":1,"kernel":"6.1"}})");
  ASSERT_TRUE(listing);
  ASSERT_EQ(listing->devices.size(), 1u);
  EXPECT_EQ(listing->devices[0].device, "falcon:F1");
  EXPECT_FALSE(listing->devices[0].usable);
  EXPECT_EQ(listing->devices[0].fix, "sudo cp");
  EXPECT_TRUE(listing->drivers.at(0).usable);
  EXPECT_FALSE(listing->grants.at(0).granted);
  EXPECT_TRUE(listing->versions.contains("0.1.0"));
}

TEST(DeviceListing, RefusesAnythingElse) {
  for (const char* text : {"", "[]", "{}", "{\"devices\":3,\"drivers\":[]}", "{\"devices\":[]", "hello"}) {
    EXPECT_FALSE(parseListing(text)) << text;
  }
}

TEST(RangeTest, CountsWhatWasReachedAndPressed) {
  RangeTest test;
  const dvec3 low(-0.08, -0.06, -0.05), high(0.08, 0.06, 0.05);
  EXPECT_EQ(test.covered(low, high), dvec3(0.0));
  test.take({-0.04, 0.0, -0.5}, 0);
  test.take({0.04, 0.0, 0.5}, 1);
  test.take({0.0, 0.0, 0.0}, 2);
  const dvec3 part = test.covered(low, high);
  EXPECT_NEAR(part.x, 0.5, 1e-12);
  EXPECT_NEAR(part.y, 0.0, 1e-12);
  EXPECT_NEAR(part.z, 1.0, 1e-12);  // Beyond the edge is the edge.
  EXPECT_EQ(test.pressedOnce(), 3u);
  EXPECT_EQ(test.pressedNow(), 2u);
  test.reset();
  EXPECT_EQ(test.pressedOnce(), 0u);
}

TEST(ForceTest, RisesSlowlyHoldsAndFalls) {
  EXPECT_EQ(testPush(-1.0, 1.0), 0.0);
  EXPECT_EQ(testPush(0.0, 1.0), 0.0);
  EXPECT_NEAR(testPush(1.0, 1.0), 0.5, 1e-12);
  EXPECT_NEAR(testPush(2.5, 1.0), 1.0, 1e-12);
  EXPECT_EQ(testPush(kTestSeconds, 1.0), 0.0);
  EXPECT_EQ(testPush(std::nan(""), 1.0), 0.0);
  double before = 0.0;
  for (int ms = 0; ms <= 5000; ++ms) {
    const double now = testPush(1e-3 * ms, 1.0);
    EXPECT_LE(std::abs(now - before), 1.1e-3);  // N a millisecond: no step.
    before = now;
  }
}

TEST(ForceReason, NamesADeviceThatFailsAndOneWithoutMotors) {
  ForceFacts facts;
  facts.started = facts.connected = true;
  facts.device_fault = true;
  EXPECT_TRUE(forceReason(facts).why.contains("not responding"));
  facts.device_fault = false;
  facts.forceless = true;
  EXPECT_TRUE(forceReason(facts).why.contains("no force"));
}

TEST(SpaceMouse, MovesTheViewAsIfTheCapWereTheScene) {
  const ViewSize size{1000.0, 800.0};
  Camera camera;
  const dvec3 p(0.1, 0.2, 0.0);
  const auto before = camera.project(p, size);
  const double right[6]{1, 0, 0, 0, 0, 0}, away[6]{0, 1, 0, 0, 0, 0}, up[6]{0, 0, 1, 0, 0, 0}, still[6]{};
  const auto shifted = movedByMouse(camera, right, 0.05, size).project(p, size);
  ASSERT_TRUE(before && shifted);
  EXPECT_GT(shifted->x, before->x + 10.0);
  EXPECT_LT(movedByMouse(camera, up, 0.05, size).project(p, size)->y, before->y - 10.0);
  EXPECT_GT(movedByMouse(camera, away, 0.05, size).distance, camera.distance);
  EXPECT_EQ(movedByMouse(camera, still, 0.05, size).distance, camera.distance);
  const double turn[6]{0, 0, 0, 0, 0, 1};
  // Counter-clockwise from above: what is in front of the target goes to the right.
  Camera front = Camera().turnedTo(StandardView::kFront);
  const dvec3 near_side(0.0, -1.0, 0.0);
  EXPECT_GT(movedByMouse(front, turn, 0.05, size).project(near_side, size)->x, front.project(near_side, size)->x);
  // A window that stood still for long does not leap.
  EXPECT_EQ(movedByMouse(camera, away, 0.1, size).distance, movedByMouse(camera, away, 30.0, size).distance);
}

TEST(SpaceMouse, MovesTheHandGentlyAboutTheMiddle) {
  const double half[6]{0.5, 0, 0, 0, 0, -0.5}, full[6]{1, 0, 0, 0, 0, -1};
  const Twist little = handMotion(half, 0.01), much = handMotion(full, 0.01);
  EXPECT_NEAR(little.linear.x, 0.25 * much.linear.x, 1e-12);
  EXPECT_NEAR(much.linear.x, 0.0012, 1e-12);
  EXPECT_NEAR(much.angular.z, -0.012, 1e-12);
}

workcell::Entity load(const char* what, const char* name) {
  Diagnostics diagnostics;
  workcell::Entity entity = *workcell::EntityLoader(".").load(what, 1.0, diagnostics);
  entity.name = name;
  return entity;
}

TEST(GlovedHand, IsTheChosenOnesElseAFreeHandElseTheFirstMannequins) {
  mannequin::GloveReadings angles;
  angles.fill(0.5);
  workcell::Document document;
  EXPECT_EQ(glovedHand(document, 0, mannequin::Side::kRight, angles).entity, 0u);
  const auto figure = document.execute(workcell::AddEntity{load("mannequin:male:50", "worker")}).value();
  const GlovedHand of_figure = glovedHand(document, 0, mannequin::Side::kLeft, angles);
  EXPECT_EQ(of_figure.entity, figure);
  EXPECT_EQ(of_figure.side, mannequin::Side::kLeft);
  EXPECT_EQ(of_figure.fingers.size(), 3u);
  const std::size_t curl = mannequin::indexOf(mannequin::Dof::kLeftFingersCurl);
  EXPECT_NEAR(of_figure.joints[curl], 0.5, 1e-9);
  const auto& stands = document.find(figure)->joints();
  for (std::size_t i = 0; i < stands.size(); ++i) {
    const bool finger = std::any_of(of_figure.fingers.begin(), of_figure.fingers.end(),
                                    [i](const auto& one) { return one.front() == i; });
    if (!finger) {
      EXPECT_EQ(of_figure.joints[i], stands[i]) << i;
    }
  }
  const auto hand = document.execute(workcell::AddEntity{load("hand:right", "hand")}).value();
  EXPECT_EQ(glovedHand(document, 0, mannequin::Side::kLeft, angles).entity, figure) << "a right hand for a left glove";
  const GlovedHand free = glovedHand(document, 0, mannequin::Side::kRight, angles);
  EXPECT_EQ(free.entity, hand);
  EXPECT_EQ(free.fingers.size(), mannequin::kFreeHandJoints);
  EXPECT_NEAR(free.bend[1], 0.5, 1e-12);
  EXPECT_EQ(glovedHand(document, figure, mannequin::Side::kRight, angles).entity, figure);
  document.execute(workcell::SetProperties{.id = hand, .locked = true});
  EXPECT_EQ(glovedHand(document, hand, mannequin::Side::kRight, angles).entity, figure) << "locked";
}

TEST(GloveCalibrator, TakesFourPosesOneAfterAnother) {
  GloveCalibrator calibrator;
  const double levels[4]{60.0, 190.0, 130.0, 160.0};
  for (int pose = 0; pose < GloveCalibrator::kPoses; ++pose) {
    EXPECT_EQ(calibrator.next(), pose);
    EXPECT_FALSE(GloveCalibrator::instruction(pose).isEmpty());
    EXPECT_FALSE(calibrator.result());
    mannequin::GloveReadings readings;
    readings.fill(levels[pose]);
    calibrator.take(readings);
  }
  EXPECT_TRUE(calibrator.result());
  GloveCalibrator dead;
  for (int pose = 0; pose < GloveCalibrator::kPoses; ++pose) {
    mannequin::GloveReadings readings;
    readings.fill(levels[pose]);
    readings[5] = 77.0;  // A sensor that never moves.
    dead.take(readings);
  }
  EXPECT_FALSE(dead.result());
  EXPECT_EQ(dead.badSensor(), 5);
}

}  // namespace
}  // namespace hapticell::app
