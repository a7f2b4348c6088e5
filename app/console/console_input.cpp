// SPDX-License-Identifier: Apache-2.0
#include "app/console/console_input.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <algorithm>

#include "app/console/console_history.h"

namespace hapticell::app {

namespace {

constexpr int kMostLines = 8;  // Of its height. Half: pasted functions scroll; twice: the output has no room.
constexpr int kIndent = 4;     // Spaces, as everybody's Python has it.

}  // namespace

ConsoleInput::ConsoleInput(ConsoleHistory& history, QWidget* parent) : QPlainTextEdit(parent), history_(history) {
  setObjectName(QStringLiteral("fieldConsoleInput"));
  setAccessibleName(tr("Python to run"));
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setPlaceholderText(tr("Python, with the open cell as “cell”"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(this, &QPlainTextEdit::textChanged, this, &QWidget::updateGeometry);
}

QSize ConsoleInput::sizeHint() const {
  const int lines = std::clamp(blockCount(), 1, kMostLines);
  const int margin = 2 * (frameWidth() + static_cast<int>(document()->documentMargin()));
  return {200, lines * fontMetrics().lineSpacing() + margin + 4};  // The style pads its frame by two pixels a side.
}

QSize ConsoleInput::minimumSizeHint() const {
  return {120, sizeHint().height()};
}

QString ConsoleInput::take() {
  const QString text = toPlainText();
  QString kept = text;
  while (kept.endsWith(QLatin1Char('\n'))) kept.chop(1);
  if (!kept.trimmed().isEmpty()) history_.add(kept);
  clear();
  return text;
}

void ConsoleInput::continueLine() {
  const QString line = textCursor().block().text();
  qsizetype indent = 0;
  while (indent < line.size() && line[indent] == QLatin1Char(' ')) ++indent;
  if (line.trimmed().endsWith(QLatin1Char(':'))) indent += kIndent;
  insertPlainText(QLatin1Char('\n') + QString(indent, QLatin1Char(' ')));
  ensureCursorVisible();
}

QString ConsoleInput::textBeforeCursor() const {
  const QTextCursor cursor = textCursor();
  return cursor.block().text().left(cursor.positionInBlock());
}

void ConsoleInput::complete(int start, const QStringList& words) {
  if (words.isEmpty()) return;
  QString common = words.front();
  for (const QString& word : words) {
    qsizetype same = 0;
    while (same < std::min(common.size(), word.size()) && common[same] == word[same]) ++same;
    common.truncate(same);
  }
  QTextCursor cursor = textCursor();
  const int typed = cursor.positionInBlock() - start;
  if (typed < 0 || common.size() <= typed) return;
  cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, typed);
  cursor.insertText(common);
  setTextCursor(cursor);
}

/// Tab and Ctrl+C are the field's, not the window's.
bool ConsoleInput::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Copy) || key->key() == Qt::Key_Tab || key->key() == Qt::Key_Return) {
      event->accept();
      return true;
    }
  }
  return QPlainTextEdit::event(event);
}

void ConsoleInput::keyPressEvent(QKeyEvent* event) {
  const bool plain = event->modifiers() == Qt::NoModifier || event->modifiers() == Qt::KeypadModifier;
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && plain) return emit ran();
  if (event->key() == Qt::Key_Tab && plain) {
    if (!textBeforeCursor().trimmed().isEmpty()) return emit completionWanted();
    insertPlainText(QString(kIndent, QLatin1Char(' ')));
    return;
  }
  if (event->matches(QKeySequence::Copy) && !textCursor().hasSelection()) return emit interrupted();
  if (!goesThroughHistory(event)) QPlainTextEdit::keyPressEvent(event);
}

/// From the first line upwards and from the last one downwards; within a text of several lines the keys move the cursor.
bool ConsoleInput::goesThroughHistory(QKeyEvent* event) {
  if (event->modifiers() != Qt::NoModifier && event->modifiers() != Qt::KeypadModifier) return false;
  const int line = textCursor().blockNumber();
  if (event->key() == Qt::Key_Up && line == 0) {
    put(history_.before(toPlainText()));
    return true;
  }
  if (event->key() == Qt::Key_Down && line == blockCount() - 1) {
    put(history_.after(toPlainText()));
    return true;
  }
  return false;
}

void ConsoleInput::put(const QString& text) {
  if (text == toPlainText()) return;
  setPlainText(text);
  moveCursor(QTextCursor::End);
}

}  // namespace hapticell::app
