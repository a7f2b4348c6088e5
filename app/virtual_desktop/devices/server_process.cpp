// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/server_process.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

#include "app/style/plain_lines.h"

#ifdef Q_OS_LINUX
#include <sys/prctl.h>

#include <csignal>
#endif

namespace hapticell::app {

ServerProcess::ServerProcess(QObject* parent) : QObject(parent) {
  process_.setProcessChannelMode(QProcess::MergedChannels);
#ifdef Q_OS_LINUX
  // However the window ends, its server ends too: forces are never left on.
  process_.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
#endif
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      emit ended(
          tr("The haptic server could not be started: %1 was not found or cannot be run.").arg(process_.program()));
  });
  connect(&process_, &QProcess::finished, this, [this] {
    if (stopping_) return;
    readLines();
    last_line_ += plainLines(QString::fromUtf8(process_.readAll()).trimmed());
    emit ended(tr("The haptic server has stopped. %1").arg(last_line_));
  });
  connect(&process_, &QProcess::readyRead, this, &ServerProcess::readLines);
}

ServerProcess::~ServerProcess() {
  stop();
}

QString ServerProcess::warningIn(const QString& line) {
  // At its place only: names of clients stand in the lines too.
  static const QRegularExpression head(QStringLiteral("^\\d\\d:\\d\\d:\\d\\d\\.\\d{3} warning: "));
  const QRegularExpressionMatch found = head.match(line);
  return found.hasMatch() ? line.mid(found.capturedEnd()) : QString();
}

void ServerProcess::readLines() {
  while (process_.canReadLine()) {
    last_line_ = plainLines(QString::fromUtf8(process_.readLine()).trimmed());
    const QString warning = warningIn(last_line_);
    if (warning.isEmpty()) continue;
    emit warned(warning);
    last_line_.clear();  // Told already.
  }
}

void ServerProcess::start(const QString& device, int port) {
  if (isRunning()) return;
  stopping_ = false;
  last_line_.clear();
  QStringList arguments{"--port", QString::number(port)};
  if (!device.isEmpty()) arguments << "--device" << device;
  process_.start(QDir(QCoreApplication::applicationDirPath()).filePath("hapticell-haptic-server"), arguments);
}

void ServerProcess::stop() {
  if (!isRunning()) return;
  stopping_ = true;
  process_.terminate();
  if (!process_.waitForFinished(1500)) {
    process_.kill();
    process_.waitForFinished(1000);
  }
}

}  // namespace hapticell::app
