// SPDX-License-Identifier: Apache-2.0
#include "app/measure/measure_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>

#include "app/host/host.h"
#include "app/kit/dock_front.h"
#include "app/measure/measure_panel.h"
#include "app/kit/form.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"

namespace hapticell::app {

void addMeasureDock(Host& host) {
  auto* panel = new MeasurePanel(host);
  QDockWidget* dock = makeDock("dockMeasure", QObject::tr("Measure"), scrolledPanel(panel));
  dock->setWindowIcon(icon("measure"));
  host.addDock(dock, Qt::RightDockWidgetArea);
  dock->hide();
  // Hidden, not only behind another tab: the lines in the scene go with it.
  QObject::connect(dock->toggleViewAction(), &QAction::toggled, panel, [panel](bool shown) {
    if (!shown) panel->end();
  });
  if (auto* action = host.window().findChild<QAction*>("actionMeasure"))
    QObject::connect(action, &QAction::triggered, panel, [panel, dock] {
      bringToFront(dock);
      panel->begin();
    });
}

}  // namespace hapticell::app
