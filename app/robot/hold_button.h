// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPushButton>
#include <QTimer>

namespace hapticell::app {

/// A button that steps while it is held: began() when it goes down, stepped() at once and then again and again, ended()
/// when it comes up. Space holds it too.
class HoldButton : public QPushButton {
  Q_OBJECT
 public:
  /// `icon_name` is one of the program's icons; `purpose` is what it does, for tool tip and screen reader.
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
