// SPDX-License-Identifier: Apache-2.0
#pragma once

class QTimer;

namespace hapticell::app {

class Host;

/// The shared timer for refreshing numbers in panels, ten times a second: connect to its timeout(). All panels share
/// it, so that an idle window wakes only ten times a second. Owned by the window. GUI thread.
QTimer& refreshTimer(Host& host);

}  // namespace hapticell::app
