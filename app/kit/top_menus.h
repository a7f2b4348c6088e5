// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMainWindow;
class QMenu;
class QString;

namespace hapticell::app {

/// A menu of the menu bar, at its position in the bar's order, whoever asks first: menuFile, menuEdit, menuView,
/// menuInsert, menuRobot, menuMannequin, menuHaptics, menuCollision, menuTrajectory, menuApplications, menuWindow,
/// menuHelp. Returns an existing menu; any other name is inserted before menuWindow.
QMenu* topMenu(QMainWindow& window, const char* name, const QString& title);

}  // namespace hapticell::app
