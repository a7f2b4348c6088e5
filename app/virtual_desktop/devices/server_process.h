// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QProcess>

namespace hapticell::app {

/// The haptic server as a child process, for the case that none answers. It ends with this object. GUI thread.
class ServerProcess : public QObject {
  Q_OBJECT
 public:
  explicit ServerProcess(QObject* parent = nullptr);
  ~ServerProcess() override;
  /// Starts hapticell-haptic-server from the program's folder with a device profile (empty: its default).
  void start(const QString& device, int port);
  void stop();
  /// The text of a warning in a line of the server's log; empty if the line is not a warning.
  static QString warningIn(const QString& line);
  bool isRunning() const { return process_.state() != QProcess::NotRunning; }

 signals:
  /// It could not be started, or ended without a request: what happened, as a sentence.
  void ended(const QString& sentence);

 signals:
  /// It reported a warning about the device or the force loop.
  void warned(const QString& sentence);

 private:
  void readLines();

  QProcess process_;
  QString last_line_;
  bool stopping_ = false;
};

}  // namespace hapticell::app
