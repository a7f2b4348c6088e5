// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>
#include <vector>

class QMainWindow;
class QWidget;

namespace hapticell::app {

class ViewportWidget;

/// Handles Escape, wherever the focus is, one step per press: ends an open pick; then passes it to the widget with the
/// focus (an edit, a drag); reverts text typed into a field; then tries the closers in the order in which they were
/// added, then the tools of the scene, and last closes the floating dock in which it was pressed. Forces are switched
/// off before all of this (the module gets the key first); menus and dialogs close by themselves. GUI thread.
class EscapeKey : public QObject {
  Q_OBJECT
 public:
  EscapeKey(QMainWindow& window, ViewportWidget& scene);
  /// `close` returns whether there was something to close.
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
