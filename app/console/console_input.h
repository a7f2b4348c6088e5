// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPlainTextEdit>

namespace hapticell::app {

class ConsoleHistory;

/// The field of the console: Enter runs (Shift+Enter makes a new line), Tab completes, Up and Down go through the
/// history, Ctrl+C without a selection interrupts. It is as high as its text, up to some lines.
class ConsoleInput : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit ConsoleInput(ConsoleHistory& history, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// Takes the text for running: it is added to the history and the field is empty.
  QString take();
  /// More lines must follow: begins the next one, as far in as the last.
  void continueLine();
  /// Replaces the text before the cursor from `start` on by what all the words begin with.
  void complete(int start, const QStringList& words);
  QString textBeforeCursor() const;

 signals:
  void ran();
  void completionWanted();
  void interrupted();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool goesThroughHistory(QKeyEvent* event);
  void put(const QString& text);

  ConsoleHistory& history_;
};

}  // namespace hapticell::app
