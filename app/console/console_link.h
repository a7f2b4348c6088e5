// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <optional>

#include "app/console/cell_exchange.h"

namespace hapticell::app {

/// The interpreter: a process python3 with the package hapticell, spoken to in lines of JSON over its pipes. Nothing that
/// happens in it touches the window; if it ends it is started again. GUI thread; nothing waits.
class ConsoleLink : public QObject {
  Q_OBJECT
 public:
  enum class State { kOff, kStarting, kReady, kRunning, kMissing };

  explicit ConsoleLink(QObject* parent = nullptr);
  /// Ends the interpreter.
  ~ConsoleLink() override;

  State state() const { return state_; }
  const QString& version() const { return version_; }
  /// Starts the interpreter unless it is there. Without Python or its package: State::kMissing, and failed().
  void start();
  /// Runs statements; at their end finished(), or moreWanted() if they are not complete. `cell`: the cell, where it is
  /// another than at the last call. @pre state() is kReady
  void run(const QString& source, const std::optional<CellText>& cell, const QStringList& selection);
  /// The same for a file.
  void runScript(const QString& file, const std::optional<CellText>& cell, const QStringList& selection);
  /// Asks for completions of the text before the cursor: completed(). Does nothing unless state() is kReady.
  void complete(const QString& text);
  /// Interrupts what runs (KeyboardInterrupt); asked again before that has ended, the interpreter is ended and started
  /// again. Does nothing unless state() is kRunning.
  void interrupt();

 signals:
  void stateChanged();
  void printed(const QString& text, bool is_error);
  void moreWanted();
  /// What was sent is complete and runs.
  void begun();
  /// What ran has ended. `text`: of the cell, if it was changed; `step`: its name where it was one.
  void finished(const std::optional<std::string>& text, const QString& step);
  void completed(const QString& before, int start, const QStringList& words);
  /// The interpreter has ended by itself, with a sentence; the next one starts.
  void ended(const QString& sentence);
  /// It cannot be had: a sentence with what to install.
  void failed(const QString& sentence);

 private:
  void setState(State state);
  void send(QJsonObject message);
  void sendWork(QJsonObject message, const std::optional<CellText>& cell, const QStringList& selection);
  void read();
  void hear(const QJsonObject& message);
  void end(int code, QProcess::ExitStatus status);
  void cannotStart(const QString& sentence);

  QProcess process_;
  State state_ = State::kOff;
  QString version_;
  QByteArray line_;         ///< The beginning of a message.
  QByteArray errors_;       ///< What it said before it was ready.
  QString completing_;      ///< The text that completions are awaited for.
  int number_ = 0;          ///< Of the last message.
  bool interrupted_ = false, killed_ = false;
};

}  // namespace hapticell::app
