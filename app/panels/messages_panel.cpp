// SPDX-License-Identifier: Apache-2.0
#include "app/panels/messages_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/panels/form.h"
#include "app/style/icon.h"
#include "app/style/plain_lines.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kMostCards = 100, kMostLines = 200;

QColor colorOf(Severity severity, const Theme& theme) {
  return severity == Severity::kProblem   ? theme.contact
         : severity == Severity::kWarning ? theme.near_miss
                                          : theme.selection;
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
  if (!message.text.isEmpty()) {
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
  const QString kind = message.severity == Severity::kProblem   ? tr("Problem")
                       : message.severity == Severity::kWarning ? tr("Warning")
                                                                : tr("Note");
  setAccessibleName(kind + QStringLiteral(": ") + plainLines(message.title));
}

void MessageCard::countAgain() {
  when_->setText(tr("%1 times, last %2").arg(++times_).arg(QDateTime::currentDateTime().toString("HH:mm:ss")));
}

void MessageCard::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  const QColor color = colorOf(message_.severity, theme);
  drawBox(&painter, rect(), theme.header, theme.line, 2.0);
  painter.fillRect(QRect(0, 0, 3, height()), color);
  const char* name = message_.severity == Severity::kProblem   ? "crossed"
                     : message_.severity == Severity::kWarning ? "warning"
                                                               : "info";
  icon(name, color).paint(&painter, QRect(14, 9, 18, 18));
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
  foot_->setText(tr("Never in front of the scene. The newest also stands in the status bar for 8 seconds."));
}

}  // namespace hapticell::app
