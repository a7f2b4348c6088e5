// SPDX-License-Identifier: Apache-2.0
// Pictures of recorded motions.
#include "app/trajectory/motions/motion_export.h"
#include "tests/app/docs_pictures/picture_page.h"

namespace hapticell::app {
namespace {

bool isIdle(PicturePage& page) {
  const auto* cancel = page.window().findChild<QAbstractButton*>("buttonCancelMotionWork");
  return cancel && !cancel->isVisibleTo(cancel->parentWidget());
}

bool hasMotions(PicturePage& page, std::size_t count) {
  return PicturePage::until([&] { return page.state().trajectories.size() == count && isIdle(page); },
                            2 * PicturePage::kPatience);
}

/// The robot of the demonstration recorded, timed anew with limited jerk, all curves of its joints.
void curves(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.look({2.75, -1.95, 1.95}, {0.72, 0.1, 0.78});
  page.showDock("dockMotion");
  page.showDock("dockTrajectory");
  page.prepareHand("robot", PicturePage::kMedium);
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.trigger("actionRecord");
  ASSERT_TRUE(page.followHand(PicturePage::shippedHand("workcells/demo-hand.csv"), 12.0));
  page.trigger("actionRecord");
  ASSERT_TRUE(hasMotions(page, 1)) << "nothing was recorded";
  page.trigger("actionForcesOn");
  constexpr int kLimitedJerk = 3;
  page.chooseEntry("comboTiming", kLimitedJerk);
  page.press("buttonSmoothMotion");
  ASSERT_TRUE(hasMotions(page, 2)) << "it was not smoothed";
  page.press("buttonRetime");
  ASSERT_TRUE(hasMotions(page, 3)) << "it was not timed";
  constexpr int kJoints = 3, kAllFour = 4;
  page.chooseEntry("comboCurveGroup", kJoints);
  page.chooseEntry("comboCurveOrder", kAllFour);
  page.keep();
}

/// The expert's motion of the exercise with a door, all places on its way.
void sweptVolume(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("exercises/door.hcell"));
  const auto motion = config::findShippedFile("exercises/door-expert.htraj");
  ASSERT_TRUE(motion.has_value());
  page.window().findChild<MotionExport*>()->importFrom({QString::fromStdString(*motion)}, "door");
  ASSERT_TRUE(hasMotions(page, 1));
  page.lookFrom(34, 26, page.window().viewport().scene().bounds_W());
  page.showDock("dockTrajectory");
  page.showDock("dockVirtualDesktop");
  page.press("buttonSwept");
  const auto isSwept = [&] {
    const auto items = page.window().viewport().scene().items({});
    return std::any_of(items.begin(), items.end(), [](const RenderItem& item) { return item.ghost != Ghost::kNone; });
  };
  ASSERT_TRUE(PicturePage::until(isSwept, PicturePage::kPatience)) << "no swept volume";
  page.keep();
}

}  // namespace

std::vector<DocsPicture> motionPictures() {
  return {{"motion-curves", {1600, 900}, "dockTrajectory", curves},
          {"swept-volume", {1000, 625}, "dockTrajectory", sweptVolume, {1600, 1000}}};
}

}  // namespace hapticell::app
