// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDockWidget;

namespace hapticell::app {

class Host;

/// Adds what is about trajectories to a window that is being set up: the dock under the scene (dockTrajectory), the
/// dock *Motion* at the right (dockMotion, hidden until it is asked for), the menu, the keys R and Shift+R, traces and
/// the frame's gizmo in the scene. Gives the lower dock, for who arranges the tabs there.
QDockWidget* addTrajectoryDocks(Host& host);

}  // namespace hapticell::app
