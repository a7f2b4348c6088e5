// SPDX-License-Identifier: Apache-2.0
#include "app/settings/gesture_field.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace hapticell::app {

GestureField::GestureField(QWidget* parent) : QPushButton(parent) {
  setFocusPolicy(Qt::StrongFocus);
}

void GestureField::setGestures(const std::vector<ViewGesture>& gestures) {
  QStringList words;
  for (const ViewGesture& gesture : gestures) words << gestureText(gesture);
  shown_ = words.isEmpty() ? tr("none") : words.join(tr(" or "));
  if (!listening_) setText(shown_);
  setAccessibleDescription(shown_);
}

void GestureField::listen(bool on) {
  listening_ = on;
  held_ = {};
  setText(on ? tr("Press the buttons here, with Ctrl, Alt, Shift") : shown_);
}

void GestureField::mousePressEvent(QMouseEvent* event) {
  if (!listening_) return;
  held_.buttons |= event->buttons();
  held_.modifiers = event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
  setText(gestureText(held_));
}

void GestureField::mouseReleaseEvent(QMouseEvent* event) {
  if (!listening_) {
    if (event->button() == Qt::LeftButton) listen(true);
    return;
  }
  if (event->buttons() != Qt::NoButton || held_.buttons == Qt::NoButton) return;
  const ViewGesture gesture = held_;
  listen(false);
  emit recorded(gesture);
}

void GestureField::keyPressEvent(QKeyEvent* event) {
  if (listening_ && event->key() == Qt::Key_Escape) return listen(false);
  if (!listening_ && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Space)) return listen(true);
  if (!listening_) QPushButton::keyPressEvent(event);
}

void GestureField::contextMenuEvent(QContextMenuEvent* event) {
  event->accept();
}

void GestureField::focusOutEvent(QFocusEvent* event) {
  listen(false);
  QPushButton::focusOutEvent(event);
}

}  // namespace hapticell::app
