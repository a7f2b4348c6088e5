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

/// Everything in the window that reads files: opening workcells, importing solids, assemblies and robots, reading them
/// again, and reporting the result. No file is read in the window's thread; what was read changes the document in one
/// step. GUI thread.
class FileWork : public QObject {
  Q_OBJECT
 public:
  explicit FileWork(Host& host, QObject* parent = nullptr);

  /// Opens a workcell in place of the present one once it is read; on failure the old one stays. Emits opened().
  void open(const QString& path);
  /// Imports files; `ask`: shows each in the import panel first.
  void import(const QStringList& paths, bool ask);
  /// Opens an empty document; cancels running work.
  void clear();
  /// Reads the files of these entities again; placements do not change.
  void reload(const std::vector<std::string>& paths);
  void reloadSelected();
  /// Unsaved work of earlier runs that crashed, newest first, without what the user put off.
  std::vector<workcell::LeftWork> leftWork() const;
  /// Opens it in place of the present document, as unsaved. If that fails, it is kept and leftWorkChanged() is
  /// emitted.
  void restore(const workcell::LeftWork& left);
  /// Deletes the copies of that run.
  void discardLeft(const std::filesystem::path& run);
  /// Hides the copies of that run until the next start.
  void putOffLeft(const std::filesystem::path& run);
  /// Reports in the messages if the document at this path (empty: any) has unsaved work from a crash.
  void reportUnsavedCopies(const QString& path);
  bool isBusy() const { return opener_.isBusy() || session_.isBusy() || background_.isBusy(); }
  Autosaver& autosaver() { return autosaver_; }
  DocumentGuard& guard() { return guard_; }
  ExportWork& exports() { return exports_; }
  BackgroundWork& background() { return background_; }
  ImportSession& session() { return session_; }
  QDockWidget& dock() { return *dock_; }
  /// Opens the panel *Mesh* for the selected solid.
  void showMeshCare();

 signals:
  /// Opening a workcell ended; `done`: it is open.
  void opened(const QString& path, bool done);
  /// An import ended; `done`: it is in the cell.
  void imported(const QString& path, bool done);
  /// Asks to offer unsaved work of earlier runs again: restoring was cancelled or failed, or the user asks for it.
  void leftWorkChanged();

 private:
  void takeOpened(const std::shared_ptr<OpenedDocument>& opened, const QString& path);
  void takeImported(const QString& path, const ImportSession::Result& result);
  void reportImport(const QString& name, const workcell::ImportReport& report, const NamedParts& parts);
  /// Reports all in one message, grouped by kind; a click on a line selects the parts that it names.
  void reportRemarks(const QString& name, const std::vector<Text>& remarks, const NamedParts& parts);
  NamedParts partsOfCell() const;
  void select(const std::vector<workcell::EntityId>& parts);
  void reportError(const QString& title, const Error& error);
  void offerReload(const QStringList& paths);
  void cancelOther();
  /// Shows a message with buttons, and brings the messages to the front if that does not disturb.
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
  DocumentGuard guard_;  // Must precede the members that use it.
  Autosaver autosaver_;
  SourceWatch watch_;
  ImportPanel* panel_;
  QDockWidget *dock_, *mesh_dock_;
  QTimer patience_;
  std::filesystem::path restored_;              ///< The run whose work is being opened.
  std::vector<std::filesystem::path> put_off_;  ///< Runs that the user put off.
};

}  // namespace hapticell::app
