// SPDX-License-Identifier: Apache-2.0
// A window in which nothing changes paints nothing: counted, not timed.
#include <QPaintEvent>
#include <QTimer>
#include <map>

#include "app/host/module_loader.h"
#include "app/style/steady_number.h"
#include "tests/app/cell_page.h"

namespace hapticell::app {
namespace {

constexpr int kPatience = 120000;  // ms: a picture at rest takes its time where the renderer is slow.

/// How often each widget was painted since it was made.
class PaintCount : public QObject {
 public:
  PaintCount() { qApp->installEventFilter(this); }
  bool eventFilter(QObject* watched, QEvent* event) override {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Paint || !widget) return false;
    // With a part that is transparent what lies behind it is painted too, there.
    const QRegion painted =
        static_cast<QPaintEvent*>(event)->region().translated(widget->mapTo(widget->window(), QPoint()));
    if (!painted.subtracted(allowed_).isEmpty()) ++count_[nameOf(watched)];
    return false;
  }
  /// Paints within these widgets do not count.
  template <class Widget>
  void allow(const QList<Widget*>& widgets) {
    for (const QWidget* widget : widgets) allowed_ += QRect(widget->mapTo(widget->window(), QPoint()), widget->size());
  }
  /// "collisions 3, viewport 1".
  std::string text() const {
    std::string text;
    for (const auto& [name, times] : count_) text += (text.empty() ? "" : ", ") + name + ' ' + std::to_string(times);
    return text;
  }

 private:
  static std::string nameOf(const QObject* object) {
    const QString name = object->objectName();
    if (!name.isEmpty() && !name.startsWith("qt_")) return name.toStdString();
    return object->metaObject()->className() + std::string(" in ") +
           (object->parent() ? nameOf(object->parent()) : std::string("nothing"));
  }
  std::map<std::string, int> count_;
  QRegion allowed_;
};

/// A box on a table, one of them selected, so that all panels have something to tell.
struct IdlePage : CellPage {
  explicit IdlePage(const config::Configuration& configuration = {}) : CellPage(configuration) {
    window().resize(1000, 700);
    addSolid("table", geometry::makeBox({0.6, 0.6, 0.1}), Pose::translation({0, 0, -0.05}));
    select(addSolid("box", geometry::makeBox(dvec3(0.06)), Pose::translation({0, 0, 0.2})));
    lookAt({0, 0, 0}, 0.4);
  }
  bool rests() {
    return until([this] { return window().viewport().isFinished(); }, kPatience);
  }
  /// Goes on until the panels were told of their numbers so many times.
  void refreshes(int times) {
    QTimer panels;  // As theirs.
    int told = 0;
    QObject::connect(&panels, &QTimer::timeout, [&told] { ++told; });
    panels.start(100);
    until([&] { return told >= times; }, kPatience);
  }
};

TEST(IdleWindow, PaintsNothing) {
  IdlePage page;
  ASSERT_TRUE(page.rests());
  page.settle();
  const PaintCount painted;
  page.refreshes(8);
  EXPECT_EQ(painted.text(), "");
}

TEST(IdleWindow, WithForcesOnAndAHandAtRestItPaintsTheRatesAtMost) {
  config::Configuration configuration;
  configuration.server.port = 47481;  // Not one that a user's server listens on.
  configuration.gui.sound = false;
  IdlePage page(configuration);
  page.window().loadModules(ModuleLoader::defaultFolders());
  ASSERT_TRUE(page.window().startModule("Virtual Desktop"));
  const auto now = [&page] { return page.window().snapshot(); };
  if (!page.until([&] { return now() && now()->connected; }, kPatience))
    GTEST_SKIP() << "no haptic server can be started here";
  page.trigger("actionForcesOn");
  ASSERT_TRUE(page.until([&] { return now()->forces_on && now()->force_ramp >= 1.0; }, kPatience));
  ASSERT_TRUE(page.rests());
  page.refreshes(3);
  ASSERT_TRUE(page.rests());
  PaintCount painted;
  // How fast the machine is may be told anew.
  painted.allow(page.window().findChildren<QLabel*>("labelRate"));
  painted.allow(page.window().findChildren<QWidget*>("statusLine"));
  page.refreshes(10);
  EXPECT_EQ(painted.text(), "");
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
