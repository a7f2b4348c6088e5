// SPDX-License-Identifier: Apache-2.0
#include "app/kit/dock_front.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>
#include <algorithm>

namespace hapticell::app {
namespace {

constexpr const char* kTask = "task";

}  // namespace

bool isInFront(const QDockWidget& dock) {
  if (!dock.isVisible()) return false;
  // Qt moves what lies behind another tab out of the window. (Its visible region says nothing: what it holds covers
  // it.)
  return dock.isFloating() || dock.parentWidget()->rect().intersects(dock.geometry());
}

void bringToFront(QDockWidget* dock) {
  dock->show();
  dock->raise();
  // Qt forgets a tab that is raised before its docks were laid out.
  QTimer::singleShot(0, dock, [dock] {
    if (!dock->isHidden()) dock->raise();
  });
}

void markAsTask(QDockWidget* dock) {
  dock->setProperty(kTask, true);
}

void bringForSelection(QDockWidget* dock) {
  auto* window = qobject_cast<QMainWindow*>(dock->window());
  if (!window) return bringToFront(dock);  // It floats.
  const auto docks = window->findChildren<QDockWidget*>();
  const bool at_task = std::any_of(docks.begin(), docks.end(), [&](QDockWidget* other) {
    return other->property(kTask).toBool() && !other->isFloating() &&
           window->dockWidgetArea(other) == window->dockWidgetArea(dock) && isInFront(*other);
  });
  if (!at_task) bringToFront(dock);
}

}  // namespace hapticell::app
