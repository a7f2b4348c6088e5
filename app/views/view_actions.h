// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMenu;

namespace hapticell::app {

class Host;

/// Adds to the View menu: saved views, following, full screen, back, left and bottom views. The window owns them.
void addViewActions(Host& host, QMenu& view);

}  // namespace hapticell::app
