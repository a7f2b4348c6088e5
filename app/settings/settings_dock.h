// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class MainWindow;

/// Lets the window follow its settings from now on, and adds the dock that changes them (made when it is first opened).
void addSettings(MainWindow& window);

}  // namespace hapticell::app
