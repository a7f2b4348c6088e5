// SPDX-License-Identifier: Apache-2.0
#include "app/shell/escape_key.h"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <algorithm>

#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

EscapeKey::EscapeKey(QMainWindow& window, ViewportWidget& scene) : QObject(&window), window_(window), scene_(scene) {
  qApp->installEventFilter(this);
}

bool EscapeKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || sending_ ||
      !watched->isWidgetType())
    return false;
  if (QApplication::activePopupWidget() || QApplication::activeModalWidget()) return false;
  auto* widget = static_cast<QWidget*>(watched);
  const QWidget* root = widget->window();
  if (root != &window_ && root->parentWidget() != &window_) return false;
  if (scene_.isPicking()) {
    scene_.cancelPick();
    return true;
  }
  return widget->isWindow() && closeTop(*widget);  // A window gets the key when nothing in it took it.
}

/// What was typed since the field was filled; a search is emptied.
bool EscapeKey::takeBackTyping() {
  auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  if (!field || field->isReadOnly() || !field->isModified() || !field->isUndoAvailable()) return false;
  while (field->isUndoAvailable()) field->undo();
  field->setModified(false);
  return true;
}

bool EscapeKey::closeTop(QWidget& window) {
  if (qobject_cast<QDialog*>(&window)) return false;  // It is on top, and closes itself.
  if (takeBackTyping()) return true;
  if (std::any_of(closers_.begin(), closers_.end(), [](const auto& close) { return close(); })) return true;
  if (sendToScene()) return true;
  const auto* dock = qobject_cast<QDockWidget*>(&window);
  return dock && window.close();
}

bool EscapeKey::sendToScene() {
  QKeyEvent key(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
  sending_ = true;
  QCoreApplication::sendEvent(&scene_, &key);
  sending_ = false;
  return key.isAccepted();
}

}  // namespace hapticell::app
