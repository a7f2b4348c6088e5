// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/host/message_log.h"
#include "app/import/autosaver.h"
#include "app/import/background_work.h"
#include "app/import/document_opener.h"
#include "app/import/export_work.h"
#include "app/import/import_session.h"
#include "app/import/source_watch.h"

class QDockWidget;

namespace hapticell::app {

class Host;
class ImportPanel;

/// Everything of the window that reads files: opening workcells, importing solids, assemblies and robots, reading them
/// again, and telling what came of it. No file is read in the window's thread; what was read changes the document at
/// one stroke. GUI thread.
class FileWork : public QObject {
  Q_OBJECT
 public:
  explicit FileWork(Host& host, QObject* parent = nullptr);

  /// Opens a workcell in place of the present one once it is read; on failure the old one stays. opened() tells.
  void open(const QString& path);
  /// Imports files; `ask`: after showing each in the import panel.
  void import(const QStringList& paths, bool ask);
  /// An empty document; what was under way is given up.
  void clear();
  /// Reads the files of these entities again; placements stay.
  void reload(const std::vector<std::string>& paths);
  void reloadSelected();
  /// At the program's begin: whether an unsaved new workcell was left by a crash.
  void offerLeftOver();
  bool isBusy() const { return opener_.isBusy() || session_.isBusy() || background_.isBusy(); }
  Autosaver& autosaver() { return autosaver_; }
  ExportWork& exports() { return exports_; }
  BackgroundWork& background() { return background_; }
  ImportSession& session() { return session_; }
  QDockWidget& dock() { return *dock_; }
  /// Opens the panel that looks after the selected solid's mesh.
  void showMeshCare();

 signals:
  /// A workcell was opened, or not.
  void opened(const QString& path, bool done);
  /// An import ended and is in the cell, or not.
  void imported(const QString& path, bool done);

 private:
  void takeOpened(const std::shared_ptr<OpenedDocument>& opened, const QString& path);
  void takeImported(const QString& path, const ImportSession::Result& result);
  void tellReport(const QString& name, const workcell::ImportReport& report);
  /// All as one message: long lists would bury what is asked.
  void tellRemarks(const QString& name, const std::vector<std::string>& remarks);
  void tellError(const QString& title, const Error& error);
  void offerCopies(const QString& path);
  void restore(const QString& copy, const QString& path);
  void offerReload(const QStringList& paths);
  void cancelOther();
  /// Tells something with buttons, and brings the messages to the front where that is no disturbance.
  void offer(Severity severity, const QString& title, const QString& text, std::vector<MessageAction> actions);
  void offerMissing(const std::vector<std::filesystem::path>& missing);
  void findMissing();
  void showOther();
  void showPanel();
  void raisePanel();
  void raiseDock(QDockWidget& dock, QSize size);

  Host& host_;
  ImportSession session_;
  DocumentOpener opener_;
  BackgroundWork background_;
  ExportWork exports_;
  Autosaver autosaver_;
  SourceWatch watch_;
  ImportPanel* panel_;
  QDockWidget *dock_, *mesh_dock_;
  QTimer patience_;
  QString restored_;  ///< The copy that is being opened.
};

}  // namespace hapticell::app
