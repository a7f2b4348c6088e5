// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the panels about robots to a window that is being set up: dockRobot, and those that are opened from it.
///
/// dockRobot comes to the front by itself when a robot or mechanism is selected, unless something is held: no panel
/// moves while the hand works.
void addRobotDocks(Host& host);

}  // namespace hapticell::app
