// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

class QLineEdit;
class QListWidget;
class QMainWindow;

namespace hapticell::app {

/// Ctrl+K: type a few letters of a command, Enter does it. Lists everything that can be clicked in the window now (see
/// commandsNow()), with its key and panel; letters may be left out in between, and words of the panel's name may be
/// typed too. A part of the window, never a window of its own. GUI thread.
class CommandFinder : public QFrame {
  Q_OBJECT
 public:
  explicit CommandFinder(QMainWindow& window);
  void open();
  /// How well `typed` is found in `text`: 0 not at all, more is better (whole words before letters apart).
  static int match(const QString& typed, const QString& text);

  /// Hides it and gives the focus back; whether it was open.
  bool dismiss();

 signals:
  /// Before the commands are listed: what makes its panels late makes them now.
  void opening();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void list();
  void run();
  QMainWindow& window_;
  QLineEdit* typed_;
  QListWidget* found_;
  std::vector<QPointer<QObject>> targets_;  ///< Of the rows.
  QPointer<QWidget> focus_before_;
};

}  // namespace hapticell::app
