// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMainWindow;
class QMenu;
class QString;

namespace hapticell::app {

/// A menu of the menu bar, at its place in the bar's order whoever comes first: menuFile, menuEdit, menuView,
/// menuInsert, menuRobot, menuMannequin, menuHaptics, menuCollision, menuTrajectory, menuApplications, menuWindow,
/// menuHelp. One that stands there already is given back; any other name comes before menuWindow.
QMenu* topMenu(QMainWindow& window, const char* name, const QString& title);

}  // namespace hapticell::app
