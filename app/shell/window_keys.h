// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMainWindow;
class QWidget;

namespace hapticell::app {

/// Adds the keys that belong to the window as a whole: Ctrl+K finds a command, `?` shows the keys over the scene, F6
/// and Shift+F6 go to the next and the previous panel (docks in reading order, the scene last). Call it once, when the
/// actions exist.
void addWindowKeys(QMainWindow& window, QWidget& scene);

}  // namespace hapticell::app
