// SPDX-License-Identifier: Apache-2.0
#include "app/start/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include "app/host/user_settings.h"
#include "app/kit/kept_picture.h"

namespace hapticell::app {
namespace {

const QString kKey = QStringLiteral("recent/files");

}  // namespace

void RecentFiles::keepPicture(const QString& path, const QImage& picture) const {
  if (path.isEmpty() || picture.isNull() || !settings_.isKept()) return;
  storePicture(path, picture);
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
    if (list.isEmpty()) menu.addAction(tr("No recent files"))->setEnabled(false);
    if (list.isEmpty()) return;
    menu.addSeparator();
    connect(menu.addAction(tr("Clear the list")), &QAction::triggered, this, &RecentFiles::clear);
  });
  // A menu without entries is not opened at all.
  menu.addAction(tr("No recent files"))->setEnabled(false);
}

}  // namespace hapticell::app
