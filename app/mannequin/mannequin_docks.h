// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// The dock of the mannequin, its menu and its handles, tabbed behind the docks of the right side.
void addMannequinDocks(Host& host);

}  // namespace hapticell::app
