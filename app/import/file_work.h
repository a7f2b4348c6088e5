// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/import/document_opener.h"
#include "app/import/import_session.h"

class QDockWidget;

namespace hapticell::app {

class Host;
class ImportPanel;

/// Everything of the window that reads files: opening workcells, importing solids, assemblies and robots, telling what
/// came of it. No file is read in the window's thread; what was read changes the document at one stroke. GUI thread.
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
  bool isBusy() const { return opener_.isBusy() || session_.isBusy(); }
  ImportSession& session() { return session_; }
  QDockWidget& dock() { return *dock_; }

 signals:
  /// A workcell was opened, or not.
  void opened(const QString& path, bool done);
  /// An import ended and is in the cell, or not.
  void imported(const QString& path, bool done);

 private:
  void takeOpened(const std::shared_ptr<OpenedDocument>& opened, const QString& path);
  void takeImported(const QString& path, const ImportSession::Result& result);
  void tellReport(const QString& name, const workcell::ImportReport& report);
  void tellError(const QString& title, const Error& error);
  void offerMissing(const std::vector<std::filesystem::path>& missing);
  void findMissing();
  void showOpening();
  void showPanel();
  void raisePanel();

  Host& host_;
  ImportSession session_;
  DocumentOpener opener_;
  ImportPanel* panel_;
  QDockWidget* dock_;
  QTimer patience_;
};

}  // namespace hapticell::app
