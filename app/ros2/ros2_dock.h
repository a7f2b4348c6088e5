// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock ROS 2, closed, with its entry in the menu Applications.
void addRos2Dock(Host& host);

}  // namespace hapticell::app
