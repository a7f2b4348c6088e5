// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <QObject>

namespace hapticell::app {

struct Actions;
class ViewportWidget;

/// The menus of the view strip, synchronized with the actions of the View menu. Actions and viewport must outlive it.
class ViewMenus : public QObject {
  Q_OBJECT
 public:
  ViewMenus(const Actions& actions, ViewportWidget& viewport, QObject* parent);

 private:
  void addChoice(QMenu& menu, QAction* action, const QString& on, const QString& off);
  void addSection();
  void setSection(bool on);
  void chooseAxis(int axis);
  void show();
  const Actions& actions_;
  ViewportWidget& viewport_;
  QMenu projection_, faces_, section_;
  QList<QAction*> only_cut_;  ///< Entries of the section's menu that need a section plane.
};

}  // namespace hapticell::app
