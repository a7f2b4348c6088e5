// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QObject>
#include <QProcess>

namespace hapticell::app {

/// One job of hapticell-ros2 as a child process: JSON lines in both directions. However the window ends, the job is
/// asked to end, and so cancels what it sent. GUI thread.
class Ros2Process : public QObject {
  Q_OBJECT
 public:
  explicit Ros2Process(QObject* parent = nullptr);
  /// Asks it to end and waits for at most 6 s, as long as a robot has to confirm its stop.
  ~Ros2Process() override;
  void start(const QJsonObject& job);
  /// A line for its standard input; does nothing while it does not run.
  void write(const QJsonObject& line);
  /// Asks it to end; ended() follows.
  void stop();
  bool isRunning() const { return process_.state() != QProcess::NotRunning; }

 signals:
  void said(const QJsonObject& line);
  /// `result` is the last line of a job that did what it should; else it is empty, and the sentence says why.
  void ended(const QJsonObject& result, const QString& sentence);

 private:
  void readLines();
  void finish();

  QProcess process_;
  QJsonObject last_;
  QString failure_;
};

}  // namespace hapticell::app
