// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>

class QAction;

namespace hapticell::app {

/// Looks like a field to search in and does an action when it is clicked; says the action's name and key. Keeps to it
/// where the user gives it another key.
class CommandBox final : public QAbstractButton {
 public:
  explicit CommandBox(QAction& action, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString key_;
};

}  // namespace hapticell::app
