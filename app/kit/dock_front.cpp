// SPDX-License-Identifier: Apache-2.0
#include "app/kit/dock_front.h"

#include <QDockWidget>
#include <QTimer>

namespace hapticell::app {

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

}  // namespace hapticell::app
