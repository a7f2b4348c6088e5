// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock of access for maintenance, with its entry in the menu Applications. @pre the docks of trajectories are
/// there
void addAccessDocks(Host& host);

}  // namespace hapticell::app
