// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/server_process.h"

#include <QCoreApplication>
#include <QDir>

namespace hapticell::app {

ServerProcess::ServerProcess(QObject* parent) : QObject(parent) {
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      emit ended(
          tr("The haptic server could not be started: %1 is not there or may not be run.").arg(process_.program()));
  });
  connect(&process_, &QProcess::finished, this, [this] {
    if (stopping_) return;
    const QString last = QString::fromUtf8(process_.readAll()).trimmed().section('\n', -1);
    emit ended(tr("The haptic server has ended. %1").arg(last));
  });
}

ServerProcess::~ServerProcess() {
  stop();
}

void ServerProcess::start(const QString& device, int port) {
  if (isRunning()) return;
  stopping_ = false;
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
