// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>

class QAction;

namespace hapticell::app {

/// Looks like a search field and triggers an action when it is clicked; shows the action's name and shortcut, and
/// follows changes of the shortcut.
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
