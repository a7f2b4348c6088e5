// SPDX-License-Identifier: Apache-2.0
#include "app/console/console_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

#include "app/console/console_panel.h"
#include "app/host/host.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/top_menus.h"
#include "app/style/dock_title_bar.h"

namespace hapticell::app {

void addConsoleDock(Host& host) {
  auto* panel = new ConsolePanel(host);
  panel->setMinimumSize(420, 150);
  QDockWidget* dock = makeDock(QStringLiteral("dockPythonConsole"), QObject::tr("Python console"), panel);
  host.addDock(dock, Qt::BottomDockWidgetArea, host.window().findChild<QDockWidget*>(QStringLiteral("dockCollisions")));
  dock->hide();
  QMenu* menu = topMenu(host.window(), "menuApplications", QObject::tr("Applications"));
  QAction* action = makeAction(&host.window(), {"actionPythonConsole", QObject::tr("Python console"), {}, {}, {}});
  host.window().addAction(action);
  menu->addAction(action);
  QObject::connect(action, &QAction::triggered, panel, [dock, panel] {
    bringToFront(dock);
    panel->focusInput();
  });
}

}  // namespace hapticell::app
