// SPDX-License-Identifier: Apache-2.0
// Pictures of what is held by the stylus, and of its contacts.
#include <QLineEdit>
#include <QTemporaryDir>

#include "app/mannequin/mannequin_edits.h"
#include "app/shell/layouts.h"
#include "app/trajectory/training/training_panel.h"
#include "mannequin/posture/forward_kinematics.h"
#include "tests/app/docs_pictures/picture_page.h"

namespace hapticell::app {
namespace {

bool touches(PicturePage& page) {
  const auto& pairs = page.now().pairs;
  return std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.contact; });
}

/// The robot of the demonstration is led by its TCP; the housing slides over the locators towards the stop rail.
void demonstration(PicturePage& page, double end_s) {
  page.prepareHand("robot", PicturePage::kMedium);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  ASSERT_TRUE(page.followHand(PicturePage::shippedHand("workcells/demo-hand.csv"), end_s));
  ASSERT_TRUE(PicturePage::until([&] { return touches(page); }, PicturePage::kPatience)) << "no contact";
}

constexpr double kPressed = 3.3, kAtTheRail = 7.2;  // s of the demonstration's hand.

void mainWindow(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.look({2.14, -1.30, 1.62}, {0.80, 0.05, 0.85});
  page.showDock("dockTrajectory");
  page.trigger("actionRecord");
  demonstration(page, kAtTheRail);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.showDock("dockVirtualDesktop");
  page.keep();
}

void mainWindowLight(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.look({2.14, -1.30, 1.62}, {0.80, 0.05, 0.85});
  page.showDock("dockCollisions");
  demonstration(page, kAtTheRail);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.showDock("dockVirtualDesktop");
  page.keep();
}

void collisions(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.look({1.30, -0.44, 0.98}, {0.98, 0.0, 0.83});
  page.showDock("dockVirtualDesktop");
  page.showDock("dockCollisions");
  demonstration(page, kPressed);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.keep();
}

void carDoor(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/car_door.hcell"));
  page.look({1.75, -1.95, 1.35}, {0.47, 0.0, 0.45});
  page.prepareHand("door", PicturePage::kRough);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  constexpr double kHalfOpen = 4.0;  // s of the hand.
  ASSERT_TRUE(page.followHand(PicturePage::shippedHand("workcells/car_door-hand.csv"), kHalfOpen));
  ASSERT_TRUE(PicturePage::until([&] { return page.now().stylus.held != 0; }, PicturePage::kPatience));
  page.showDock("dockCollisions");
  page.showDock("dockGuides");
  page.keep();
}

/// The arm is stretched until its reach ends.
void robotLimit(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  Diagnostics diagnostics;
  auto robot = workcell::EntityLoader({}).load("library:kuka_kr16_2", 0.0, diagnostics);
  ASSERT_TRUE(robot.has_value());
  robot->setJoints(kinematics::restPositions(*robot->robot()));
  const std::string name = robot->name;
  ASSERT_TRUE(page.window().documentModel().execute(workcell::AddEntity{std::move(*robot)}));
  page.look({3.1, -2.9, 2.1}, {0.75, 0.0, 0.75});
  page.showDock("dockCollisions");
  page.prepareHand(name.c_str(), PicturePage::kRough);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  dvec3 p_DH(-0.070, 0.0, 0.0);
  page.take(p_DH);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  const auto stops = [&] {
    const auto& limits = page.now().limits;
    return page.now().stylus.force_n > 1.0 &&
           std::any_of(limits.begin(), limits.end(), [](const auto& limit) { return limit.holds; });
  };
  ASSERT_TRUE(page.leadUntil(p_DH, {1.0, 0.0, 0.0}, 0.145, stops)) << "the reach does not end";
  page.showDock("dockVirtualDesktop");
  page.keep();
}

/// The right hand goes to the cover of the bench and presses on it.
void mannequinContact(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/workbench.hcell"));
  page.look({1.75, -2.0, 1.70}, {0.0, -0.25, 1.05});
  page.showDock("dockCollisions");
  page.prepareHand("operator", PicturePage::kRough);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  constexpr int kRightHand = 2;
  page.chooseSegment("segmentsMovedBy", kRightHand);
  const auto& person = *page.document().findByName("operator");
  const auto pose = mannequin::forwardKinematics(*person.figure(), postureOf(person));
  const auto side = mannequin::Side::kRight;
  const dvec3 p_WGrip = mannequin::handPose(pose, side) * person.figure()->p_HandGrip[static_cast<std::size_t>(side)];
  const geometry::Bounds cover = page.window().viewport().scene().boundsOf_W(page.document().findByName("cover")->id);
  // Over it first, then down; the hand's workspace is shared evenly by the way.
  constexpr double kScale = 4.0, kAbove = 0.10;
  const dvec3 p_WAbove(cover.center().x, cover.center().y, cover.max.z + kAbove);
  const dvec3 way_D = (p_WAbove - p_WGrip) / kScale;
  dvec3 p_DH = -0.5 * way_D + dvec3(0.0, 0.0, 0.5 * kAbove / kScale);
  page.take(p_DH);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.leadUntil(p_DH, glm::normalize(way_D), glm::length(way_D), [] { return false; });
  const auto presses = [&] { return touches(page) && page.now().stylus.force_n > 1.0; };
  ASSERT_TRUE(page.leadUntil(p_DH, {0.0, 0.0, -1.0}, 0.06, presses)) << "the hand does not meet the cover";
  page.showDock("dockVirtualDesktop");
  page.keep();
}

/// A trainee in the middle of the first exercise.
void training(const PictureTask& task) {
  QTemporaryDir folder;
  PicturePage page(task, Stylus::kSimulated);
  page.window().layouts().choose("teach");
  page.trigger("actionTraining");
  page.chooseEntry("comboExercise", "Peg in hole");
  ASSERT_TRUE(PicturePage::until([&] { return page.document().findByName("peg") != nullptr; }, PicturePage::kPatience));
  page.look({0.52, -0.60, 0.46}, {0.0, 0.0, 0.03});
  page.window().findChild<TrainingPanel*>()->setResults(folder.filePath("anna.htrain"));
  page.find<QLineEdit>("editTrainee")->setText("Anna");
  page.chooseSegment("segmentsAxes", 1);
  page.showDock("dockTrajectory");
  page.showDock("dockTraining");
  page.press("buttonStartRun");
  ASSERT_TRUE(PicturePage::until([&] { return page.now().stylus.forces_on; }, PicturePage::kPatience));
  constexpr double kOnItsWay = 2.3;  // s of the hand.
  ASSERT_TRUE(page.followHand(PicturePage::shippedHand("exercises/peg_in_hole-hand.csv"), kOnItsWay));
  ASSERT_TRUE(page.window().findChild<TrainingPanel*>()->isRunning());
  ASSERT_TRUE(PicturePage::until([&] { return page.now().stylus.held != 0; }, PicturePage::kPatience)) << "nothing is held";
  page.keep();
}

}  // namespace

std::vector<DocsPicture> contactPictures() {
  return {{"main-window", {1920, 1080}, "dockVirtualDesktop", mainWindow},
          {"main-window-light", {1920, 1080}, "dockVirtualDesktop", mainWindowLight},
          {"collisions", {1280, 720}, "dockCollisions", collisions},
          {"car-door", {1280, 720}, "dockGuides", carDoor},
          {"robot-limit", {1600, 900}, "dockVirtualDesktop", robotLimit},
          {"mannequin-contact", {1600, 900}, "dockVirtualDesktop", mannequinContact},
          {"training", {1920, 1080}, "dockTraining", training}};
}

}  // namespace hapticell::app
