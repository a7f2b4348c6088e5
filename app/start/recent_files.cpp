// SPDX-License-Identifier: Apache-2.0
#include "app/start/recent_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QStandardPaths>

#include "app/host/user_settings.h"
#include "app/host/written_file.h"

namespace hapticell::app {
namespace {

const QString kKey = QStringLiteral("recent/files");

QString pictureFile(const QString& path) {
  const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
      .filePath(QStringLiteral("pictures/%1.jpg").arg(QLatin1String(name)));
}

}  // namespace

QImage RecentFiles::picture(const QString& path) {
  return QImage(pictureFile(QFileInfo(path).absoluteFilePath()));
}

void RecentFiles::keepPicture(const QString& path, const QImage& picture) const {
  if (path.isEmpty() || picture.isNull() || !settings_.isKept()) return;
  const QString file = pictureFile(QFileInfo(path).absoluteFilePath());
  QDir().mkpath(QFileInfo(file).path());
  (void)writePicture(picture, file, 85);
}

QStringList RecentFiles::files() const {
  QStringList there;
  for (const QString& path : settings_.value(kKey).toStringList())
    if (QFileInfo::exists(path)) there << path;
  return there;
}

void RecentFiles::add(const QString& path) {
  if (path.isEmpty()) return;
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList list = settings_.value(kKey).toStringList();
  list.removeAll(whole);
  list.prepend(whole);
  settings_.setValue(kKey, list.mid(0, kMost));
}

void RecentFiles::clear() {
  settings_.remove(kKey);
}

void RecentFiles::fill(QMenu& menu) {
  connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
    menu.clear();
    const QStringList list = files();
    for (const QString& path : list) {
      const QFileInfo info(path);
      // The folder too: cells of different stations often have one name.
      QAction* action =
          menu.addAction(tr("%1 – %2").arg(info.fileName(), QDir::toNativeSeparators(info.absolutePath())));
      connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    if (list.isEmpty()) menu.addAction(tr("Nothing was opened yet"))->setEnabled(false);
    if (list.isEmpty()) return;
    menu.addSeparator();
    connect(menu.addAction(tr("Forget these")), &QAction::triggered, this, &RecentFiles::clear);
  });
  // A menu without entries is not opened at all.
  menu.addAction(tr("Nothing was opened yet"))->setEnabled(false);
}

}  // namespace hapticell::app
