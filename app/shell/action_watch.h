// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

class QAbstractButton;
class QAction;
class QWidget;

namespace hapticell::app {

/// Hears of every action that is triggered and every button that is clicked, in all windows of the program. GUI thread.
class ActionWatch : public QObject {
 public:
  /// `note` is called with the object name of each, or, where it has none, with its class and the named object that it
  /// is in: no text that the user has typed. `root` is the window that is there already.
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
