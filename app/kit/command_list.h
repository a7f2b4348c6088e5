// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>
#include <QPointer>
#include <QString>
#include <vector>

class QMainWindow;

namespace hapticell::app {

/// Something that can be clicked in the window now.
struct Command {
  QString words;  ///< Its name, without shortcut marks.
  QString where;  ///< The panel that contains it; empty for commands of menus.
  QString key;    ///< Its shortcut; empty for none.
  QIcon icon;
  QPointer<QObject> target;  ///< QAction, QDockWidget, QAbstractButton, or a field with a name.
};

/// Every enabled action of the window, every panel, and what has a name in the panels, open or not: enabled buttons and
/// switches, and fields. GUI thread, as all below.
std::vector<Command> commandsNow(const QMainWindow& window);

/// Runs an action; shows a panel; shows a button or switch and clicks it; shows a field and gives it the focus.
void runCommand(QMainWindow& window, QObject& target);

}  // namespace hapticell::app
