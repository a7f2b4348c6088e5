// SPDX-License-Identifier: Apache-2.0
#include "app/host/command_finder.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "app/style/icon.h"

namespace hapticell::app {
namespace {

constexpr int kFinderWidth = 420;
constexpr int kRows = 12;
constexpr int kFoundHeight = 26;

QString wordsOf(const QAction& action) {
  return QString(action.text()).remove('&').remove(QChar(0x2026));
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
  typed_->setPlaceholderText(tr("Find a command"));
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
  typed_->clear();
  list();
  resize(kFinderWidth, 60 + kRows * kFoundHeight);
  move(window_.width() - kFinderWidth - 12, 32);
  show();
  raise();
  typed_->setFocus();
}

void CommandFinder::list() {
  const QString typed = typed_->text().trimmed();
  struct Row {
    int score = 0;
    QAction* action = nullptr;
  };
  std::vector<Row> rows;
  std::set<QString> seen;
  for (QAction* action : window_.findChildren<QAction*>()) {
    const QString words = wordsOf(*action);
    if (!action->isEnabled() || action->isSeparator() || action->menu() || words.isEmpty()) continue;
    const int score = match(typed, words);
    if (score > 0 && seen.insert(words).second) rows.push_back({score, action});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.score != b.score ? a.score > b.score : wordsOf(*a.action) < wordsOf(*b.action);
  });
  found_->clear();
  actions_.clear();
  for (const Row& row : rows) {
    const QString key = row.action->shortcut().toString(QKeySequence::NativeText);
    auto* item = new QListWidgetItem(row.action->icon(),
                                     key.isEmpty() ? wordsOf(*row.action) : wordsOf(*row.action) + "   " + key, found_);
    item->setSizeHint(QSize(0, kFoundHeight));
    actions_.emplace_back(row.action);
  }
  found_->setCurrentRow(rows.empty() ? -1 : 0);
}

void CommandFinder::run() {
  const int row = found_->currentRow();
  const QPointer<QAction> action = row >= 0 ? actions_[static_cast<std::size_t>(row)] : nullptr;
  hide();
  if (focus_before_) focus_before_->setFocus();
  if (action) action->trigger();
}

bool CommandFinder::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) hide();
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step != 0 && found_->count() > 0) {
      found_->setCurrentRow(std::clamp(found_->currentRow() + step, 0, found_->count() - 1));
      return true;
    }
    if (key == Qt::Key_Escape) {
      hide();
      if (focus_before_) focus_before_->setFocus();
      return true;
    }
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace hapticell::app
