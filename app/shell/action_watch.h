// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

class QAbstractButton;
class QAction;
class QWidget;

namespace hapticell::app {

/// Notices every action that is triggered and every button that is clicked, in all windows of the program. GUI thread.
class ActionWatch : public QObject {
 public:
  /// Calls `note` with the object name of each, or, if it has none, with its class and the named object that contains
  /// it, but never with text that the user typed. `root` is the existing window.
  ActionWatch(QWidget& root, std::function<void(const QString&)> note);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void watch(QAction* action);
  void watch(QAbstractButton* button);
  void noteSender();

  std::function<void(const QString&)> note_;
};

}  // namespace hapticell::app
