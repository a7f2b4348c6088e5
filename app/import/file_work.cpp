// SPDX-License-Identifier: Apache-2.0
#include "app/import/file_work.h"

#include <QDir>
#include <QDirIterator>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/import/import_panel.h"
#include "app/import/import_report_text.h"
#include "app/style/dock_title_bar.h"
#include "app/viewport/viewport_widget.h"
#include "workcell/document_io.h"

namespace hapticell::app {
namespace {

constexpr int kPatience = 400;  // Milliseconds of work without choices before the panel shows itself.

/// Where in `folder` or below it a file of that name is. Looks at 100,000 files at most.
std::optional<std::filesystem::path> findBelow(const QString& folder, const std::filesystem::path& missing) {
  const QString name = QString::fromStdString(missing.filename().string());
  if (QFileInfo::exists(QDir(folder).filePath(name))) return QDir(folder).filePath(name).toStdString();
  QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
  for (int count = 0; files.hasNext() && count < 100'000; ++count) {
    files.next();
    if (files.fileName() == name) return files.filePath().toStdString();
  }
  return std::nullopt;
}

}  // namespace

FileWork::FileWork(Host& host, QObject* parent) : QObject(parent), host_(host) {
  panel_ = new ImportPanel(session_);
  dock_ = makeDock("dockImport", tr("Import"), panel_);
  host_.addDock(dock_, Qt::RightDockWidgetArea);
  dock_->setAttribute(Qt::WA_ShowWithoutActivating);
  dock_->setFloating(true);
  dock_->hide();
  patience_.setSingleShot(true);
  patience_.setInterval(kPatience);
  connect(&patience_, &QTimer::timeout, this, [this] {
    if (isBusy()) raisePanel();
  });
  connect(&session_, &ImportSession::changed, this, &FileWork::showPanel);
  connect(&session_, &ImportSession::finished, this, &FileWork::takeImported);
  connect(&opener_, &DocumentOpener::began, this, &FileWork::showOpening);
  connect(&opener_, &DocumentOpener::progressed, this, &FileWork::showOpening);
  connect(&opener_, &DocumentOpener::ended, this, &FileWork::takeOpened);
  connect(panel_, &ImportPanel::otherCancelled, &opener_, &DocumentOpener::cancel);
  connect(panel_, &ImportPanel::titleChanged, dock_, [this](const QString& title) {
    dock_->setWindowTitle(title);
    dock_->toggleViewAction()->setText(tr("Import"));
  });
}

void FileWork::raisePanel() {
  if (dock_->isVisible()) return;
  if (dock_->isFloating()) {
    const QWidget& scene = host_.viewport();
    dock_->resize(348, 500);
    const QPoint corner = scene.mapToGlobal(QPoint(scene.width() - dock_->width() - 16, 16));
    dock_->move(corner);
  }
  dock_->show();
  dock_->raise();
}

void FileWork::showPanel() {
  const bool asks = std::any_of(session_.files().begin(), session_.files().end(), [](const FileImport& file) {
    return file.stage != FileImport::Stage::kImporting;
  });
  if (asks) return raisePanel();
  if (isBusy()) {
    if (!patience_.isActive()) patience_.start();
  } else {
    dock_->hide();
  }
}

void FileWork::showOpening() {
  if (!opener_.isBusy()) return;
  const workcell::ImportProgress progress = opener_.progress();
  panel_->setOtherWork(OtherWork{opener_.name(), QString::fromStdString(progress.stage), progress.share});
  showPanel();
}

void FileWork::tellError(const QString& title, const Error& error) {
  host_.messages().tell(Severity::kProblem, title,
                        QString::fromStdString(error.message()) + " " + tr("The cell is as it was."));
}

void FileWork::clear() {
  opener_.cancel();
  session_.cancelAll();
  host_.documentModel().clear();
}

void FileWork::open(const QString& path) {
  session_.cancelAll();
  opener_.open(path);
}

void FileWork::takeOpened(const std::shared_ptr<OpenedDocument>& opened, const QString& path) {
  panel_->setOtherWork(std::nullopt);
  showPanel();
  const QString name = QFileInfo(path).fileName();
  if (!opened->document) {
    tellError(tr("%1 was not opened").arg(name), opened->document.error());
    emit this->opened(path, false);
    return;
  }
  workcell::Document& document = *opened->document;
  if (document.path().empty() && !path.isEmpty()) {  // Read again from its text: what is unsaved in it stays so.
    document.setPath(path.toStdString());
    document.markUnsaved();
  }
  host_.documentModel().adopt(std::move(document));
  for (const std::string& warning : opened->notes.warnings)
    host_.messages().tell(Severity::kWarning, tr("%1 was read with remarks").arg(name), QString::fromStdString(warning));
  offerMissing(opened->missing);
  emit this->opened(path, true);
}

void FileWork::offerMissing(const std::vector<std::filesystem::path>& missing) {
  if (missing.empty()) return;
  QStringList names;
  for (const auto& file : missing) names << QString::fromStdString(file.filename().string());
  constexpr qsizetype kNamed = 6;
  const qsizetype more = names.size() - kNamed;
  QString text = names.mid(0, kNamed).join(", ");
  if (more > 0) text += tr(" and %1 more").arg(more);
  host_.messages().tell(
      Severity::kWarning,
      names.size() == 1 ? tr("A file of this cell is missing") : tr("%1 files of this cell are missing").arg(names.size()),
      text + tr(". Their parts are kept without a shape; the rest is here. Show a folder that holds them."),
      {{tr("Show folder…"), [this] { findMissing(); }}});
}

void FileWork::findMissing() {
  const workcell::Document& document = host_.documentModel().document();
  const QString folder = QFileDialog::getExistingDirectory(&host_.window(), tr("Where the missing files are"),
                                                           QString::fromStdString(document.path().parent_path().string()));
  if (folder.isEmpty()) return;
  const std::filesystem::path base =
      document.path().empty() ? std::filesystem::path(QDir::currentPath().toStdString()) : document.path().parent_path();
  opener_.openText(workcell::documentText(document.state(), base), base, QString::fromStdString(document.path().string()),
                   [folder](const std::filesystem::path& file) { return findBelow(folder, file); });
}

void FileWork::import(const QStringList& paths, bool ask) {
  session_.add(paths, ask);
}

void FileWork::takeImported(const QString& path, const ImportSession::Result& result) {
  const QString name = QFileInfo(path).fileName();
  if (!*result) {
    tellError(tr("%1 was not added").arg(name), result->error());
    emit imported(path, false);
    return;
  }
  const workcell::ImportReport report = (*result)->report;
  const auto ids = host_.documentModel().addImported(std::move((*result)->entities));
  if (!ids) {
    tellError(tr("%1 was not added").arg(name), ids.error());
    emit imported(path, false);
    return;
  }
  tellReport(name, report);
  if (!ids->empty()) host_.selection().set(ids->front());
  const bool held = host_.snapshot() && host_.snapshot()->held != 0;
  if (!held) host_.viewport().fitAll();
  emit imported(path, true);
}

void FileWork::tellReport(const QString& name, const workcell::ImportReport& report) {
  for (const std::string& warning : report.warnings)
    host_.messages().tell(Severity::kWarning, tr("%1 was read with remarks").arg(name), QString::fromStdString(warning));
  host_.messages().tell(Severity::kInformation, tr("%1 is in the cell").arg(name), reportText(report));
}

}  // namespace hapticell::app
