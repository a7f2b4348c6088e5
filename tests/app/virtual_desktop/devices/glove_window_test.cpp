// SPDX-License-Identifier: Apache-2.0
// A glove in the window, alone and beside a stylus and a 3-D mouse.
#include "tests/app/pages/device_window_page.h"  // First: see there.

#include "mannequin/body/body_request_text.h"
#include "mannequin/motion/free_hand.h"
#include "tests/haptic/devices/drivers/cyberglove/fake_glove.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

std::string settingsOf(const driver::FakeGlove& glove) {
  return "[driver.cyberglove]\nport = \"" + glove.path() + "\"\nmode = \"poll\"\n";
}

/// Sets what the glove tells and waits until the driver has asked for it a few times.
void holdHand(driver::FakeGlove& glove, int first) {
  glove.first = first;
  const int asked = glove.polls;
  EXPECT_TRUE(WindowPage::until([&] { return glove.polls > asked + 5; }, kPatience));
}

workcell::Entity load(const char* what) {
  workcell::EntityLoader loader(".");
  Diagnostics diagnostics;
  return *loader.load(what, 1.0, diagnostics);
}

/// rad that the four fingers' joints of a free hand are bent in all; a fist in free air is 12 * 1.57.
double bentInAll(const std::vector<double>& joints) {
  double sum = 0.0;
  for (const std::size_t first : {5u, 9u, 13u, 17u}) sum += joints[first] + joints[first + 1] + joints[first + 2];
  return sum;
}

constexpr int kFlat = 60, kFist = 190, kSpread = 130, kThumbUnder = 160;

void calibrate(DevicePage& page, driver::FakeGlove& glove) {
  ASSERT_TRUE(page.says("labelGlove", "not calibrated for you"));
  holdHand(glove, kFlat);
  page.pressSeen("buttonCalibrateGlove");
  for (const int pose : {kFlat, kFist, kSpread, kThumbUnder}) {
    holdHand(glove, pose);
    page.pressSeen("buttonCalibrateNext");
  }
  EXPECT_TRUE(page.says("labelCalibration", "Calibrated for you"));
}

TEST(GloveInTheWindow, IsCalibratedGraspsAndLetsGo) {
  driver::FakeGlove glove;
  DevicePage page(settingsOf(glove));
  workcell::Entity hand = load("hand:right");
  const auto figure = mannequin::makeFigure(*mannequin::parseBodyRequest("mannequin:male:50"));
  page.window().documentModel().execute(workcell::AddEntity{hand});
  const auto grip = figure->p_HandGrip[1];
  const workcell::EntityId bar = page.addSolid("bar", geometry::makeBox(dvec3(0.041)), Pose::translation(grip));
  page.window().documentModel().execute(workcell::SetProperties{.id = bar, .locked = true});
  page.lookAt({0.09, 0.0, -0.06}, 0.14);
  page.lookRound(450.0);  // At the palm.
  page.start();
  page.choose("comboGlove", "CyberGlove");
  calibrate(page, glove);
  EXPECT_TRUE(QFile::exists(page.file("devices/glove.json"))) << "kept for this user";

  // Closed on a bar that may not be moved: fingers stop at it, and those that touch are shaken.
  const workcell::EntityId hand_id = page.document().findByName("right hand")->id;
  const auto bend = [&] {
    if (page.snapshot())
      for (const auto& entity : page.snapshot()->entities)
        if (entity.id == hand_id) return bentInAll(entity.joints);
    return bentInAll(page.document().find(hand_id)->joints());
  };
  double most = 0.0, nearest = 1.0;  // However short it was seen; m between the bar and what of the hand is near it.
  const auto held = [&] {
    most = std::max({most, bend(), bentInAll(page.document().find(hand_id)->joints())});
    if (page.snapshot())
      for (const auto& pair : page.snapshot()->pairs)
        if (pair.moved == hand_id && pair.other == bar) nearest = std::min(nearest, pair.distance);
    return !page.document().find(bar)->attachment.to.empty();
  };
  ASSERT_TRUE(WindowPage::until([&] { return connected(page); }, kPatience));
  holdHand(glove, kFist);
  const auto shaken = [&] {
    EXPECT_FALSE(held());
    for (const auto& all : glove.vibrations()) {
      if (std::any_of(all.begin(), all.end() - 1, [](std::uint8_t each) { return each > 0; })) return true;
    }
    return false;
  };
  EXPECT_TRUE(WindowPage::until(shaken, kPatience)) << "no finger was shaken";
  // As soon as it may be moved it goes with the hand that is closed on it.
  page.window().documentModel().execute(workcell::SetProperties{.id = bar, .locked = false});
  EXPECT_TRUE(WindowPage::until(held, kPatience)) << "the bar was not taken";
  page.picture("glove-grasp");
  EXPECT_GT(bend(), 4.0) << "the fingers did not close";
  EXPECT_LT(most, 0.9 * 12 * 1.57) << "they went through the bar";
  EXPECT_GT(nearest, 0.0) << "they went into the bar";
  EXPECT_LT(nearest, 1e-3) << "they did not touch it";
  holdHand(glove, kFlat);
  EXPECT_TRUE(WindowPage::until([&] { return !held(); }, kPatience)) << "the bar was not let go";
  EXPECT_TRUE(WindowPage::until([&] { return bend() < 0.5; }, kPatience));
  EXPECT_EQ(page.document().find(bar)->X_WE.p, grip) << "nothing moved it";

  // Pulled out and plugged in again.
  glove.unplug();
  EXPECT_TRUE(WindowPage::until([&] { return !page.text("labelGlove").contains("CyberGlove I"); }, kPatience));
}

/// A stylus holds one part, a 3-D mouse as the second stylus another one, a glove closes a hand: all at once.
TEST(StylusGloveAndSpaceMouseInTheWindow, WorkAtOnce) {
  driver::FakeGlove glove;
  driver::MockHidraw mouse;
  DevicePage page(settingsOf(glove));
  workcell::Entity hand = load("hand:right");
  hand.X_WE.p = {-0.15, 0.0, 0.05};
  page.window().documentModel().execute(workcell::AddEntity{hand});
  const workcell::EntityId box = page.addSolid("box", geometry::makeBox(dvec3(0.06)));
  page.lookAt({0.0, 0.0, 0.0}, 0.3);
  page.start();
  page.choose("comboGlove", "CyberGlove");
  page.choose("comboSecondStylus", "SpaceMouse Compact");
  EXPECT_TRUE(page.says("labelSecondStylus", "Connected"));
  ASSERT_TRUE(page.stylusesRest());
  const dvec3 tip = page.second()->X_WStylus.p;
  const workcell::EntityId part = page.addSolid("part", geometry::makeBox(dvec3(0.03)), Pose::translation(tip));

  // Each takes its own.
  page.select(box);
  page.key(Qt::Key_B);
  ASSERT_TRUE(WindowPage::until([&] { return page.snapshot()->stylus.held == box; }, kPatience));
  const auto isReady = [&] {
    const auto scene = page.window().preparedScene();
    return scene && scene->find(part) != nullptr;
  };
  ASSERT_TRUE(WindowPage::until(isReady, kPatience));
  mouse.send({3, 1, 0});
  ASSERT_TRUE(WindowPage::until([&] { return page.second()->held == part; }, kPatience));
  mouse.send({3, 0, 0});
  holdHand(glove, kFist);
  const auto stateOf = [&](workcell::EntityId id) -> const manipulation::EntityState* {
    for (const auto& entity : page.snapshot()->entities)
      if (entity.id == id) return &entity;
    return nullptr;
  };
  const workcell::EntityId hand_id = page.document().findByName("right hand")->id;
  const auto bend = [&] {
    const auto* shown = stateOf(hand_id);
    return shown ? shown->joints[5] : page.document().find(hand_id)->joints()[5];
  };
  EXPECT_TRUE(WindowPage::until([&] { return bend() > 0.8; }, kPatience)) << "the glove closes the hand";

  // And each moves it.
  ASSERT_TRUE(page.stylusesRest());
  page.dragPen(page.snapshot()->stylus.X_WStylus.p);
  const auto wayOf = [&](workcell::EntityId id, const dvec3& from) {
    const auto* shown = stateOf(id);
    return shown ? shown->X_WE.p.x - from.x : 0.0;
  };
  EXPECT_TRUE(WindowPage::until([&] { return wayOf(box, dvec3(0.0)) > 0.01; }, kPatience)) << "by the stylus";
  const auto pushed = [&] { return mouse.send({1, 0x5E, 1, 0, 0, 0, 0}), wayOf(part, tip) > 0.01; };
  EXPECT_TRUE(WindowPage::until(pushed, kPatience)) << "by the 3-D mouse";
  mouse.send({1, 0, 0, 0, 0, 0, 0});
  page.picture("three-devices");
  EXPECT_EQ(page.snapshot()->stylus.held, box);
  EXPECT_EQ(page.second()->held, part);
  EXPECT_GT(bend(), 0.8);
}

}  // namespace
}  // namespace hapticell::app
