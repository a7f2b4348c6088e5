// SPDX-License-Identifier: Apache-2.0
#include "app/shell/action_watch.h"

#include <QAbstractButton>
#include <QAction>
#include <QActionEvent>
#include <QCoreApplication>
#include <QToolButton>
#include <utility>

namespace hapticell::app {

namespace {

QString watchedName(const QObject& object) {
  if (!object.objectName().isEmpty()) return object.objectName();
  const QString kind = QString::fromLatin1(object.metaObject()->className());
  for (const QObject* above = object.parent(); above != nullptr; above = above->parent())
    if (!above->objectName().isEmpty()) return kind + QStringLiteral(" in ") + above->objectName();
  return kind;
}

}  // namespace

ActionWatch::ActionWatch(QWidget& root, std::function<void(const QString&)> note) : note_(std::move(note)) {
  for (QAction* action : root.findChildren<QAction*>()) watch(action);
  for (QAbstractButton* button : root.findChildren<QAbstractButton*>()) watch(button);
  QCoreApplication::instance()->installEventFilter(this);
}

/// Those that are made later: an action when it is added to a widget, a button before it is first shown.
bool ActionWatch::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ActionAdded) watch(static_cast<QActionEvent*>(event)->action());
  if (event->type() == QEvent::Polish) {
    if (auto* button = qobject_cast<QAbstractButton*>(object)) watch(button);
  }
  return QObject::eventFilter(object, event);
}

void ActionWatch::watch(QAction* action) {
  connect(action, &QAction::triggered, this, &ActionWatch::noteSender, Qt::UniqueConnection);
}

void ActionWatch::watch(QAbstractButton* button) {
  const auto* tool = qobject_cast<QToolButton*>(button);
  if (tool && tool->defaultAction()) return;  // The action is noted.
  connect(button, &QAbstractButton::clicked, this, &ActionWatch::noteSender, Qt::UniqueConnection);
}

void ActionWatch::noteSender() {
  if (const QObject* object = sender()) note_(watchedName(*object));
}

}  // namespace hapticell::app
