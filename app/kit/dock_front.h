// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

/// Whether a dock is visible: shown, and not behind another tab.
bool isInFront(const QDockWidget& dock);

/// Shows a dock in front of the tabs beside it, also where it was hidden until now.
void bringToFront(QDockWidget* dock);

}  // namespace hapticell::app
