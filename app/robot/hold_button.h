// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPushButton>
#include <QTimer>

namespace hapticell::app {

/// A button that repeats steps while it is held: emits began() when it is pressed, stepped() at once and then
/// repeatedly, and ended() when it is released. The Space key can hold it too.
class HoldButton : public QPushButton {
  Q_OBJECT
 public:
  /// `icon_name` is one of the program's icons; `purpose` says what it does, for tool tip and screen reader.
  HoldButton(const QString& icon_name, const QString& purpose, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {26, 26}; }

 signals:
  void began();
  void stepped();
  void ended();

 private:
  QTimer repeat_;
};

}  // namespace hapticell::app
