// SPDX-License-Identifier: Apache-2.0
// The stylus held by the mouse, against a haptic server of the test's own: scales, axes, what happens on contact, drift
// at the edge of the workspace, the live strip. Nothing here depends on how fast the machine is: states are waited for.
#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <QPushButton>
#include <QWheelEvent>

#include "app/controls/strip_chart.h"
#include "app/panels/collisions/contact_log_model.h"
#include "app/viewport/scene/strip_text.h"
#include "haptic/client/tcp_link.h"
#include "manipulation/holding/motion_mapping.h"
#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/control_places.h"
#include "tests/app/pages/server_first.h"

namespace hapticell::app {
namespace {

constexpr int kPatience = 60000;  // ms.
constexpr double kHalf = 0.03;    // m of the box that is held.

/// A box over a table, the Virtual Desktop connected, the stylus following the mouse.
class HandPage : public ServerFirst, public CellPage {
 public:
  explicit HandPage(const config::Configuration& configuration = {}) : CellPage(on(configuration)) {
    window().loadModules(ModuleLoader::defaultFolders());
    table = addSolid("table", geometry::makeBox({0.6, 0.6, 0.1}), Pose::translation({0, 0, -0.05}));
    box = addSolid("box", geometry::makeBox(dvec3(2.0 * kHalf)), Pose::translation({0, 0, 0.06}));
    lookAt({0, 0, 0.05}, 0.15);
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    select(box);
    auto* entity = find<QComboBox>("comboEntity");
    entity->setCurrentIndex(entity->findText("box"));
    emit entity->activated(entity->currentIndex());
    EXPECT_TRUE(
        until([this] { return window().snapshot() && now().stylus.connected && now().stylus.device_edge_m > 0.0; },
              kPatience));
  }
  const manipulation::SceneSnapshot& now() { return *window().snapshot(); }

  /// Takes the box: the stylus follows the mouse from the viewport's middle, its button is the mouse's left one.
  void take() {
    place_ = QPointF(0.5 * window().viewport().width(), 0.5 * window().viewport().height());
    send(QEvent::MouseMove, Qt::NoButton, Qt::NoButton);
    trigger("actionFollow");
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    EXPECT_TRUE(until([this] { return now().stylus.held == box; }, kPatience));
    send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
    EXPECT_TRUE(comes([this] { return glm::length(hand()) < 5e-4; })) << "where the mouse holds it";
  }
  /// Moves the mouse by so many pixels, a few at a time.
  void drag(double right, double down) {
    const int steps = static_cast<int>(std::ceil(std::max(std::abs(right), std::abs(down)) / 10.0));
    for (int i = 0; i < steps; ++i) {
      place_ += QPointF(right / steps, down / steps);
      send(QEvent::MouseMove, Qt::NoButton, Qt::NoButton);
    }
  }
  void zoom(int steps) {
    ViewportWidget& viewport = window().viewport();
    QWheelEvent event(place_, viewport.mapToGlobal(place_), QPoint(), QPoint(0, 120 * steps), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&viewport, &event);
    settle();
  }
  dvec3 at() {
    for (const auto& entity : now().entities)
      if (entity.id == box) return entity.X_WE.p;
    return document().find(box)->X_WE.p;
  }
  const dvec3& hand() { return now().stylus.X_DS.p; }
  /// Drags by so many metres of the cell and waits until the hand rests as far off as that is at the scale of now.
  void dragThere(double right, double down) {
    const dvec3 from = hand();
    const double way = std::hypot(right, down) / now().stylus.motion_scale;
    drag(right / metresPerPixel(), down / metresPerPixel());
    const double near = std::max(7e-4, 0.03 * way);
    EXPECT_TRUE(comes([&] { return std::abs(glm::distance(hand(), from) - way) < near; }))
        << way << ", gone " << glm::distance(hand(), from);
  }
  /// Waits until the hand, which swings about where it is held, rests where `there` holds.
  template <typename There>
  bool comes(There&& there) {
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < kPatience;) {
      const dvec3 before = hand();
      const std::uint64_t tick = ticks();
      if (!until([&] { return ticks() >= tick + kSwing; }, kPatience)) return false;
      const std::uint64_t step = now().step;
      if (!until([&] { return now().step >= step + 2; }, kPatience)) return false;
      if (glm::distance(hand(), before) < 5e-5 && there()) return true;
    }
    return false;
  }
  /// Where the box goes with `axis` as the only free one and the mouse going right and down.
  dvec3 wayAlong(const char* axis) {
    for (const char* name : {"freeX", "freeY", "freeZ", "freeA", "freeB", "freeC"}) {
      auto* toggle = find<QAbstractButton>(name);
      if (toggle->isChecked() != (std::string(name) == axis)) press(name);
    }
    const dvec3 before = at();
    dragThere(0.03, 0.018);
    const dvec3 way = at() - before;
    dragThere(-0.03, -0.018);
    return way;
  }
  double metresPerPixel() {
    const ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    return viewport.camera().metresPerPixel(viewport.camera().target_W, size);
  }
  workcell::EntityId table = 0, box = 0;

 private:
  /// Of the force loop, told about ten times a second.
  std::uint64_t ticks() {
    server.loop.updateReport();
    return server.loop.report().ticks;
  }
  static constexpr std::uint64_t kSwing = 200;  // ms, longer than one swing of the hand on its spring.
  void send(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held) {
    ViewportWidget& viewport = window().viewport();
    QMouseEvent event(type, place_, viewport.mapToGlobal(place_), button, held, Qt::NoModifier);
    QApplication::sendEvent(&viewport, &event);
    QApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  QPointF place_{100, 100};
};

TEST(FeelWindow, FourScalesMoveTheBoxSoFarAsTheyShow) {
  HandPage page;
  page.take();
  const config::Configuration::Scale scales;
  const double shown[]{scales.rough, scales.medium, scales.fine};
  for (const int level : {0, 1, 2, 3}) {
    page.chooseSegment("segmentsScale", level);
    const double wanted = level < 3 ? shown[level] : 0.0;
    ASSERT_TRUE(WindowPage::until(
        [&] {
          return level < 3 ? page.now().stylus.motion_scale == wanted : page.now().stylus.motion_scale != shown[2];
        },
        kPatience));
    const dvec3 box = page.at(), hand = page.hand();
    // As much of the hand at every scale: the pen keeps under the mouse.
    const double way = 0.006 * page.now().stylus.motion_scale;
    page.dragThere(way, 0);
    const double moved = glm::distance(page.at(), box), by = glm::distance(page.hand(), hand);
    EXPECT_NEAR(by, 0.006, 0.001) << level;
    EXPECT_NEAR(moved / by, page.now().stylus.motion_scale, 0.03 * page.now().stylus.motion_scale) << level;
    page.dragThere(-way, 0);
  }
}

TEST(FeelWindow, TheScaleOfTheScreenGoesWithTheZoom) {
  HandPage page;
  page.chooseSegment("segmentsScale", 3);
  const haptic::DeviceDescription device = haptic::describe(page.server.device);
  const auto shows = [&] {
    const double wanted = manipulation::screenScale(page.metresPerPixel() * page.window().viewport().width(),
                                                    device.workspace_max.x - device.workspace_min.x);
    return std::abs(page.now().stylus.motion_scale / wanted - 1.0) < 1e-6;
  };
  ASSERT_TRUE(WindowPage::until(shows, kPatience));
  const double wide = page.now().stylus.motion_scale;
  const auto* note = page.find<QLabel>("labelScale");
  const QString said = note->text();
  page.zoom(4);
  ASSERT_TRUE(WindowPage::until(shows, kPatience));
  EXPECT_LT(page.now().stylus.motion_scale, 0.75 * wide);
  EXPECT_TRUE(WindowPage::until([&] { return note->text() != said; }, kPatience));
}

TEST(FeelWindow, AxesAreOfTheScreenTheCellOrAFrame) {
  HandPage page;
  const Pose X_WF{{0.1, 0.2, 0.0}, quaternionFromRotationVector({0.0, 0.0, 0.9})};
  page.addSolid("mark", geometry::makeBox(dvec3(0.01)), X_WF);
  page.take();
  const dvec3 right_W = page.window().viewport().camera().right_W();
  const auto isAlong = [](const dvec3& way, const dvec3& axis) {
    EXPECT_GT(glm::length(way), 2e-3);
    EXPECT_LT(glm::length(glm::cross(way, axis)), 0.05 * glm::length(way));
  };
  page.chooseSegment("segmentsAxes", 0);
  isAlong(page.wayAlong("freeX"), right_W);
  page.chooseSegment("segmentsAxes", 1);
  isAlong(page.wayAlong("freeX"), {1.0, 0.0, 0.0});
  page.chooseSegment("segmentsAxes", 2);
  auto* frame = page.find<QComboBox>("comboAxesFrame");
  frame->setCurrentIndex(frame->findText("mark"));
  emit frame->activated(frame->currentIndex());
  isAlong(page.wayAlong("freeX"), X_WF.rotate({1.0, 0.0, 0.0}));
  EXPECT_GT(std::abs(right_W.y), 0.1) << "else screen and cell are the same here";
}

/// The box pushed against the table by the mouse: where it began, where it would be without the table, where it is.
struct Pushed {
  dvec3 start, free, at;
  double onTable() const { return (start.z - (kHalf + 0.001)) / (start.z - free.z); }
};

Pushed push(HandPage& page, int on_contact) {
  page.chooseSegment("segmentsOnContact", on_contact);
  page.take();
  Pushed pushed;
  pushed.start = page.at();
  page.dragThere(0, 0.055);
  pushed.free = pushed.start - 0.055 * page.window().viewport().camera().up_W();
  pushed.at = page.at();
  EXPECT_LT(pushed.free.z, 0.02) << "it would be in the table";
  return pushed;
}

TEST(FeelWindow, StopLeavesItWhereItTouchedAndSaysSo) {
  HandPage page;
  const Pushed pushed = push(page, 0);
  const dvec3 touched = pushed.start + pushed.onTable() * (pushed.free - pushed.start);
  EXPECT_LT(glm::distance(pushed.at, touched), 2e-3);
  EXPECT_TRUE(page.now().stopped);
  EXPECT_EQ(stripCells(page.now(), {})[3].value, "Stopped");
  ASSERT_FALSE(page.now().pairs.empty());
  EXPECT_TRUE(page.now().pairs.front().contact) << "what colours both and is heard";
  page.chooseSegment("segmentsCollisions", 2);
  auto* log = page.find<QTableView>("tableLog");
  EXPECT_TRUE(WindowPage::until([&] { return log->model()->rowCount() > 0; }, kPatience));
  const auto event = [&](int row) { return log->model()->index(row, ContactLogModel::kEvent).data().toString(); };
  bool began = false;
  for (int row = 0; row < log->model()->rowCount(); ++row) began = began || event(row) == "Contact began";
  EXPECT_TRUE(began);
}

TEST(FeelWindow, SlideFollowsTheBoundaryWithTheHand) {
  HandPage page;
  const Pushed pushed = push(page, 1);
  EXPECT_FALSE(page.now().stopped);
  EXPECT_NEAR(pushed.at.z, kHalf + 0.001, 2e-4) << "on the safety distance";
  EXPECT_NEAR(pushed.at.y, pushed.free.y, 3e-3) << "all of the way that the table leaves free";
}

TEST(FeelWindow, PassGoesThroughAndOnlyShows) {
  HandPage page;
  const Pushed pushed = push(page, 2);
  EXPECT_LT(glm::distance(pushed.at, pushed.free), 3e-3);
  EXPECT_TRUE(
      WindowPage::until([&] { return !page.now().pairs.empty() && page.now().pairs.front().contact; }, kPatience));
  EXPECT_FALSE(page.now().stopped);
}

TEST(FeelWindow, NoControlOfThePanelMovesWhileItIsUsed) {
  HandPage page;
  page.showDock("dockVirtualDesktop");
  const ControlPlaces before(*page.find<QDockWidget>("dockVirtualDesktop"));
  EXPECT_GT(before.count(), 20u);
  page.trigger("actionForcesOn");
  ASSERT_TRUE(WindowPage::until([&] { return page.now().stylus.forces_on; }, kPatience));
  WindowPage::settle();
  EXPECT_EQ(before.moved(), "") << "forces on";
  // Not push(): with forces on the table holds the hand back, so that it does not come where the mouse is.
  page.chooseSegment("segmentsOnContact", 1);
  page.take();
  page.drag(0, 0.055 / page.metresPerPixel());
  const auto touches = [&] { return !page.now().pairs.empty() && page.now().pairs.front().contact; };
  ASSERT_TRUE(WindowPage::until(touches, kPatience));
  WindowPage::settle();
  EXPECT_EQ(before.moved(), "") << "in contact";
  page.key(Qt::Key_Escape);
  ASSERT_TRUE(WindowPage::until([&] { return !page.now().stylus.forces_on; }, kPatience));
  WindowPage::settle();
  EXPECT_EQ(before.moved(), "") << "forces off";
  auto* connect = page.find<QAbstractButton>("buttonConnect");
  const QString connected = connect->text();
  page.press("buttonConnect");
  ASSERT_TRUE(WindowPage::until([&] { return connect->text() != connected; }, kPatience));
  WindowPage::settle();
  EXPECT_EQ(before.moved(), "") << "not connected";
}

TEST(FeelWindow, TheClutchMovesTheHandAlone) {
  HandPage page;
  page.take();
  const dvec3 box = page.at();
  page.activate();
  QTest::keyPress(&page.window().viewport(), Qt::Key_Space);
  ASSERT_TRUE(WindowPage::until([&] { return page.now().clutched; }, kPatience));
  EXPECT_EQ(stripCells(page.now(), {})[4].value, "Clutch");
  page.dragThere(0.03, 0);
  EXPECT_LT(glm::distance(page.at(), box), 1e-4);
  QTest::keyRelease(&page.window().viewport(), Qt::Key_Space);
  ASSERT_TRUE(WindowPage::until([&] { return !page.now().clutched; }, kPatience));
  page.dragThere(-0.03, 0);
  EXPECT_GT(glm::distance(page.at(), box), 5e-3) << "from the new origin";
}

TEST(FeelWindow, AtTheEdgeOfTheWorkspaceTheBoxGoesOn) {
  config::Configuration configuration;
  configuration.manipulation.edge_drift = 0.1;
  HandPage page(configuration);
  page.take();
  const dvec3 start = page.at();
  const dvec3 right_W = page.window().viewport().camera().right_W();
  const auto way = [&] { return glm::dot(page.at() - start, right_W); };
  const double edge = haptic::describe(page.server.device).workspace_max.x;
  page.drag(1.2 * edge / page.metresPerPixel(), 0);
  ASSERT_TRUE(WindowPage::until([&] { return page.now().stylus.device_edge_m < 0.003; }, kPatience));
  EXPECT_TRUE(WindowPage::until([&] { return way() > 1.5 * edge; }, kPatience)) << "farther than a hand can reach";
  page.drag(-0.6 * edge / page.metresPerPixel(), 0);
  ASSERT_TRUE(page.comes([&] { return std::abs(page.hand().x - 0.45 * edge) < 1.5e-3; }));
  const double back = way();
  const std::uint64_t step = page.now().step;
  ASSERT_TRUE(WindowPage::until([&] { return page.now().step > step + 200; }, kPatience));
  EXPECT_NEAR(way(), back, 2e-3) << "inside the workspace nothing goes by itself";
}

TEST(FeelWindow, TheLiveStripShowsForceGapAndRatesWhilePressing) {
  HandPage page;
  page.showDock("dockCurves");
  page.take();
  page.trigger("actionForcesOn");
  ASSERT_TRUE(
      WindowPage::until([&] { return page.now().stylus.forces_on && page.now().stylus.force_ramp > 0.99; }, kPatience));
  page.drag(0, 0.05 / page.metresPerPixel());
  ASSERT_TRUE(WindowPage::until([&] { return page.now().stylus.force_n > 0.5; }, kPatience));
  EXPECT_EQ(stripCells(page.now(), {})[1].mark, Mark::kContact);
  auto* chart = page.window().findChild<StripChart*>("stripChart");
  ASSERT_NE(chart, nullptr);
  EXPECT_TRUE(WindowPage::until(
      [&] { return !chart->history().samples().empty() && chart->history().samples().back().force_n > 0.5; },
      kPatience));
  EXPECT_GT(chart->history().samples().back().haptic_hz, 0.0);
  const auto& samples = chart->history().samples();
  EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [](const StripSample& s) { return s.gap_m > 0.005; }));
  page.key(Qt::Key_Escape);
  EXPECT_TRUE(WindowPage::until([&] { return !page.now().stylus.forces_on; }, kPatience));
}

/// The window measures how long after it is felt a contact is on the screen, and the device check tells it.
TEST(FeelWindow, AContactThatIsFeltIsSeenAndTheDelayIsTold) {
  HandPage page;
  page.take();
  page.trigger("actionForcesOn");
  ASSERT_TRUE(WindowPage::until([&] { return page.now().stylus.force_ramp > 0.99; }, kPatience));
  EXPECT_EQ(page.window().viewport().touchFigures().contacts, 0u);
  EXPECT_EQ(page.now().felt_ns, 0);
  // Several, so that the figures say something of the machine: their median and worst stand in the test's report.
  constexpr std::size_t kContacts = 8;
  for (std::size_t contact = 0; contact < kContacts; ++contact) {
    page.drag(0.0, 0.035 / page.metresPerPixel());
    ASSERT_TRUE(
        WindowPage::until([&] { return page.window().viewport().touchFigures().contacts > contact; }, kPatience));
    page.drag(0.0, -0.035 / page.metresPerPixel());
    const auto touches = [&] {
      return std::any_of(page.now().pairs.begin(), page.now().pairs.end(),
                         [](const auto& pair) { return pair.contact; });
    };
    ASSERT_TRUE(WindowPage::until([&] { return !touches(); }, kPatience));
  }
  const TouchMeter::Figures seen = page.window().viewport().touchFigures();
  EXPECT_GT(page.now().felt_ns, 0);
  EXPECT_GT(seen.last_s, 0.0);
  EXPECT_LE(seen.last_s, seen.worst_s);
  page.press("buttonCheckDevice");
  auto* checks = page.find<QWidget>("checkRows");
  EXPECT_TRUE(WindowPage::until(
      [&] { return checks->accessibleDescription().contains(QStringLiteral("delay: median")); }, kPatience))
      << checks->accessibleDescription().toStdString();
  testing::Test::RecordProperty("median_ms", static_cast<int>(1e3 * seen.median_s));
  testing::Test::RecordProperty("worst_ms", static_cast<int>(1e3 * seen.worst_s));
}

/// A cell whose server has been taken by another window.
struct WatchingPage : ServerFirst, CellPage {
  WatchingPage() : CellPage(on()), other(optionsOf(server)) {
    EXPECT_TRUE(until([this] { return other.linkState() == haptic::LinkState::kConnected; }, kPatience));
    window().loadModules(ModuleLoader::defaultFolders());
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    EXPECT_TRUE(until([this] { return button().isVisible() && button().text() == "Take control"; }, kPatience));
  }
  static haptic::TcpLinkOptions optionsOf(const haptic::LiveServer& server) {
    haptic::TcpLinkOptions options;
    options.port = static_cast<std::uint16_t>(server.port());
    options.program = "Other window";
    return options;
  }
  QPushButton& button() { return *find<QPushButton>("buttonFix"); }
  haptic::TcpLink other;
};

TEST(SecondWindow, WatchesAndTakesTheStylusOnlyWhenItsUserSaysSo) {
  WatchingPage page;
  const StatusLine& status = page.window().statusLine();
  EXPECT_TRUE(WindowPage::until([&] { return status.device().contains("another window"); }, kPatience))
      << status.device().toStdString();
  EXPECT_FALSE(status.deviceWorks()) << "no tick";
  EXPECT_FALSE(page.find<QAbstractButton>("switchForces")->isEnabled());
  // Longer than a silent controller is waited for.
  QTest::qWait(1500);
  EXPECT_EQ(page.other.linkState(), haptic::LinkState::kConnected);
  EXPECT_EQ(page.other.grantedKind(), haptic::ClientKind::kController);
  page.press("buttonFix");
  EXPECT_TRUE(WindowPage::until([&] { return status.deviceWorks(); }, kPatience)) << status.device().toStdString();
  EXPECT_TRUE(WindowPage::until([&] { return page.other.linkState() != haptic::LinkState::kConnected; }, kPatience));
}

TEST(StripChart, DrawsTheRatesAsLines) {
  StripChart chart;
  chart.resize(700, 200);
  chart.show();
  manipulation::SceneSnapshot now;
  for (int i = 0; i <= 200; ++i) {
    now.time_s = 0.1 * i;
    now.server.rate_hz = 1000.0, now.rate_manipulation_hz = 400.0;
    chart.take(now);
  }
  const QImage picture = chart.grab().toImage();
  // Two lines in the strip at the bottom, over its whole width: lighter than the field's ground.
  int lit = 0, both = 0;
  for (int x = 220; x < 620; ++x) {
    int lines = 0;
    bool was = false;
    for (int y = 152; y < 184; ++y) {
      const bool is = picture.pixelColor(x, y).lightness() > 90;
      lines += is && !was;
      was = is;
    }
    lit += lines >= 1;
    both += lines >= 2;
  }
  EXPECT_GT(lit, 380);
  EXPECT_GT(both, 150) << "one is dashed";
}

TEST(FeelWindow, ForceClassAndMaterialAreChosenInTheEntitysDialog) {
  HandPage page;
  page.chooseSegment("segmentsForce", 2);
  EXPECT_EQ(page.document().find(page.box)->contact.force_class, workcell::ForceClass::kDynamics);
  auto* material = page.find<QComboBox>("comboMaterial");
  material->setFocus();
  page.pointAt(*material);
  QTest::keyClicks(material, "Foam");
  EXPECT_EQ(page.document().find(page.box)->contact.material, "steel") << "typing only searches";
  QTest::keyClick(material->view(), Qt::Key_Return);
  EXPECT_EQ(page.document().find(page.box)->contact.material, "foam");
  page.showDock("dockSolid");
  EXPECT_EQ(page.find<QComboBox>("comboSolidMaterial")->currentData().toString(), "foam") << "one entity, one material";
  page.trigger("actionUndo");
  EXPECT_EQ(page.document().find(page.box)->contact.material, "steel");
  EXPECT_EQ(material->currentData().toString(), "steel");
}

}  // namespace
}  // namespace hapticell::app
