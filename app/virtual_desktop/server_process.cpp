// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/server_process.h"

#include <QCoreApplication>
#include <QDir>

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
          tr("The haptic server could not be started: %1 is not there or may not be run.").arg(process_.program()));
  });
  connect(&process_, &QProcess::finished, this, [this] {
    if (stopping_) return;
    readLines();
    last_line_ += QString::fromUtf8(process_.readAll()).trimmed();
    emit ended(tr("The haptic server has ended. %1").arg(last_line_));
  });
  connect(&process_, &QProcess::readyRead, this, &ServerProcess::readLines);
}

ServerProcess::~ServerProcess() {
  stop();
}

void ServerProcess::readLines() {
  const QString mark = QStringLiteral(" warning: ");
  while (process_.canReadLine()) {
    last_line_ = QString::fromUtf8(process_.readLine()).trimmed();
    const qsizetype at = last_line_.indexOf(mark);
    if (at >= 0) emit warned(last_line_.mid(at + mark.size()));
    if (at >= 0) last_line_.clear();  // Told already.
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
