// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

class Host;

/// Whether the stylus is in use: it holds something, or forces are on. Panels then stay in place, so that nothing
/// covers what the hand works on.
bool isHandAtWork(const Host& host);

/// bringToFront(), unless the stylus is in use; then nothing happens.
void bringToFrontIfIdle(const Host& host, QDockWidget* dock);

}  // namespace hapticell::app
