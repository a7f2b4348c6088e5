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
  QString words;  ///< What it is called, without marks.
  QString where;  ///< The panel in which it is; empty for commands of menus.
  QString key;    ///< Its key; empty for none.
  QIcon icon;
  QPointer<QObject> target;  ///< QAction, QDockWidget, QAbstractButton, or a field that has a name.
};

/// Every action of the window that can be done, every panel, and what has a name in the panels, open or not: buttons
/// and switches that are enabled, and fields. GUI thread, as all below.
std::vector<Command> commandsNow(const QMainWindow& window);

/// Does an action; shows a panel; shows a button or switch and clicks it; shows a field and takes the focus there.
void runCommand(QMainWindow& window, QObject& target);

}  // namespace hapticell::app
