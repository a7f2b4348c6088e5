// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

class QLineEdit;
class QListWidget;
class QMainWindow;

namespace hapticell::app {

/// Ctrl+K: the user types a few letters of a command, Enter runs it. Lists everything that can be clicked in the window
/// now (see commandsNow()), with its key and panel. Letters may be left out, and words of the panel's name may be typed
/// too. A part of the window, never a separate window. GUI thread.
class CommandFinder : public QFrame {
  Q_OBJECT
 public:
  explicit CommandFinder(QMainWindow& window);
  void open();
  /// How well `typed` matches `text`: 0 not at all, more is better (whole words score higher than scattered letters).
  static int match(const QString& typed, const QString& text);

  /// Hides it and gives the focus back; returns whether it was open.
  bool dismiss();

 signals:
  /// Emitted before the commands are listed: panels that are made on demand must be made now.
  void opening();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void list();
  void run();
  QMainWindow& window_;
  QLineEdit* typed_;
  QListWidget* found_;
  std::vector<QPointer<QObject>> targets_;  ///< Targets of the rows.
  QPointer<QWidget> focus_before_;
};

}  // namespace hapticell::app
