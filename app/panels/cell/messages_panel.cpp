// SPDX-License-Identifier: Apache-2.0
#include "app/panels/cell/messages_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/controls/severity_face.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/plain_lines.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

// Cards and lines of a message that are kept: memory and time of the panel. Half, twice: older messages go earlier or
// later.
constexpr int kMostCards = 100, kMostLines = 200;

QString severityName(Severity severity) {
  if (severity == Severity::kProblem) return MessageCard::tr("Problem");
  return severity == Severity::kWarning ? MessageCard::tr("Warning") : MessageCard::tr("Note");
}

/// Keeps a list as high as its rows, up to some of them.
void fitHeight(QTreeWidget& list) {
  constexpr int kMostRows = 10;
  int rows = 0;
  for (auto* item = list.topLevelItem(0); item && rows < kMostRows; item = list.itemBelow(item)) ++rows;
  list.setFixedHeight(rows * list.sizeHintForRow(0) + 2 * list.frameWidth() + 2);
}

/// The lines of a message: those of one kind below a row that says the kind and how many there are. A click acts.
QTreeWidget* makeLineList(const std::vector<MessageLine>& lines) {
  auto* list = new QTreeWidget;
  list->setObjectName("messageLines");
  list->setHeaderHidden(true);
  list->setUniformRowHeights(true);
  list->setTextElideMode(Qt::ElideRight);
  QTreeWidgetItem* group = nullptr;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const bool begins = k == 0 || lines[k].kind != lines[k - 1].kind;
    const auto ends = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(k), lines.end(),
                                   [&](const MessageLine& line) { return line.kind != lines[k].kind; });
    const auto count = ends - (lines.begin() + static_cast<std::ptrdiff_t>(k));
    if (begins) {
      group =
          count > 1 ? new QTreeWidgetItem(list, {QStringLiteral("%1 (%2)").arg(lines[k].kind).arg(count)}) : nullptr;
    }
    auto* item = group ? new QTreeWidgetItem(group) : new QTreeWidgetItem(list);
    item->setText(0, lines[k].text);
    item->setToolTip(0, lines[k].text);
    item->setData(0, Qt::UserRole, static_cast<int>(k));
  }
  list->setRootIsDecorated(std::any_of(lines.begin(), lines.end(), [&](const MessageLine& line) {
    return std::count_if(lines.begin(), lines.end(), [&](const MessageLine& one) { return one.kind == line.kind; }) > 1;
  }));
  const auto act = [lines](QTreeWidgetItem* item) {
    const QVariant number = item->data(0, Qt::UserRole);
    if (!number.isValid()) return item->setExpanded(!item->isExpanded());
    const MessageLine& line = lines[static_cast<std::size_t>(number.toInt())];
    if (line.act) line.act();
  };
  QObject::connect(list, &QTreeWidget::itemClicked, list, act);
  QObject::connect(list, &QTreeWidget::itemExpanded, list, [list] { fitHeight(*list); });
  QObject::connect(list, &QTreeWidget::itemCollapsed, list, [list] { fitHeight(*list); });
  fitHeight(*list);
  return list;
}

}  // namespace

MessageCard::MessageCard(const Message& message, QWidget* parent) : QWidget(parent), message_(message) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(42, 8, 12, 8);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  auto* title = makeLabel(plainLines(message.title), TextRole::kSection);
  title->setWordWrap(true);
  title->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words->addWidget(title);
  const bool whole = message.lines.size() == 1 && !message.lines[0].act && message.lines[0].text == message.text;
  if (!message.lines.empty() && !whole) {
    words->addWidget(makeLineList(message.lines));
  } else if (!message.text.isEmpty()) {
    auto* text = makeLabel(plainLines(message.text, kMostLines), TextRole::kSecond, true);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(text);
  }
  row->addLayout(words, 1);
  std::vector<QPushButton*> buttons;
  for (const MessageAction& action : message.actions) {
    auto* button = new QPushButton(action.word);
    row->addWidget(button, 0, Qt::AlignTop);
    buttons.push_back(button);
  }
  for (std::size_t k = 0; k < buttons.size(); ++k) {
    connect(buttons[k], &QPushButton::clicked, this, [act = message.actions[k].act, buttons] {
      for (QPushButton* button : buttons) button->setEnabled(false);  // Each offer is taken once.
      act();
    });
  }
  when_ = makeLabel(message.when.toString("HH:mm:ss"), TextRole::kSecond, true);
  row->addWidget(when_, 0, Qt::AlignTop);
  setAccessibleName(severityName(message.severity) + QStringLiteral(": ") + plainLines(message.title));
}

void MessageCard::countAgain() {
  when_->setText(tr("%1 times, last %2").arg(++times_).arg(QDateTime::currentDateTime().toString("HH:mm:ss")));
}

void MessageCard::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  const QColor color = severityColor(message_.severity, theme);
  drawBox(&painter, rect(), theme.header, theme.line, 2.0);
  painter.fillRect(QRect(0, 0, 3, height()), color);
  icon(severityIcon(message_.severity), color).paint(&painter, QRect(14, 9, 18, 18));
}

MessagesPanel::MessagesPanel(MessageLog& log, QWidget* parent) : QScrollArea(parent) {
  setObjectName("messages");
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget;
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(12, 12, 12, 12);
  column_->setSpacing(8);
  foot_ = makeLabel({}, TextRole::kSecond, true);
  column_->addWidget(foot_);
  column_->addStretch(1);
  setWidget(content);
  foot_->setText(tr("No messages yet."));
  for (const Message& message : log.messages()) add(message);
  connect(&log, &MessageLog::told, this, &MessagesPanel::add);
}

int MessagesPanel::cardCount() const {
  return column_->count() - 2;
}

void MessagesPanel::add(const Message& message) {
  auto* newest = cardCount() > 0 ? qobject_cast<MessageCard*>(column_->itemAt(0)->widget()) : nullptr;
  if (newest && newest->message().title == message.title && newest->message().text == message.text)
    return newest->countAgain();
  column_->insertWidget(0, new MessageCard(message));
  if (cardCount() > kMostCards) {
    QLayoutItem* oldest = column_->takeAt(cardCount() - 1);
    oldest->widget()->deleteLater();
    delete oldest;
  }
  foot_->setText(tr("The newest message also appears in the status bar for 8 seconds."));
}

}  // namespace hapticell::app
