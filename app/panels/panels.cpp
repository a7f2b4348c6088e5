// SPDX-License-Identifier: Apache-2.0
#include "app/panels/panels.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTimer>

#include "app/host/host.h"
#include "app/panels/properties_panel.h"
#include "app/panels/workcell_panel.h"
#include "app/style/dock_title_bar.h"

namespace hapticell::app {
namespace {

constexpr int kRefreshMilliseconds = 100;  // Numbers change at most ten times a second.

QScrollArea* scrolled(QWidget* content, int minimum_width) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(minimum_width);
  scroll->setWidget(content);
  return scroll;
}

}  // namespace

void addPanels(Host& host) {
  auto* workcell = new WorkcellPanel(host);
  auto* properties = new PropertiesPanel(host);
  QDockWidget* workcell_dock = makeDock("dockWorkcell", QObject::tr("Workcell"), workcell);
  QDockWidget* properties_dock = makeDock("dockProperties", QObject::tr("Properties"), scrolled(properties, 240));
  host.addDock(workcell_dock, Qt::LeftDockWidgetArea);
  host.addDock(properties_dock, Qt::LeftDockWidgetArea);
  host.window().resizeDocks({workcell_dock}, {296}, Qt::Horizontal);
  host.window().resizeDocks({workcell_dock, properties_dock}, {556, 414}, Qt::Vertical);
  auto* timer = new QTimer(&host.window());
  QObject::connect(timer, &QTimer::timeout, &host.window(), [&host, workcell, properties] {
    workcell->showSnapshot(host.snapshot());
    properties->showNow();
  });
  timer->start(kRefreshMilliseconds);
}

}  // namespace hapticell::app
