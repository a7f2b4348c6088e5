// SPDX-License-Identifier: Apache-2.0
#include "app/agents/agents_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>

#include "app/agents/agents_panel.h"
#include "app/host/host.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/top_menus.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"

namespace hapticell::app {

void addAgentsDock(Host& host) {
  auto* panel = new AgentsPanel(host);
  QDockWidget* dock = makeDock("dockAgents", QObject::tr("Agents"), scrolledPanel(panel, 332));
  dock->setWindowIcon(icon("hands"));
  host.addDock(dock, Qt::RightDockWidgetArea);
  dock->hide();
  markAsTask(dock);
  // Hidden, not only behind another tab: the run and what it draws in the scene go with it.
  QObject::connect(dock->toggleViewAction(), &QAction::toggled, panel, [panel](bool shown) {
    if (!shown) panel->stop();
  });
  QAction* action = makeAction(&host.window(), {"actionAgents", QObject::tr("Agents"), {}, {}, {}});
  host.window().addAction(action);
  topMenu(host.window(), "menuApplications", QObject::tr("Applications"))->addAction(action);
  QObject::connect(action, &QAction::triggered, dock, [dock] {
    bringToFront(dock);
  });
}

}  // namespace hapticell::app
