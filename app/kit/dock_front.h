// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

/// Whether a dock is visible: shown, and not behind another tab.
bool isInFront(const QDockWidget& dock);

}  // namespace hapticell::app
