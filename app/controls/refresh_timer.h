// SPDX-License-Identifier: Apache-2.0
#pragma once

class QTimer;

namespace hapticell::app {

class Host;

/// The one clock by which docks show numbers anew, ten times a second: connect to its timeout(). One for all, so that a
/// window at rest wakes ten times a second and not ten times for each dock. Owned by the window. GUI thread.
QTimer& refreshTimer(Host& host);

}  // namespace hapticell::app
