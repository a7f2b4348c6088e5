// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>

#include "app/host/message_log.h"

class QLabel;
class QVBoxLayout;

namespace hapticell::app {

/// One message as a card: bar and icon by severity, what happened, and below that where and what to do.
class MessageCard : public QWidget {
  Q_OBJECT
 public:
  explicit MessageCard(const Message& message, QWidget* parent = nullptr);
  /// The same message was repeated.
  void countAgain();
  const Message& message() const { return message_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Message message_;
  QLabel* when_;
  int times_ = 1;
};

/// All messages, newest first.
class MessagesPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit MessagesPanel(MessageLog& log, QWidget* parent = nullptr);
  int cardCount() const;

 private:
  void add(const Message& message);
  QVBoxLayout* column_;
  QLabel* foot_;
};

}  // namespace hapticell::app
