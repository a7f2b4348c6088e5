// SPDX-License-Identifier: Apache-2.0
#include "app/live/live_dock.h"

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
#include "app/live/live_feed.h"
#include "app/live/live_panel.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"

namespace hapticell::app {

void addLiveDock(Host& host) {
  auto* feed = new LiveFeed(host, &host.window());
  QDockWidget* dock = makeDock("dockLive", QObject::tr("Live view"), scrolledPanel(new LivePanel(*feed), 332));
  dock->setWindowIcon(icon("eye"));
  host.addDock(dock, Qt::RightDockWidgetArea);
  dock->hide();
  QMenu* menu = topMenu(host.window(), "menuApplications", QObject::tr("Applications"));
  QAction* action = makeAction(&host.window(), {"actionLive", QObject::tr("Live view in a browser"), {}, {}, {}});
  host.window().addAction(action);
  menu->addAction(action);
  QObject::connect(action, &QAction::triggered, dock, [dock] {
    bringToFront(dock);
  });
}

}  // namespace hapticell::app
