// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPushButton>

#include "app/viewport/tools/navigation.h"

namespace hapticell::app {

/// Reads a mouse gesture: after a click (or Enter), reports the buttons and modifiers that are next held over it
/// together. Escape leaves it unchanged.
class GestureField : public QPushButton {
  Q_OBJECT
 public:
  explicit GestureField(QWidget* parent = nullptr);
  /// The shown gestures, joined by " or ".
  void setGestures(const std::vector<ViewGesture>& gestures);

 signals:
  void recorded(const hapticell::app::ViewGesture& gesture);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void listen(bool on);
  QString shown_;
  ViewGesture held_;
  bool listening_ = false;
};

}  // namespace hapticell::app
