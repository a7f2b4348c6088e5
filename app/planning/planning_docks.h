// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock that plans paths, with its entry in the menu Robot. GUI thread; once per window.
void addPlanningDocks(Host& host);

}  // namespace hapticell::app
