// SPDX-License-Identifier: Apache-2.0
// 3-D mouse, second stylus and the device check in the window.
#include "tests/app/pages/device_window_page.h"  // First: see there.

#include "app/style/proxy_style.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

TEST(SpaceMouseInTheWindow, MovesTheViewAndDrivesEntities) {
  driver::MockHidraw mouse;
  ASSERT_TRUE(mouse.isThere());
  DevicePage page;
  const workcell::EntityId box = page.addSolid("box", geometry::makeBox(dvec3(0.06)));
  page.lookAt({0.0, 0.0, 0.0}, 0.3);
  page.start();
  page.select(box);
  page.choose("comboSpaceMouse", "SpaceMouse Compact");
  ASSERT_TRUE(page.says("labelSpaceMouse", "SpaceMouse Compact"));
  const auto deflect = [&](int right) {
    const auto low = static_cast<std::uint8_t>(right & 0xFF), high = static_cast<std::uint8_t>(right >> 8 & 0xFF);
    mouse.send({1, low, high, 0, 0, 0, 0});
  };
  const auto target = [&] { return page.window().viewport().camera().target_W; };
  const dvec3 before = target();
  EXPECT_TRUE(WindowPage::until([&] { return deflect(350), glm::length(target() - before) > 0.02; }, kPatience));
  deflect(0);
  // Its second button: from now on it drives what is held; its first takes and lets go.
  mouse.send({3, 2, 0});
  auto* moves = page.find<Segmented>("segmentsMouseMoves");
  ASSERT_TRUE(WindowPage::until([&] { return moves->button(1)->isChecked(); }, kPatience));
  mouse.send({3, 0, 0});
  ASSERT_TRUE(WindowPage::until([&] { return connected(page); }, kPatience));
  const auto heldNow = [&] { return page.window().viewport().scene().snapshot()->stylus.held; };
  mouse.send({3, 1, 0});
  ASSERT_TRUE(WindowPage::until([&] { return heldNow() == box; }, kPatience)) << "it was not taken";
  mouse.send({3, 0, 0});
  const auto shownX = [&] {
    for (const auto& entity : page.window().viewport().scene().snapshot()->entities) {
      if (entity.id == box) return entity.X_WE.p.x;
    }
    return page.document().find(box)->X_WE.p.x;
  };
  EXPECT_TRUE(WindowPage::until([&] { return deflect(350), shownX() > 0.02; }, kPatience)) << "it was not moved";
  deflect(0);
  page.picture("space-mouse");
  mouse.send({3, 1, 0});
  EXPECT_TRUE(
      WindowPage::until([&] { return heldNow() == 0 && page.document().find(box)->X_WE.p.x > 0.02; }, kPatience));
  mouse.send({3, 0, 0});
  EXPECT_LT(std::abs(page.document().find(box)->X_WE.p.z), 0.005);
}

/// A stylus that a hand holds takes one part; the 3-D mouse, which is to move entities, becomes the second stylus and
/// moves another one; then it moves the view again.
TEST(SpaceMouseInTheWindow, MovesEntitiesBesideAStylusInAHand) {
  driver::MockHidraw mouse;
  QTemporaryDir hands;
  const std::string hand = hands.path().toStdString() + "/hand";
  const auto holdStylus = [&](double x, int buttons) {
    std::ofstream(hand + ".new") << x << " 0 0 " << buttons;
    rename((hand + ".new").c_str(), hand.c_str());
  };
  holdStylus(0.0, 0);
  DevicePage page("[driver.handy]\nhand = \"" + hand + "\"\n");
  const workcell::EntityId box = page.addSolid("box", geometry::makeBox(dvec3(0.04)), Pose::translation({-0.2, 0, 0}));
  page.lookAt({0.0, 0.0, 0.0}, 0.4);
  page.start();
  page.choose("comboStylus", "Handy stylus");
  const auto inHand = [&] { return connected(page) && std::abs(page.snapshot()->stylus.X_DS.p.x) < 1e-9; };
  ASSERT_TRUE(WindowPage::until(inHand, kPatience));
  page.select(box);
  holdStylus(0.0, 1);
  ASSERT_TRUE(WindowPage::until([&] { return page.snapshot()->stylus.held == box; }, kPatience));
  holdStylus(0.0, 0);

  page.choose("comboSpaceMouse", "SpaceMouse Compact");
  ASSERT_TRUE(page.says("labelSpaceMouse", "SpaceMouse Compact"));
  // Window and server read the same mocked file, where each report reaches one of them only (a real one tells both):
  // what is pressed or deflected is told again and again.
  using Report = std::vector<std::uint8_t>;
  const auto tells = [&](const Report& report, auto&& done) {
    return WindowPage::until([&] { return mouse.send(report), done(); }, kPatience);
  };
  const auto rests = [&](const Report& report) {
    for (int i = 0; i < 40; ++i) {
      mouse.send(report);
      page.settle();
    }
  };
  mouse.send({3, 2, 0});
  ASSERT_TRUE(page.says("labelSecondStylus", "Connected"));
  rests({3, 0, 0});
  ASSERT_TRUE(page.stylusesRest());
  const dvec3 tip = page.second()->X_WStylus.p;
  const workcell::EntityId part = page.addSolid("part", geometry::makeBox(dvec3(0.03)), Pose::translation(tip));
  const auto isReady = [&] {
    const auto scene = page.window().preparedScene();
    return scene && scene->find(part) != nullptr;
  };
  ASSERT_TRUE(WindowPage::until(isReady, kPatience));
  ASSERT_TRUE(tells({3, 1, 0}, [&] { return page.second()->held == part; }));
  rests({3, 0, 0});
  const auto xOf = [&](workcell::EntityId id) {
    for (const auto& entity : page.snapshot()->entities)
      if (entity.id == id) return entity.X_WE.p.x;
    return page.document().find(id)->X_WE.p.x;
  };
  const Report deflected{1, 0x5E, 1, 0, 0, 0, 0}, straight{1, 0, 0, 0, 0, 0, 0};
  EXPECT_TRUE(tells(deflected, [&] { return xOf(part) > tip.x + 0.01; })) << "by the 3-D mouse";
  rests(straight);
  EXPECT_NEAR(xOf(box), -0.2, 1e-3) << "that is in the other hand";
  holdStylus(0.02, 0);
  EXPECT_TRUE(WindowPage::until([&] { return xOf(box) > -0.19; }, kPatience)) << "by the stylus";
  page.picture("stylus-and-space-mouse");

  EXPECT_TRUE(tells({3, 2, 0}, [&] { return !page.second(); })) << "the view again";
  rests({3, 0, 0});
  const auto target = [&] { return page.window().viewport().camera().target_W; };
  const dvec3 before = target();
  EXPECT_TRUE(tells(deflected, [&] { return glm::length(target() - before) > 0.02; }));
  rests(straight);
}

/// Plugged in while the program runs, pulled out, plugged in again: the panel follows, and nobody is disturbed.
TEST(DevicesInTheWindow, ComeAndGoWhileItRuns) {
  driver::MockHidraw mouse;
  mouse.unplug();
  DevicePage page;
  page.start();
  ASSERT_TRUE(page.lists("comboStylus", "Needy stylus")) << "the first listing";
  ASSERT_TRUE(WindowPage::until([&] { return connected(page); }, kPatience));
  auto* combo = page.find<QComboBox>("comboSpaceMouse");
  EXPECT_EQ(combo->count(), 1) << "none yet";
  mouse.plug();
  page.choose("comboSpaceMouse", "SpaceMouse Compact");
  ASSERT_TRUE(page.says("labelSpaceMouse", "SpaceMouse Compact"));
  mouse.unplug();
  EXPECT_TRUE(WindowPage::until([&] { return combo->currentText().contains("unplugged"); }, kPatience));
  EXPECT_LT(page.find<QComboBox>("comboStylus")->findText("SpaceMouse", Qt::MatchContains), 0);
  mouse.plug();
  EXPECT_TRUE(WindowPage::until([&] { return combo->currentText() == "SpaceMouse Compact"; }, kPatience));
  EXPECT_TRUE(page.says("labelSpaceMouse", "SpaceMouse Compact"));
  EXPECT_TRUE(connected(page));
  EXPECT_FALSE(page.snapshot()->stylus.device_fault);
}

TEST(SecondStylusInTheWindow, IsChosenDrawnAndTakenByTheMouse) {
  DevicePage page;
  page.addSolid("left", geometry::makeBox(dvec3(0.06)), Pose::translation({-0.15, 0, 0}));
  page.lookAt({0.0, 0.0, 0.0}, 0.3);
  page.start();
  page.choose("comboSecondStylus", "Touch");
  EXPECT_TRUE(page.says("labelSecondStylus", "Connected"));
  ASSERT_TRUE(page.stylusesRest());
  page.picture("second-stylus");
  // The mouse drags the second pen; the first stays.
  const dvec3 start = page.second()->X_WStylus.p, first_at = page.snapshot()->stylus.X_WStylus.p;
  page.dragPen(start);
  EXPECT_TRUE(WindowPage::until([&] { return page.second()->X_WStylus.p.x > start.x + 0.01; }, kPatience));
  EXPECT_LT(glm::length(page.snapshot()->stylus.X_WStylus.p - first_at), 0.005);
  page.choose("comboSecondStylus", "None");
  EXPECT_TRUE(WindowPage::until([&] { return !page.second(); }, kPatience));
}

TEST(DeviceCheckInTheWindow, TellsTestsAndCalibrates) {
  driver::MockHidraw mouse;
  mouse.forbid();
  DevicePage page;
  page.start();
  page.pressSeen("buttonCheckDevice");
  ASSERT_TRUE(WindowPage::until([&] { return page.hasDock("dockDeviceCheck"); }, kPatience));
  EXPECT_TRUE(page.says("labelCalibrated", "simulated stylus needs no calibration"));
  EXPECT_FALSE(page.text("labelWhyNoForce").isEmpty());

  // What the stylus reaches and presses is counted.
  ASSERT_TRUE(WindowPage::until([&] { return connected(page); }, kPatience));
  ASSERT_TRUE(page.stylusesRest(false));
  page.dragPen(page.snapshot()->stylus.X_WStylus.p);
  page.key(Qt::Key_B);
  EXPECT_TRUE(WindowPage::until([&] { return page.snapshot()->stylus.X_DS.p.x > 0.03; }, kPatience));

  const auto mends = [&] {
    for (const auto* label : page.window().findChildren<QLabel*>())
      if (label->text().contains("70-hapticell.rules")) return true;
    return false;
  };
  ASSERT_TRUE(WindowPage::until(mends, kPatience)) << "what is plugged in was not listed";

  // The force test asks first, and what it did is told.
  page.pressSeen("buttonForceAsk");
  page.reveal(page.find<QLabel>("labelWhyNoForce"));
  page.reveal(page.find<QPushButton>("buttonForceGo"));
  page.picture("device-check-asks");
  page.pressSeen("buttonForceGo");
  auto* ask = page.find<QPushButton>("buttonForceAsk");
  EXPECT_TRUE(WindowPage::until([&] { return ask->isVisible() && ask->isEnabled(); }, kPatience));
  const auto toldPush = [&] {
    for (const auto* label : page.window().findChildren<QLabel*>())
      if (label->text().contains("N were commanded")) return label->text();
    return QString();
  };
  EXPECT_TRUE(WindowPage::until([&] { return !toldPush().isEmpty(); }, kPatience));

  // What is plugged in and may not be opened is told with the command that mends it.
  page.pressSeen("buttonLookAgain");
  EXPECT_TRUE(WindowPage::until(mends, kPatience));
  page.reveal(page.find<QPushButton>("buttonLookAgain"));
  page.picture("device-check");

  // A stylus that wants calibration: chosen, told so, calibrated step by step.
  page.window().findChild<QDockWidget*>("dockVirtualDesktop")->raise();
  page.choose("comboStylus", "Needy stylus");
  page.pressSeen("buttonCheckDevice");
  ASSERT_TRUE(page.says("labelCalibrated", "Not calibrated"));
  page.pressSeen("buttonCalibrateStylus");
  EXPECT_TRUE(page.text("labelCalibrationStep").contains("inkwell"));
  page.picture("device-check-calibration");
  page.pressSeen("buttonCalibrationDone");
  EXPECT_TRUE(page.text("labelCalibrationStep").contains("Pull it out"));
  EXPECT_TRUE(page.says("labelCalibrated", "in its inkwell"));
  page.pressSeen("buttonCalibrationDone");
  EXPECT_TRUE(page.says("labelCalibrated", "Calibrated."));
  EXPECT_TRUE(page.says("labelCalibrationSaid", "it is calibrated"));
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  QApplication::setPalette(hapticell::app::paletteOf(hapticell::app::darkTheme()));
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
