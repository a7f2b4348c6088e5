// SPDX-License-Identifier: Apache-2.0
#include "app/access/access_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>

#include "app/access/access_panel.h"
#include "app/host/host.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/top_menus.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"
#include "app/trajectory/motions/motion_list.h"
#include "geometry/system/assertion.h"

namespace hapticell::app {

void addAccessDocks(Host& host) {
  auto* motions = host.window().findChild<MotionList*>();
  HAPTICELL_DEMAND(motions != nullptr);
  auto* panel = new AccessPanel(host, *motions);
  QDockWidget* dock = makeDock("dockAccess", QObject::tr("Access"), scrolledPanel(panel, 332));
  dock->setWindowIcon(icon("export"));
  host.addDock(dock, Qt::RightDockWidgetArea);
  dock->hide();
  markAsTask(dock);
  QObject::connect(dock->toggleViewAction(), &QAction::toggled, panel, &AccessPanel::setShown);
  QAction* action = makeAction(&host.window(), {"actionAccess", QObject::tr("Access for maintenance"), {}, {}, {}});
  host.window().addAction(action);
  topMenu(host.window(), "menuApplications", QObject::tr("Applications"))->addAction(action);
  QObject::connect(action, &QAction::triggered, dock, [dock] {
    bringToFront(dock);
  });
}

}  // namespace hapticell::app
