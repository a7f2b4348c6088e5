// SPDX-License-Identifier: Apache-2.0
#include "app/kit/system_open.h"

#include <QFileInfo>
#include <QProcess>

#include "config/user_folders.h"

namespace hapticell::app {

bool openWithSystem(const QString& path) {
  const auto program = config::systemProgram("xdg-open");
  if (program.empty()) return false;
  return QProcess::startDetached(QString::fromStdString(program.string()), {QFileInfo(path).absoluteFilePath()});
}

}  // namespace hapticell::app
