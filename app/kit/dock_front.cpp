// SPDX-License-Identifier: Apache-2.0
#include "app/kit/dock_front.h"

#include <QDockWidget>

namespace hapticell::app {

bool isInFront(const QDockWidget& dock) {
  if (!dock.isVisible()) return false;
  // Qt moves what lies behind another tab out of the window. (Its visible region says nothing: what it holds covers
  // it.)
  return dock.isFloating() || dock.parentWidget()->rect().intersects(dock.geometry());
}

}  // namespace hapticell::app
