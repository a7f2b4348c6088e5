// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

class QAction;
class QLineEdit;
class QListWidget;
class QMainWindow;

namespace hapticell::app {

/// Ctrl+K: type a few letters of a command, Enter does it. Lists every action of the window that can be done now, with
/// its key; letters may be left out in between. A part of the window, never a window of its own. GUI thread.
class CommandFinder : public QFrame {
  Q_OBJECT
 public:
  explicit CommandFinder(QMainWindow& window);
  void open();
  /// How well `typed` is found in `text`: 0 not at all, more is better (whole words before letters apart).
  static int match(const QString& typed, const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void list();
  void run();
  QMainWindow& window_;
  QLineEdit* typed_;
  QListWidget* found_;
  std::vector<QPointer<QAction>> actions_;  ///< Of the rows.
  QPointer<QWidget> focus_before_;
};

}  // namespace hapticell::app
