// SPDX-License-Identifier: Apache-2.0
#include "app/console/script_files.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "config/user_folders.h"
#include "geometry/system/atomic_file.h"

namespace hapticell::app {

QString scriptFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/hapticell/scripts");
}

QStringList scriptNames() {
  return QDir(scriptFolder()).entryList({QStringLiteral("*.py")}, QDir::Files | QDir::Readable, QDir::Name);
}

Expected<QString> writeScript(const QString& name, const std::string& text) {
  HAPTICELL_TRY(config::makeOwnFolder(scriptFolder().toStdString()));
  const QDir folder(scriptFolder());
  QString path = folder.filePath(name + QStringLiteral(".py"));
  for (int number = 2; QFileInfo::exists(path); ++number)
    path = folder.filePath(QStringLiteral("%1-%2.py").arg(name).arg(number));
  HAPTICELL_TRY(writeFileAtomically(path.toStdString(), text));
  return path;
}

}  // namespace hapticell::app
