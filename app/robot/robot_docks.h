// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the panels about robots to a window that is being set up: dockRobot, and those that it opens.
///
/// dockRobot moves to the front when a robot or mechanism is selected, except while something is held: no panel may
/// move while the hand works.
void addRobotDocks(Host& host);

}  // namespace hapticell::app
