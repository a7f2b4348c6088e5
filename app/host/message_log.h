// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

namespace hapticell::app {

enum class Severity { kInformation, kWarning, kProblem };

/// What the user can do about it, as a button.
struct MessageAction {
  QString word;
  std::function<void()> act;
};

/// One of many details of a message; lines of one `kind` that follow each other are shown as a group.
struct MessageLine {
  QString kind;
  QString text;
  std::function<void()> act = {};  ///< When it is clicked, e.g. select the part meant; may be empty.
};

/// One thing the user should know: what happened, and below it where and what to do.
struct Message {
  Severity severity = Severity::kInformation;
  QString title;
  QString text;
  QDateTime when;
  std::vector<MessageAction> actions = {};
  std::vector<MessageLine> lines = {};  ///< Where there are any, panels list them instead of `text`.
};

/// The messages so far, newest last. Never a window in front of the scene. GUI thread.
class MessageLog : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  void tell(Severity severity, const QString& title, const QString& text = {},
            std::vector<MessageAction> actions = {}, std::vector<MessageLine> lines = {}) {
    messages_.push_back({severity, title, text, QDateTime::currentDateTime(), std::move(actions), std::move(lines)});
    emit told(messages_.back());
  }
  const std::vector<Message>& messages() const { return messages_; }

 signals:
  void told(const hapticell::app::Message& message);

 private:
  std::vector<Message> messages_;
};

}  // namespace hapticell::app
