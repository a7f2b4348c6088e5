// SPDX-License-Identifier: Apache-2.0
// Glove, 3-D mouse, a second stylus and the device check in the window: real clicks, the real drivers, a haptic server
// of its own, fake devices (a pseudo-terminal, hidraw on a mocked system). Run under umockdev-wrapper.
//
// HAPTICELL_LOOK_FOLDER=folder saves pictures.
#include "tests/haptic/devices/spacemouse/mock_hidraw.h"  // First: what it includes has members called `signals`.

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QAbstractItemView>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTemporaryDir>
#include <fstream>

#include "app/host/module_loader.h"
#include "app/style/proxy_style.h"
#include "app/style/theme.h"
#include "mannequin/body_request_text.h"
#include "mannequin/free_hand.h"
#include "tests/app/cell_page.h"
#include "tests/haptic/devices/cyberglove/fake_glove.h"
#include "workcell/entity_source.h"

namespace hapticell::app {
namespace {

constexpr int kPatience = 60000;  // ms: states are waited for, no time is asserted.

int freePort() {
  const int probe = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool bound = bind(probe, any, length) == 0 && getsockname(probe, any, &length) == 0;
  close(probe);
  return bound ? ntohs(address.sin_port) : 0;
}

/// The settings of a user of the test's own: window, server and listing read the same file.
class OwnUser {
 public:
  explicit OwnUser(const std::string& glove_port) {
    qputenv("XDG_CONFIG_HOME", folder_.path().toLocal8Bit());
    QDir(folder_.path()).mkpath("hapticell");
    std::ofstream file(folder_.path().toStdString() + "/hapticell/hapticell.toml");
    file << "[server]\nport = " << freePort() << "\n[manipulation]\nrate_hz = 60.0\n";
    if (!glove_port.empty()) file << "[driver.cyberglove]\nport = \"" << glove_port << "\"\nmode = \"poll\"\n";
  }
  QString file(const char* name) const { return folder_.path() + "/hapticell/" + name; }

 private:
  QTemporaryDir folder_;
};

class DevicePage : public OwnUser, public CellPage {
 public:
  explicit DevicePage(const std::string& glove_port = {})
      : OwnUser(glove_port), CellPage(config::loadConfiguration().value()) {
    window().resize(1360, 900);
    settle();
  }
  void start() {
    window().loadModules(ModuleLoader::defaultFolders());
    ASSERT_TRUE(window().startModule("Virtual Desktop"));
    settle();
  }
  QString text(const char* label) {
    auto* found = window().findChild<QLabel*>(label);
    return found ? found->text() : QString();
  }
  testing::AssertionResult says(const char* label, const QString& part) {
    if (until([&] { return text(label).contains(part); }, kPatience)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << label << " says: " << text(label).toStdString();
  }
  bool lists(const char* name, const QString& part) {
    auto* combo = find<QComboBox>(name);
    return combo && until([&] { return combo->findText(part, Qt::MatchContains) >= 0; }, kPatience);
  }
  /// Opens the list by a click and takes the entry. By the keyboard: a list takes no click right after it has opened.
  void choose(const char* name, const QString& part) {
    ASSERT_TRUE(lists(name, part)) << name << ' ' << part.toStdString();
    auto* combo = find<QComboBox>(name);
    // A list that is filled anew while it opens closes again: then a user clicks once more.
    const auto opens = [&] {
      reveal(combo);
      click(combo, combo->rect().center());
      return until([&] { return combo->view()->isVisible(); }, kPatience / 20);
    };
    bool open = opens();
    for (int again = 0; again < 20 && !open; ++again) open = opens();
    ASSERT_TRUE(open);
    const QModelIndex entry = combo->model()->index(combo->findText(part, Qt::MatchContains), 0);
    combo->view()->setCurrentIndex(entry);
    QTest::keyClick(combo->view(), Qt::Key_Return);
    settle();
    ASSERT_TRUE(combo->currentText().contains(part)) << combo->currentText().toStdString();
  }
  void pressSeen(const char* name) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(until([&] { return button->isVisible() && button->isEnabled(); }, kPatience)) << name;
    reveal(button);
    click(button, button->rect().center());
  }
  void reveal(QWidget* widget) {
    for (QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
      if (auto* scroll = qobject_cast<QScrollArea*>(parent)) scroll->ensureWidgetVisible(widget);
    }
    settle();
  }
  const std::optional<manipulation::SceneSnapshot>& snapshot() { return window().viewport().scene().snapshot(); }
  std::optional<manipulation::SecondStylusState> second() { return snapshot() ? snapshot()->second : std::nullopt; }
  /// Waits until the stylus stands still; of two, both, beside each other.
  testing::AssertionResult stylusesRest(bool both = true) {
    std::uint64_t seen = 0;
    dvec3 last_first{0.0}, last_second{0.0};
    int rests = 0;
    const auto rest = [&] {
      if (!snapshot() || snapshot()->step == seen) return rests > 10;
      if (both && !(second() && second()->connected)) return false;
      seen = snapshot()->step;
      const dvec3 first_at = snapshot()->X_WStylus.p;
      const dvec3 second_at = both ? second()->X_WStylus.p : first_at + dvec3(1.0);
      const double moved = glm::length(first_at - last_first) + glm::length(second_at - last_second);
      last_first = first_at;
      last_second = second_at;
      rests = moved < 1e-4 && glm::length(first_at - second_at) > 0.01 ? rests + 1 : 0;
      return rests > 10;
    };
    return until(rest, kPatience) ? testing::AssertionSuccess() : testing::AssertionFailure() << "they do not rest";
  }
  /// The mouse takes the pen whose tip is there and drags it 40 pixels to the right.
  void dragPen(const dvec3& p_WTip) {
    ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    const auto tip = viewport.camera().project(p_WTip, size);
    ASSERT_TRUE(tip);
    const auto send = [&](QEvent::Type type, double right, Qt::MouseButtons held) {
      const QPointF place(tip->x + 2 + right, tip->y - 2);
      QMouseEvent event(type, place, viewport.mapToGlobal(place),
                        type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
      settle();
    };
    send(QEvent::MouseButtonPress, 0.0, Qt::LeftButton);
    for (int i = 1; i <= 5; ++i) send(QEvent::MouseMove, 8.0 * i, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, 40.0, Qt::NoButton);
  }
  /// Turns the view by so many pixels of a drag to the right.
  void lookRound(double pixels) {
    Camera camera = window().viewport().camera();
    camera.orbit({pixels, 0.0}, camera.target_W);
    window().viewport().setCamera(camera, false);
    settle();
  }
  void picture(const char* name) {
    const QString folder = qEnvironmentVariable("HAPTICELL_LOOK_FOLDER");
    if (folder.isEmpty()) return;
    settle();
    window().viewport().finishedPicture();
    settle();
    const QRect seen = window().frameGeometry();
    window()
        .screen()
        ->grabWindow(0, seen.x(), seen.y(), seen.width(), seen.height())
        .save(folder + '/' + name + ".png");
  }
};

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

constexpr int kFlat = 60, kFist = 190, kSpread = 130, kThumbUnder = 160;

bool connected(DevicePage& page) {
  const auto& snapshot = page.window().viewport().scene().snapshot();
  return snapshot && snapshot->connected;
}

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
  DevicePage page(glove.path());
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
  const auto held = [&] { return !page.document().find(bar)->attachment.to.empty(); };
  ASSERT_TRUE(WindowPage::until([&] { return connected(page); }, kPatience));
  holdHand(glove, kFist);
  const auto shaken = [&] {
    for (const auto& all : glove.vibrations()) {
      if (std::any_of(all.begin(), all.end() - 1, [](std::uint8_t each) { return each > 0; })) return true;
    }
    return false;
  };
  EXPECT_TRUE(WindowPage::until(shaken, kPatience)) << "no finger was shaken";
  EXPECT_FALSE(held());
  // As soon as it may be moved it goes with the hand that is closed on it.
  page.window().documentModel().execute(workcell::SetProperties{.id = bar, .locked = false});
  EXPECT_TRUE(WindowPage::until(held, kPatience)) << "the bar was not taken";
  page.picture("glove-grasp");
  const auto bend = [&] { return page.document().findByName("right hand")->joints[5]; };
  EXPECT_GT(bend(), 0.2) << "the index finger did not close";
  EXPECT_LT(bend(), 1.55) << "it went through the bar";
  holdHand(glove, kFlat);
  EXPECT_TRUE(WindowPage::until([&] { return !held(); }, kPatience)) << "the bar was not let go";
  EXPECT_TRUE(WindowPage::until([&] { return bend() < 0.1; }, kPatience));
  EXPECT_EQ(page.document().find(bar)->X_WE.p, grip) << "nothing moved it";

  // Pulled out and plugged in again.
  glove.unplug();
  EXPECT_TRUE(WindowPage::until([&] { return !page.text("labelGlove").contains("CyberGlove I"); }, kPatience));
}

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
  const auto heldNow = [&] { return page.window().viewport().scene().snapshot()->held; };
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
  const dvec3 start = page.second()->X_WStylus.p, first_at = page.snapshot()->X_WStylus.p;
  page.dragPen(start);
  EXPECT_TRUE(WindowPage::until([&] { return page.second()->X_WStylus.p.x > start.x + 0.01; }, kPatience));
  EXPECT_LT(glm::length(page.snapshot()->X_WStylus.p - first_at), 0.005);
  page.choose("comboSecondStylus", "None");
  EXPECT_TRUE(WindowPage::until([&] { return !page.second(); }, kPatience));
}

/// A stylus holds one part, a 3-D mouse as the second stylus another one, a glove closes a hand: all at once.
TEST(StylusGloveAndSpaceMouseInTheWindow, WorkAtOnce) {
  driver::FakeGlove glove;
  driver::MockHidraw mouse;
  DevicePage page(glove.path());
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
  ASSERT_TRUE(WindowPage::until([&] { return page.snapshot()->held == box; }, kPatience));
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
    return shown ? shown->joints[5] : page.document().find(hand_id)->joints[5];
  };
  EXPECT_TRUE(WindowPage::until([&] { return bend() > 0.8; }, kPatience)) << "the glove closes the hand";

  // And each moves it.
  ASSERT_TRUE(page.stylusesRest());
  page.dragPen(page.snapshot()->X_WStylus.p);
  const auto wayOf = [&](workcell::EntityId id, const dvec3& from) {
    const auto* shown = stateOf(id);
    return shown ? shown->X_WE.p.x - from.x : 0.0;
  };
  EXPECT_TRUE(WindowPage::until([&] { return wayOf(box, dvec3(0.0)) > 0.01; }, kPatience)) << "by the stylus";
  const auto pushed = [&] { return mouse.send({1, 0x5E, 1, 0, 0, 0, 0}), wayOf(part, tip) > 0.01; };
  EXPECT_TRUE(WindowPage::until(pushed, kPatience)) << "by the 3-D mouse";
  mouse.send({1, 0, 0, 0, 0, 0, 0});
  page.picture("three-devices");
  EXPECT_EQ(page.snapshot()->held, box);
  EXPECT_EQ(page.second()->held, part);
  EXPECT_GT(bend(), 0.8);
}

TEST(DeviceCheckInTheWindow, TellsTestsAndCalibrates) {
  driver::MockHidraw mouse;
  mouse.forbid();
  DevicePage page;
  page.start();
  page.pressSeen("buttonCheckDevice");
  ASSERT_TRUE(WindowPage::until([&] { return page.hasDock("dockDeviceCheck"); }, kPatience));
  EXPECT_TRUE(page.says("labelCalibrated", "simulated stylus needs none"));
  EXPECT_FALSE(page.text("labelWhyNoForce").isEmpty());

  // What the stylus reaches and presses is counted.
  ASSERT_TRUE(WindowPage::until([&] { return connected(page); }, kPatience));
  ASSERT_TRUE(page.stylusesRest(false));
  page.dragPen(page.snapshot()->X_WStylus.p);
  page.key(Qt::Key_B);
  EXPECT_TRUE(WindowPage::until([&] { return page.snapshot()->X_DS.p.x > 0.03; }, kPatience));

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
