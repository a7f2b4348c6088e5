// SPDX-License-Identifier: Apache-2.0
// A window in which nothing changes paints nothing: counted, not timed.
#include <QElapsedTimer>
#include <QPaintEvent>
#include <QTest>
#include <QTimer>
#include <map>

#include "app/shell/status_line.h"
#include "app/style/steady_number.h"
#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/server_first.h"

namespace hapticell::app {
namespace {

constexpr int kRestPatience = 120000;  // ms: a picture at rest takes its time where the renderer is slow.

/// How often each widget was painted since it was made.
class PaintCount : public QObject {
 public:
  PaintCount() { qApp->installEventFilter(this); }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count_[nameOf(watched)];
    return false;
  }
  /// "collisions 3, viewport 1".
  std::string text() const {
    std::string text;
    for (const auto& [name, times] : count_) text += (text.empty() ? "" : ", ") + name + ' ' + std::to_string(times);
    return text;
  }
  int times(const std::string& name) const {
    const auto found = count_.find(name);
    return found == count_.end() ? 0 : found->second;
  }

 private:
  static std::string nameOf(const QObject* object) {
    const QString name = object->objectName();
    if (!name.isEmpty() && !name.startsWith("qt_")) return name.toStdString();
    return object->metaObject()->className() + std::string(" in ") +
           (object->parent() ? nameOf(object->parent()) : std::string("nothing"));
  }
  std::map<std::string, int> count_;
};

/// A window that may come to rest.
struct IdlePage : CellPage {
  explicit IdlePage(const config::Configuration& configuration = {}) : CellPage(configuration) {
    window().resize(1000, 700);
  }
  /// A box on a table, one of them selected, so that all panels have something to tell.
  void addParts() {
    addSolid("table", geometry::makeBox({0.6, 0.6, 0.1}), Pose::translation({0, 0, -0.05}));
    select(addSolid("box", geometry::makeBox(dvec3(0.06)), Pose::translation({0, 0, 0.2})));
    lookAt({0, 0, 0}, 0.4);
  }
  bool rests() {
    return until([this] { return window().viewport().isFinished(); }, kRestPatience);
  }
  /// Goes on until the panels were told of their numbers so many times.
  void refreshes(int times) {
    QTimer panels;  // As theirs.
    int told = 0;
    QObject::connect(&panels, &QTimer::timeout, [&told] { ++told; });
    panels.start(100);
    until([&] { return told >= times; }, kRestPatience);
  }
  /// What is painted once it rests. What is worked out in threads may still come in: it rests once a round of refreshes
  /// paints nothing.
  std::string paintedAtRest() {
    std::string painted_last;
    for (int round = 0; round < 20; ++round) {
      const PaintCount painted;
      refreshes(16);
      painted_last = painted.text();
      if (painted_last.empty()) break;
    }
    return painted_last;
  }
};

/// Connected to a haptic server, the forces off and nobody at the stylus, with all that is to be seen at a start.
struct ConnectedIdlePage : ServerFirst, IdlePage {
  ConnectedIdlePage() : IdlePage(on()) {
    window().resize(1400, 880);
    window().loadModules(ModuleLoader::defaultFolders());
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    window().restoreLayout();
    settle();
  }
  bool rests() {
    const auto idle = [this] {
      return window().snapshot() && window().snapshot()->stylus.connected && window().snapshot()->idle;
    };
    return until(idle, kRestPatience) && IdlePage::rests();
  }
};

TEST(IdleWindow, PaintsNothing) {
  IdlePage page;
  page.setFinePictures();
  page.addParts();
  ASSERT_TRUE(page.rests());
  EXPECT_EQ(page.paintedAtRest(), "");
}

TEST(IdleWindow, PaintsNothingConnectedWithAnEmptyCell) {
  ConnectedIdlePage page;
  ASSERT_TRUE(page.rests());
  EXPECT_EQ(page.paintedAtRest(), "");
}

TEST(IdleWindow, PaintsNothingConnectedWithPartsAndWakesWithTheHand) {
  ConnectedIdlePage page;
  page.addParts();
  ASSERT_TRUE(page.rests());
  EXPECT_EQ(page.paintedAtRest(), "");
  const PaintCount painted;
  page.trigger("actionForcesOn");
  EXPECT_TRUE(page.until([&] { return !page.window().snapshot()->idle; }, kRestPatience));
  EXPECT_GT(painted.times("statusLine"), 0) << "it says that it works again";
}

TEST(StatusLine, RatesThatDanceArePaintedNowAndThenOnly) {
  StatusLine line;
  line.resize(1200, 26);
  line.setVisible(true);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&line));
  const PaintCount painted;
  QElapsedTimer clock;
  clock.start();
  StatusLine::Rates rates;
  rates.haptic_hz = rates.window_hz = 60.0;
  for (int i = 0; i < 60; ++i) {
    rates.collision_hz = i % 2 == 0 ? 500.0 : 900.0;
    line.setRates(rates);
    QTest::qWait(10);
  }
  EXPECT_GT(painted.times("statusLine"), 0);
  // Twice a second, and what the window system asks for at its beginning; a machine that stalls takes more time.
  EXPECT_LT(painted.times("statusLine"), 5 + clock.elapsed() / 500) << "they differ by far 60 times";
}

TEST(SteadyNumber, StaysWhileItDiffersLittleAndNeverHidesAZero) {
  SteadyNumber rate(0.05);
  EXPECT_TRUE(rate.take(1000.0));
  EXPECT_FALSE(rate.take(960.0));
  EXPECT_FALSE(rate.take(1040.0));
  EXPECT_EQ(rate.shown(), 1000.0);
  EXPECT_TRUE(rate.take(940.0)) << "against what is shown: slow changes add up";
  EXPECT_TRUE(rate.take(0.0));
  EXPECT_FALSE(rate.take(0.0));
  SteadyNumber late(0.3, 0.1);
  EXPECT_TRUE(late.take(0.02)) << "leaves zero";
  EXPECT_FALSE(late.take(0.11));
  EXPECT_TRUE(late.take(0.13));
}

}  // namespace
}  // namespace hapticell::app
