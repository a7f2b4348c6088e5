// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the mannequin's dock, tabbed behind the docks of the right side, its menu and its handles.
void addMannequinDocks(Host& host);

}  // namespace hapticell::app
