// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "app/host/message_log.h"
#include "config/program_log.h"

namespace hapticell::app {

class FileWork;
class ViewportWidget;

/// What the window writes into its log file: its start, OpenGL, files, messages, the device, actions (level debug) and
/// its end. Titles of messages are in the window's language, errors in English. GUI thread.
class WindowLog : public QObject {
 public:
  /// `program`: its version, commit, compiler and libraries, in lines.
  WindowLog(std::unique_ptr<config::ProgramLog> log, const std::string& program);
  ~WindowLog() override;

  void follow(ViewportWidget& viewport);
  void follow(FileWork& files);
  void follow(MessageLog& messages);
  void noteSaved(const QString& path);
  /// Logs each change of the status bar's device text. `works`: false if no device is connected or forces are lost.
  void noteDevice(const QString& text, bool works);
  void noteAction(const QString& name);

 private:
  void write(config::LogLevel level, const QString& sentence);
  void noteMessage(const Message& message);

  const std::unique_ptr<config::ProgramLog> log_;
  QString device_;
};

}  // namespace hapticell::app
