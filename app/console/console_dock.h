// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock of the Python console, hidden, with its entry in the menu Applications.
void addConsoleDock(Host& host);

}  // namespace hapticell::app
