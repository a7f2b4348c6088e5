// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

/// Whether a dock is seen: shown, and not behind another tab of its place.
bool isInFront(const QDockWidget& dock);

}  // namespace hapticell::app
