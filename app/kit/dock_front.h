// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

/// Whether a dock is visible: shown, and not behind another tab.
bool isInFront(const QDockWidget& dock);

/// Shows a dock in front of the tabs beside it, also where it was hidden until now.
void bringToFront(QDockWidget* dock);

/// Marks a dock that is opened for a task, such as to plan a path: bringForSelection() leaves it in front.
void markAsTask(QDockWidget* dock);

/// Brings the panel of what was selected to the front, unless a dock of a task is in front on the same side of the window.
void bringForSelection(QDockWidget* dock);

}  // namespace hapticell::app
