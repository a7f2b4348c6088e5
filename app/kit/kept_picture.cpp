// SPDX-License-Identifier: Apache-2.0
#include "app/kit/kept_picture.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/kit/written_file.h"

namespace hapticell::app {
namespace {

QString pictureFile(const QString& path) {
  const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
      .filePath(QStringLiteral("pictures/%1.jpg").arg(QLatin1String(name)));
}

}  // namespace

QImage keptPicture(const QString& path) {
  return QImage(pictureFile(QFileInfo(path).absoluteFilePath()));
}

void storePicture(const QString& path, const QImage& picture) {
  const QString file = pictureFile(QFileInfo(path).absoluteFilePath());
  QDir().mkpath(QFileInfo(file).path());
  (void)writePicture(picture, file, 85);
}

}  // namespace hapticell::app
