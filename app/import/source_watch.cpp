// SPDX-License-Identifier: Apache-2.0
#include "app/import/source_watch.h"

#include <QFileInfo>

#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {
// ms without a change until a file counts as written: programs write in pieces. Half: slow programs' files are read
// half; twice: one waits.
constexpr int kQuiet = 700;
// ms: a drag changes the document sixty times a second; its files change seldom. Half: twice the work; twice: a new
// file is watched a second later.
constexpr int kFollow = 500;
}  // namespace

SourceWatch::SourceWatch(DocumentModel& document, QObject* parent) : QObject(parent), document_(document) {
  quiet_.setSingleShot(true);
  quiet_.setInterval(kQuiet);
  refresh_.setSingleShot(true);
  refresh_.setInterval(kFollow);
  connect(&document_, &DocumentModel::changed, this, [this] {
    if (!refresh_.isActive()) refresh_.start();
  });
  connect(&refresh_, &QTimer::timeout, this, &SourceWatch::follow);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &SourceWatch::note);
  connect(&quiet_, &QTimer::timeout, this, [this] {
    QStringList paths;
    for (const QString& path : noted_)
      if (QFileInfo::exists(path)) paths << path;
    noted_.clear();
    follow();  // A file that was moved into place is another one for the watcher.
    paths.sort();
    if (!paths.isEmpty()) emit changed(paths);
  });
}

void SourceWatch::note(const QString& path) {
  noted_.insert(path);
  quiet_.start();
}

void SourceWatch::follow() {
  QSet<QString> wanted;
  for (const auto& entity : document_.document().state().entities) {
    const std::string& path = entity->source.path;
    if (!path.empty() && !workcell::isBuiltIn(path)) wanted.insert(QString::fromStdString(path));
  }
  const QStringList watched = watcher_.files();
  QStringList gone, fresh;
  for (const QString& path : watched)
    if (!wanted.contains(path)) gone << path;
  for (const QString& path : wanted)
    if (!watched.contains(path) && QFileInfo::exists(path)) fresh << path;
  if (!gone.isEmpty()) watcher_.removePaths(gone);
  if (!fresh.isEmpty()) watcher_.addPaths(fresh);
}

}  // namespace hapticell::app
