// SPDX-License-Identifier: Apache-2.0
#include "app/planning/planning_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>

#include "app/host/host.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/top_menus.h"
#include "app/planning/plan_panel.h"
#include "app/style/dock_title_bar.h"

namespace hapticell::app {

void addPlanningDocks(Host& host) {
  QDockWidget* dock = makeDock("dockPlan", PlanPanel::tr("Plan a path"), scrolledPanel(new PlanPanel(host)));
  host.addDock(dock, Qt::RightDockWidgetArea);
  dock->hide();
  markAsTask(dock);
  QAction* action = makeAction(&host.window(), {"actionPlanPath", PlanPanel::tr("Plan a path…"), {}, {}, {}});
  topMenu(host.window(), "menuRobot", QObject::tr("Robot"))->addAction(action);
  QObject::connect(action, &QAction::triggered, dock, [dock] {
    bringToFront(dock);
  });
}

}  // namespace hapticell::app
