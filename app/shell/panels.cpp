// SPDX-License-Identifier: Apache-2.0
#include "app/shell/panels.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTimer>

#include "app/access/access_docks.h"
#include "app/agents/agents_dock.h"
#include "app/console/console_dock.h"
#include "app/controls/refresh_timer.h"
#include "app/controls/strip_chart.h"
#include "app/edit/edit_docks.h"
#include "app/ergonomics/ergonomics_docks.h"
#include "app/guides/guides_panel.h"
#include "app/host/host.h"
#include "app/host/stylus_use.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/tabbed_docks.h"
#include "app/mannequin/mannequin_docks.h"
#include "app/panels/cell/entity_menu.h"
#include "app/panels/cell/history_panel.h"
#include "app/panels/cell/messages_panel.h"
#include "app/panels/cell/properties_panel.h"
#include "app/panels/cell/scene_menu.h"
#include "app/panels/cell/solid_panel.h"
#include "app/panels/cell/workcell_panel.h"
#include "app/panels/collisions/collisions_panel.h"
#include "app/live/live_dock.h"
#include "app/planning/planning_docks.h"
#include "app/robot/robot_docks.h"
#include "app/ros2/ros2_dock.h"
#include "app/studies/studies_docks.h"
#include "app/style/dock_title_bar.h"
#include "app/trajectory/docks/trajectory_docks.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

/// The curves follow the hand as fast as a picture; where nothing moves they are looked at as seldom as the loop tells.
void followWith(StripChart* chart, Host& host) {
  // ms: curves move smoothly at 30 Hz, and ten times a second where nothing moves. Half: twice the work; twice: curves
  // jerk.
  constexpr int kMovingMilliseconds = 33, kRestMilliseconds = 100;
  auto* timer = new QTimer(chart);
  QObject::connect(timer, &QTimer::timeout, chart, [&host, chart, timer] {
    chart->take(host.snapshot());
    const int wanted = host.snapshot() && !host.snapshot()->idle ? kMovingMilliseconds : kRestMilliseconds;
    if (timer->interval() != wanted) timer->setInterval(wanted);
  });
  timer->start(kRestMilliseconds);
}

/// What went wrong, or waits for an answer, is to be read whole; what is being moved by hand is not to lose its panel.
void showMessagesToRead(Host& host, QDockWidget* messages) {
  QObject::connect(&host.messages(), &MessageLog::told, messages, [&host, messages](const Message& message) {
    const bool to_read = message.severity == Severity::kProblem || !message.actions.empty();
    if (to_read && !messages->isHidden() && !isStylusInUse(host)) bringToFront(messages);
  });
}

void addBottomDocks(Host& host) {
  auto* chart = new StripChart;
  chart->setLevels(host.configuration().manipulation.near_miss, 0.0);
  auto* collisions = new CollisionsPanel(host);
  QDockWidget* curves_dock = makeDock("dockCurves", QObject::tr("Curves"), chart);
  QDockWidget* collisions_dock = makeDock("dockCollisions", tabTextWithCount(QObject::tr("Collisions"), 0), collisions);
  QDockWidget* messages_dock = makeDock("dockMessages", QObject::tr("Messages"), new MessagesPanel(host.messages()));
  QDockWidget* history_dock = makeDock("dockHistory", QObject::tr("History"), new HistoryPanel(host.documentModel()));
  QDockWidget* trajectory_dock = addTrajectoryDocks(host);
  const std::vector<QDockWidget*> docks{trajectory_dock, curves_dock, collisions_dock, messages_dock, history_dock};
  for (QDockWidget* dock : docks) {
    dock->widget()->setMinimumSize(480, 150);  // Their rows may be squeezed a little: the window fits a small screen.
    host.addDock(dock, Qt::BottomDockWidgetArea, dock == docks.front() ? nullptr : docks.front());
  }
  const auto name = [collisions_dock](int count) {
    collisions_dock->setWindowTitle(tabTextWithCount(QObject::tr("Collisions"), count));
    collisions_dock->toggleViewAction()->setText(QObject::tr("Collisions"));
  };
  name(0);
  QObject::connect(collisions, &CollisionsPanel::alertsChanged, collisions_dock, name);
  new TabbedDocks(host.window(), docks);
  showMessagesToRead(host, messages_dock);
  collisions_dock->raise();
  host.window().resizeDocks({docks.front()}, {272}, Qt::Vertical);
  QObject::connect(&refreshTimer(host), &QTimer::timeout, collisions, [&host, collisions] {
    if (collisions->isVisible() || host.snapshot()) collisions->showSnapshot(host.snapshot());
  });
  followWith(chart, host);
}

/// Tabs of the right side, behind what a module puts there first.
QDockWidget* addRightDocks(Host& host) {
  auto* solid = new SolidPanel(host);
  auto* guides = new GuidesPanel(host);
  QDockWidget* solid_dock = makeDock("dockSolid", QObject::tr("Solid"), scrolledPanel(solid, 332));
  QDockWidget* guides_dock = makeDock("dockGuides", QObject::tr("Guides"), scrolledPanel(guides, 332));
  for (QDockWidget* dock : {solid_dock, guides_dock}) host.addDock(dock, Qt::RightDockWidgetArea);
  solid_dock->raise();
  QObject::connect(&refreshTimer(host), &QTimer::timeout, solid, [solid, guides] {
    solid->showNow();
    guides->showCurves();
  });
  QObject::connect(&host.viewport(), &ViewportWidget::sceneChanged, solid, &SolidPanel::showMarks);
  QObject::connect(&host.viewport(), &ViewportWidget::sceneChanged, guides, &GuidesPanel::showCurves);
  return solid_dock;
}

}  // namespace

void addPanels(Host& host) {
  auto* workcell = new WorkcellPanel(host);
  auto* properties = new PropertiesPanel(host);
  addCopyAndPaste(host);
  QDockWidget* workcell_dock = makeDock("dockWorkcell", QObject::tr("Workcell"), workcell);
  QDockWidget* properties_dock = makeDock("dockProperties", QObject::tr("Properties"), scrolledPanel(properties, 240));
  host.addDock(workcell_dock, Qt::LeftDockWidgetArea);
  host.addDock(properties_dock, Qt::LeftDockWidgetArea);
  host.window().resizeDocks({workcell_dock, properties_dock}, {556, 414}, Qt::Vertical);
  new SceneMenu(host, *workcell);
  addBottomDocks(host);
  addRobotDocks(host);
  addMannequinDocks(host);
  addErgonomicsDocks(host);
  addEditDocks(host);
  addPlanningDocks(host);
  addStudiesDocks(host);
  addLiveDock(host);
  addRos2Dock(host);
  addConsoleDock(host);
  addAccessDocks(host);
  addAgentsDock(host);
  QDockWidget* solid_dock = addRightDocks(host);
  host.window().resizeDocks({workcell_dock, solid_dock}, {296, 344}, Qt::Horizontal);
  QObject::connect(&refreshTimer(host), &QTimer::timeout, workcell, [&host, workcell, properties] {
    workcell->showSnapshot(host.snapshot());
    properties->showNow();
  });
}

}  // namespace hapticell::app
