// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/host/background_work.h"
#include "app/host/message_log.h"
#include "app/import/autosaver.h"
#include "app/import/document_guard.h"
#include "app/import/document_opener.h"
#include "app/import/export_work.h"
#include "app/import/import_session.h"
#include "app/import/remark_lines.h"
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
  /// Unsaved work that earlier runs left at a crash, newest first, without what was put off.
  std::vector<workcell::LeftWork> leftWork() const;
  /// Opens it in place of the present document, as unsaved; where that fails it is left as it was, and
  /// leftWorkChanged() tells.
  void restore(const workcell::LeftWork& left);
  /// Removes what that run left.
  void discardLeft(const std::filesystem::path& run);
  /// Not now: it is offered again at the next start.
  void putOffLeft(const std::filesystem::path& run);
  /// Says in the messages that the document at this path (empty: any) has unsaved work from a crash, if it has.
  void reportUnsavedCopies(const QString& path);
  bool isBusy() const { return opener_.isBusy() || session_.isBusy() || background_.isBusy(); }
  Autosaver& autosaver() { return autosaver_; }
  DocumentGuard& guard() { return guard_; }
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
  /// There is left work to be seen to again: a restoring was cancelled or failed, or the user asks for it.
  void leftWorkChanged();

 private:
  void takeOpened(const std::shared_ptr<OpenedDocument>& opened, const QString& path);
  void takeImported(const QString& path, const ImportSession::Result& result);
  void reportImport(const QString& name, const workcell::ImportReport& report, const NamedParts& parts);
  /// All as one message, grouped by kind; a click on one selects the parts that it names.
  void reportRemarks(const QString& name, const std::vector<Text>& remarks, const NamedParts& parts);
  NamedParts partsOfCell() const;
  void select(const std::vector<workcell::EntityId>& parts);
  void reportError(const QString& title, const Error& error);
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
  DocumentGuard guard_;  // Before what asks it.
  Autosaver autosaver_;
  SourceWatch watch_;
  ImportPanel* panel_;
  QDockWidget *dock_, *mesh_dock_;
  QTimer patience_;
  std::filesystem::path restored_;              ///< The run whose work is being opened.
  std::vector<std::filesystem::path> put_off_;  ///< Runs.
};

}  // namespace hapticell::app
