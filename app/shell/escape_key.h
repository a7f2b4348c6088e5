// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>
#include <vector>

class QMainWindow;
class QWidget;

namespace hapticell::app {

class ViewportWidget;

/// Escape, wherever the focus is, one thing a press: ends an open pick; then what has the focus may use it (an edit, a
/// drag); takes back what was typed into a field of text; what that leaves goes to the closers in the order they were
/// added, to the tools of the scene, and last closes the floating dock in which it was pressed. Forces go off before
/// all of it (the module hears the key first); menus and dialogs close by themselves. GUI thread.
class EscapeKey : public QObject {
  Q_OBJECT
 public:
  EscapeKey(QMainWindow& window, ViewportWidget& scene);
  /// `close` tells whether there was something to close.
  void add(std::function<bool()> close) { closers_.push_back(std::move(close)); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool closeTop(QWidget& window);
  bool takeBackTyping();
  bool sendToScene();
  QMainWindow& window_;
  ViewportWidget& scene_;
  std::vector<std::function<bool()>> closers_;
  bool sending_ = false;
};

}  // namespace hapticell::app
