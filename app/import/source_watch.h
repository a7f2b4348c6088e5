// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QSet>
#include <QTimer>

#include "app/host/document_model.h"

namespace hapticell::app {

/// Watches the source files of the document's entities and reports when their content changes. GUI thread.
class SourceWatch : public QObject {
  Q_OBJECT
 public:
  explicit SourceWatch(DocumentModel& document, QObject* parent = nullptr);

 signals:
  /// Emitted once the files have not been written for a while.
  void changed(const QStringList& paths);

 private:
  void follow();
  void note(const QString& path);

  DocumentModel& document_;
  QFileSystemWatcher watcher_;
  QSet<QString> noted_;
  QTimer quiet_, refresh_;
};

}  // namespace hapticell::app
