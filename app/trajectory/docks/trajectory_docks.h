// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

class Host;

/// Adds everything about trajectories to a window that is being set up: the dock under the scene (dockTrajectory), the
/// dock *Motion* on the right (dockMotion, hidden until it is opened), the menu, the keys R and Shift+R, traces and the
/// frame's gizmo in the scene. Returns the lower dock, for the code that arranges the tabs there.
QDockWidget* addTrajectoryDocks(Host& host);

}  // namespace hapticell::app
