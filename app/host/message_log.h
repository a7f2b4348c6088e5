// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/style/library_text.h"
#include "geometry/system/error.h"

namespace hapticell::app {

enum class Severity { kInformation, kWarning, kProblem };

/// A remedy that the user can choose, as a button.
struct MessageAction {
  QString word;
  std::function<void()> act;
};

/// One of several details of a message; consecutive lines with the same `kind` are shown as a group.
struct MessageLine {
  QString kind;
  QString text;
  std::function<void()> act = {};  ///< Called on a click, e.g. to select the part in question; may be empty.
};

/// One thing the user should know: what happened, and below it where and what to do.
struct Message {
  Severity severity = Severity::kInformation;
  QString title;
  QString text;
  QDateTime when;
  std::vector<MessageAction> actions = {};
  /// If not empty, panels list these instead of `text`, unless it is one that equals `text` and does not act.
  std::vector<MessageLine> lines = {};
  QString english = {};                 ///< `text` in English, for the log file; empty: there is only the shown text.
};

/// The messages so far, newest last. They never open a dialog in front of the scene. GUI thread.
class MessageLog : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  void tell(Severity severity, const QString& title, const QString& text = {}, std::vector<MessageAction> actions = {},
            std::vector<MessageLine> lines = {}) {
    add({severity, title, text, QDateTime::currentDateTime(), std::move(actions), std::move(lines)});
  }
  /// Reports a text of the libraries: in the window's language here, in English in the log file.
  void reportCause(Severity severity, const QString& title, const Text& cause) {
    reportCause(severity, title, shownText(cause), english(cause));
  }
  /// The same for an error; `after` is appended to the shown text.
  void reportCause(Severity severity, const QString& title, const Error& cause, const QString& after = {}) {
    reportCause(severity, title, shownText(cause) + (after.isEmpty() ? after : QLatin1Char(' ') + after),
                cause.message());
  }
  const std::vector<Message>& messages() const { return messages_; }

 signals:
  void told(const hapticell::app::Message& message);

 private:
  void reportCause(Severity severity, const QString& title, const QString& text, const std::string& in_english) {
    add({severity, title, text, QDateTime::currentDateTime(), {}, {}, QString::fromStdString(in_english)});
  }
  void add(Message message) {
    messages_.push_back(std::move(message));
    emit told(messages_.back());
  }

  std::vector<Message> messages_;
};

}  // namespace hapticell::app
