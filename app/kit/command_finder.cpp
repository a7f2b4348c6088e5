// SPDX-License-Identifier: Apache-2.0
#include "app/kit/command_finder.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "app/kit/command_list.h"
#include "app/style/icon.h"
#include "app/style/key_step.h"

namespace hapticell::app {
namespace {

constexpr int kFinderWidth = 420;
constexpr int kRows = 12;
constexpr int kFoundHeight = 26;

/// 0: not found. The name counts before letters apart, and before the panel's.
int score(const QString& typed, const Command& command) {
  const int of_name = CommandFinder::match(typed, command.words);
  const QString all = command.words + ' ' + command.where;
  const QStringList words = typed.split(' ', Qt::SkipEmptyParts);
  const bool in_all = std::all_of(words.begin(), words.end(),
                                  [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
  // Points (see match()) of words found apart: under a name that has what was typed in its middle (500), over its
  // letters apart (100). Half: the same order; twice: before such names.
  constexpr int kWordsApart = 400;
  return in_all ? std::max(of_name, kWordsApart) : of_name;
}

/// A button or a field: of names that fit alike, commands and panels come before what panels hold.
bool isInsidePanel(const Command& command) {
  return !qobject_cast<const QAction*>(command.target.data()) && !qobject_cast<const QDockWidget*>(command.target.data());
}

}  // namespace

CommandFinder::CommandFinder(QMainWindow& window) : QFrame(&window), window_(window) {
  setObjectName("commandFinder");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  typed_ = new QLineEdit;
  typed_->setObjectName("fieldCommand");
  typed_->setPlaceholderText(tr("Find a command, panel, button or setting"));
  typed_->addAction(icon("search"), QLineEdit::LeadingPosition);
  found_ = new QListWidget;
  found_->setObjectName("listCommands");
  found_->setFocusPolicy(Qt::NoFocus);
  column->addWidget(typed_);
  column->addWidget(found_);
  typed_->installEventFilter(this);
  connect(typed_, &QLineEdit::textChanged, this, &CommandFinder::list);
  connect(typed_, &QLineEdit::returnPressed, this, &CommandFinder::run);
  connect(found_, &QListWidget::itemClicked, this, &CommandFinder::run);
  hide();
}

int CommandFinder::match(const QString& typed, const QString& text) {
  if (typed.isEmpty()) return 1;
  const int at = static_cast<int>(text.indexOf(typed, 0, Qt::CaseInsensitive));
  if (at == 0) return 1000;
  if (at > 0) return text[at - 1].isSpace() ? 900 : 500;
  int next = 0;
  for (const QChar& letter : text)
    if (next < typed.size() && letter.toLower() == typed[next].toLower()) ++next;
  return next == typed.size() ? 100 : 0;
}

void CommandFinder::open() {
  focus_before_ = QApplication::focusWidget();
  emit opening();
  typed_->clear();
  list();
  resize(kFinderWidth, 60 + kRows * kFoundHeight);
  move(window_.width() - kFinderWidth - 12, 32);
  show();
  raise();
  typed_->setFocus();
}

bool CommandFinder::dismiss() {
  if (!isVisible()) return false;
  hide();
  if (focus_before_) focus_before_->setFocus();
  return true;
}

void CommandFinder::list() {
  const QString typed = typed_->text().trimmed();
  struct Row {
    int score = 0;
    Command command;
  };
  std::vector<Row> rows;
  std::set<std::pair<QString, QString>> seen;
  for (const Command& command : commandsNow(window_)) {
    const int found = score(typed, command);
    if (found > 0 && seen.insert({command.words, command.where}).second) rows.push_back({found, command});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    if (a.score != b.score) return a.score > b.score;
    if (isInsidePanel(a.command) != isInsidePanel(b.command)) return isInsidePanel(b.command);
    return a.command.words < b.command.words;
  });
  found_->clear();
  targets_.clear();
  for (const Row& row : rows) {
    QString words = row.command.words;
    if (!row.command.where.isEmpty()) words += QStringLiteral("  ·  ") + row.command.where;
    if (!row.command.key.isEmpty()) words += QStringLiteral("   ") + row.command.key;
    auto* item = new QListWidgetItem(row.command.icon, words, found_);
    item->setSizeHint(QSize(0, kFoundHeight));
    targets_.push_back(row.command.target);
  }
  found_->setCurrentRow(rows.empty() ? -1 : 0);
}

void CommandFinder::run() {
  const int row = found_->currentRow();
  const QPointer<QObject> target = row >= 0 ? targets_[static_cast<std::size_t>(row)] : nullptr;
  dismiss();
  if (target) runCommand(window_, *target);
}

bool CommandFinder::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) hide();
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = keyStep(key, Qt::Key_Up, Qt::Key_Down);
    if (step != 0 && found_->count() > 0) {
      found_->setCurrentRow(std::clamp(found_->currentRow() + step, 0, found_->count() - 1));
      return true;
    }
    if (key == Qt::Key_Escape) {
      return dismiss();
    }
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace hapticell::app
