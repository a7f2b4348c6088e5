// SPDX-License-Identifier: Apache-2.0
#include "app/kit/top_menus.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStringList>

namespace hapticell::app {
namespace {

qsizetype placeOf(const QString& name) {
  static const QStringList order{"menuFile",       "menuEdit",         "menuView",    "menuInsert",
                                 "menuRobot",      "menuMannequin",    "menuHaptics", "menuCollision",
                                 "menuTrajectory", "menuApplications", "menuWindow",  "menuHelp"};
  const qsizetype place = order.indexOf(name);
  return place < 0 ? order.indexOf("menuApplications") : place;
}

}  // namespace

QMenu* topMenu(QMainWindow& window, const char* name, const QString& title) {
  QMenuBar* bar = window.menuBar();
  const QString wanted = QString::fromLatin1(name);
  QAction* before = nullptr;
  for (QAction* action : bar->actions()) {
    if (!action->menu()) continue;
    if (action->menu()->objectName() == wanted) return action->menu();
    if (!before && placeOf(action->menu()->objectName()) > placeOf(wanted)) before = action;
  }
  auto* menu = new QMenu(title, bar);
  menu->setObjectName(wanted);
  bar->insertMenu(before, menu);
  return menu;
}

}  // namespace hapticell::app
