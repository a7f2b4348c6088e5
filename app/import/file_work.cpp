// SPDX-License-Identifier: Apache-2.0
#include "app/import/file_work.h"

#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <QMainWindow>
#include <algorithm>
#include <utility>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/import/bent_start.h"
#include "app/import/import_panel.h"
#include "app/import/import_report_text.h"
#include "app/import/mesh_care_panel.h"
#include "app/import/shape_reload.h"
#include "app/kit/file_dialog.h"
#include "app/style/dock_title_bar.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/viewport_widget.h"
#include "config/configuration.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {
namespace {

// ms of work without choices before the panel shows itself: shorter work would flash. Half: flashes; twice: a click
// seems lost.
constexpr int kPatience = 400;
constexpr int kBelowCube = 116;  // Pixels: the view cube stays in sight.

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

/// A cell that is shipped with the program: it is opened as a copy.
bool isSample(const QString& path) {
  const auto shipped = config::findShippedFile("workcells");
  if (!shipped) return false;
  const QString folder = QFileInfo(QString::fromStdString(*shipped)).canonicalFilePath() + '/';
  return QFileInfo(path).canonicalFilePath().startsWith(folder);
}

/// What the scene shows, for the first page; none while the hand holds something, which must not wait.
QImage smallPicture(Host& host) {
  constexpr int kWidth = 496;
  return host.snapshot() && host.snapshot()->stylus.held != 0 ? QImage() : host.viewport().smallPicture(kWidth);
}

}  // namespace

FileWork::FileWork(Host& host, QObject* parent)
    : QObject(parent),
      host_(host),
      exports_(host, background_),
      guard_(host.documentModel()),
      autosaver_(host.documentModel()),
      watch_(host.documentModel()) {
  panel_ = new ImportPanel(session_);
  dock_ = makeDock("dockImport", tr("Import"), panel_);
  host_.addDock(dock_, Qt::RightDockWidgetArea);
  dock_->setAttribute(Qt::WA_ShowWithoutActivating);
  dock_->setFloating(true);
  dock_->hide();
  mesh_dock_ = makeDock("dockMesh", tr("Mesh"), new MeshCarePanel(host_, background_));
  host_.addDock(mesh_dock_, Qt::RightDockWidgetArea);
  mesh_dock_->setFloating(true);
  mesh_dock_->hide();
  patience_.setSingleShot(true);
  patience_.setInterval(kPatience);
  connect(&patience_, &QTimer::timeout, this, [this] {
    if (isBusy()) raisePanel();
  });
  connect(&session_, &ImportSession::changed, this, &FileWork::showPanel);
  connect(&session_, &ImportSession::finished, this, &FileWork::takeImported);
  connect(&opener_, &DocumentOpener::began, this, &FileWork::showOther);
  connect(&opener_, &DocumentOpener::progressed, this, &FileWork::showOther);
  connect(&background_, &BackgroundWork::progressed, this, &FileWork::showOther);
  connect(&watch_, &SourceWatch::changed, this, &FileWork::offerReload);
  autosaver_.setContent([this] { return guard_.content(); });
  autosaver_.setPicture([this] { return smallPicture(host_); });
  connect(&autosaver_, &Autosaver::failed, this, [this](const QString& sentence) {
    host_.messages().tell(Severity::kWarning, tr("The recovery copy could not be saved"), sentence);
  });
  connect(&opener_, &DocumentOpener::ended, this, &FileWork::takeOpened);
  connect(panel_, &ImportPanel::otherCancelled, this, &FileWork::cancelOther);
  connect(panel_, &ImportPanel::titleChanged, dock_, [this](const QString& title) {
    dock_->setWindowTitle(title);
    dock_->toggleViewAction()->setText(tr("Import"));
  });
}

void FileWork::raiseDock(QDockWidget& dock, QSize size) {
  if (dock.isVisible()) return;
  if (dock.isFloating()) {
    const QWidget& scene = host_.viewport();
    dock.resize(size);
    dock.move(scene.mapToGlobal(QPoint(scene.width() - dock.width() - 16, kBelowCube)));
  }
  dock.show();
  dock.raise();
}

void FileWork::raisePanel() {
  raiseDock(*dock_, {348, 500});
}

void FileWork::showMeshCare() {
  raiseDock(*mesh_dock_, {348, 300});
}

void FileWork::showPanel() {
  const bool asks = std::any_of(session_.files().begin(), session_.files().end(),
                                [](const FileImport& file) { return file.stage != FileImport::Stage::kImporting; });
  if (asks) return raisePanel();
  if (isBusy()) {
    if (!patience_.isActive()) patience_.start();
  } else {
    dock_->hide();
  }
}

void FileWork::showOther() {
  std::optional<OtherWork> other;
  if (opener_.isBusy()) {
    const workcell::ImportProgress progress = opener_.progress();
    other = OtherWork{opener_.name(), shownText(progress.stage), progress.share};
  } else if (background_.isBusy()) {
    const workcell::ImportProgress progress = background_.progress();
    other = OtherWork{background_.name(), shownText(progress.stage), progress.share};
  }
  panel_->setOtherWork(other);
  showPanel();
}

void FileWork::cancelOther() {
  opener_.isBusy() ? opener_.cancel() : background_.cancel();
}

void FileWork::reportError(const QString& title, const Error& error) {
  host_.messages().reportCause(Severity::kProblem, title, error, tr("The cell is unchanged."));
}

void FileWork::reportRemarks(const QString& name, const std::vector<Text>& remarks, const NamedParts& parts) {
  if (remarks.empty()) return;
  std::vector<MessageLine> lines;
  for (const RemarkLine& remark : remarkLines(remarks, parts)) {
    MessageLine line{remark.kind, remark.text};
    if (!remark.parts.empty()) line.act = [this, parts = remark.parts] { select(parts); };
    lines.push_back(std::move(line));
  }
  const QString first = lines.front().text;
  const QString text = lines.size() == 1 ? first : first + ' ' + tr("and %1 more").arg(lines.size() - 1);
  host_.messages().tell(Severity::kWarning, tr("%1 was read with warnings").arg(name), text, {}, std::move(lines));
}

NamedParts FileWork::partsOfCell() const {
  NamedParts parts;
  for (const auto& entity : host_.documentModel().document().state().entities) addNames(*entity, entity->id, parts);
  return parts;
}

void FileWork::select(const std::vector<workcell::EntityId>& parts) {
  std::vector<workcell::EntityId> there = parts;  // What was deleted since cannot be selected.
  std::erase_if(there,
                [this](workcell::EntityId part) { return !host_.documentModel().document().state().find(part); });
  if (!there.empty()) host_.selection().setAll(there, there.front());
}

void FileWork::offer(Severity severity, const QString& title, const QString& text, std::vector<MessageAction> actions) {
  host_.messages().tell(severity, title, text, std::move(actions));
}

void FileWork::clear() {
  opener_.cancel();
  session_.cancelAll();
  autosaver_.discard();
  host_.documentModel().clear();
}

void FileWork::open(const QString& path) {
  session_.cancelAll();
  restored_.clear();
  opener_.open(path);
}

void FileWork::takeOpened(const std::shared_ptr<OpenedDocument>& opened, const QString& path) {
  showOther();
  const std::filesystem::path restored = std::exchange(restored_, {});
  const QString name = path.isEmpty() ? tr("New workcell") : QFileInfo(path).fileName();
  if (!opened->document) {
    reportError(tr("%1 was not opened").arg(name), opened->document.error());
    emit this->opened(path, false);
    if (!restored.empty()) emit leftWorkChanged();
    return;
  }
  workcell::Document& document = *opened->document;
  const bool read_again = document.path().empty() && !path.isEmpty();
  if (read_again) {  // Read again from its text: what is unsaved in it stays so.
    document.setPath(path.toStdString());
    document.markUnsaved();
  }
  autosaver_.discard();
  if (!read_again) guard_.setContent(document.path(), opened->content);
  if (isSample(path))
    host_.documentModel().adoptCopy(std::move(document));
  else
    host_.documentModel().adopt(std::move(document));
  std::vector<Text> remarks = opened->notes.warnings;
  for (const workcell::UnloadedEntity& entity :
       opened->unloaded) {  // What offerMissing() tells of all of them at once.
    const auto& missing = opened->missing;
    if (std::find(missing.begin(), missing.end(), std::filesystem::path(entity.cause.file)) != missing.end())
      std::erase(remarks, entity.remark);
  }
  reportRemarks(name, remarks, partsOfCell());
  offerMissing(opened->missing);
  if (guard_.isReadOnly()) {
    offer(
        Severity::kWarning, tr("%1 is open elsewhere").arg(name),
        guard_.ownerSentence() + ' ' + tr("It is read-only here. Save it under another name, or close it there first."),
        {});
  }
  if (!restored.empty())
    autosaver_.adopt(restored);
  else if (!path.isEmpty())
    reportUnsavedCopies(path);  // Last, so that it stands on top.
  emit this->opened(path, true);
}

std::vector<workcell::LeftWork> FileWork::leftWork() const {
  std::vector<workcell::LeftWork> left = workcell::findLeftWork();
  std::erase_if(left, [this](const workcell::LeftWork& work) {
    return std::find(put_off_.begin(), put_off_.end(), work.run) != put_off_.end();
  });
  return left;
}

void FileWork::restore(const workcell::LeftWork& left) {
  session_.cancelAll();
  opener_.openCopy(QString::fromStdString(left.copy.string()), QString::fromStdString(left.document.string()));
  restored_ = left.run;
}

void FileWork::discardLeft(const std::filesystem::path& run) {
  workcell::discardLeftWork(run);
}

void FileWork::putOffLeft(const std::filesystem::path& run) {
  put_off_.push_back(run);
}

void FileWork::reportUnsavedCopies(const QString& path) {
  const std::string wanted = path.isEmpty() ? "" : QFileInfo(path).absoluteFilePath().toStdString();
  for (const workcell::LeftWork& left : workcell::findLeftWork()) {
    if (left.copy.empty() || (!wanted.empty() && left.document != wanted)) continue;
    const QString copy = QString::fromStdString(left.copy.string());
    const QString when = QLocale().toString(QFileInfo(copy).lastModified(), tr("d MMMM, HH:mm"));
    const QString what =
        left.document.empty() ? tr("A new workcell") : QString::fromStdString(left.document.filename().string());
    return offer(Severity::kWarning, tr("%1 has unsaved work from before a crash").arg(what),
                 tr("Changes up to %1 were kept. The open cell does not include them.").arg(when),
                 {{tr("Show"), [this] {
                     put_off_.clear();
                     emit leftWorkChanged();
                   }}});
  }
}

void FileWork::offerReload(const QStringList& paths) {
  QStringList names;
  std::vector<std::string> files;
  for (const QString& path : paths) {
    names << QFileInfo(path).fileName();
    files.push_back(path.toStdString());
  }
  offer(Severity::kInformation, tr("%1 changed on disk").arg(names.join(", ")),
        tr("The cell still shows the old version. Reloading keeps placements, names and colours."),
        {{tr("Reload"), [this, files] { reload(files); }}});
}

void FileWork::reloadSelected() {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  std::vector<std::string> paths;
  for (const auto id : workcell::familyOf(state, host_.selection().current())) {
    const std::string& path = state.find(id)->source.path;
    if (!path.empty() && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
  }
  if (!paths.empty()) return reload(paths);
  host_.messages().tell(Severity::kInformation, tr("There is no file to read again"),
                        tr("What is selected was made in this program. Select a part that was imported from a file."));
}

void FileWork::reload(const std::vector<std::string>& paths) {
  const QString name = QFileInfo(QString::fromStdString(paths.front())).fileName();
  const QString text = paths.size() == 1 ? tr("Reload %1").arg(name) : tr("Reload %1 files").arg(paths.size());
  const auto work = [this, paths, name, text, state = host_.documentModel().document().state()](
                        workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
    auto reload = std::make_shared<ShapeReload>(reloadShapes(state, paths, monitor));
    if (monitor.isCancelled()) return makeError({.file = name.toStdString(), .found = "the reading was cancelled"});
    return BackgroundWork::Then([this, reload, name, text] {
      reportRemarks(name, reload->problems, partsOfCell());
      const auto& document = host_.documentModel().document();
      // What was removed meanwhile needs no shape.
      std::erase_if(reload->commands, [&](const workcell::Command& command) {
        const auto* shape = std::get_if<workcell::ReplaceShape>(&command);
        const auto* proxy = std::get_if<workcell::SetCollisionProxy>(&command);
        return !document.find(shape ? shape->id : proxy->id);
      });
      if (reload->commands.empty()) return;
      host_.documentModel().executeAll(text, reload->commands);
    });
  };
  background_.start(name, work,
                    [this, name](const Error& error) { reportError(tr("%1 was not reloaded").arg(name), error); });
}

void FileWork::offerMissing(const std::vector<std::filesystem::path>& missing) {
  if (missing.empty()) return;
  QStringList names;
  for (const auto& file : missing) names << QString::fromStdString(file.filename().string());
  constexpr qsizetype kNamed = 6;
  const qsizetype more = names.size() - kNamed;
  QString text = names.mid(0, kNamed).join(", ");
  if (more > 0) text += tr(" and %1 more").arg(more);
  offer(Severity::kWarning,
        names.size() == 1 ? tr("A file of this cell is missing")
                          : tr("%1 files of this cell are missing").arg(names.size()),
        text + tr(". Their parts have no shape until you choose the folder that contains the files."),
        {{tr("Choose folder…"), [this] { findMissing(); }}});
}

void FileWork::findMissing() {
  const workcell::Document& document = host_.documentModel().document();
  const QString folder = askForFolder(&host_.window(), tr("Folder of the missing files"),
                                      QString::fromStdString(document.path().parent_path().string()));
  if (folder.isEmpty()) return;
  const std::filesystem::path base = document.path().empty() ? std::filesystem::path(QDir::currentPath().toStdString())
                                                             : document.path().parent_path();
  restored_.clear();
  opener_.openText(workcell::documentText(document.state(), base), base,
                   QString::fromStdString(document.path().string()),
                   [folder](const std::filesystem::path& file) { return findBelow(folder, file); });
}

void FileWork::import(const QStringList& paths, bool ask) {
  session_.add(paths, ask);
}

void FileWork::takeImported(const QString& path, const ImportSession::Result& result) {
  const QString name = QFileInfo(path).fileName();
  if (!*result) {
    reportError(tr("%1 was not added").arg(name), result->error());
    emit imported(path, false);
    return;
  }
  workcell::ImportReport report = (*result)->report;
  for (workcell::Entity& entity : (*result)->entities) startBent(entity, report);
  const std::vector<workcell::Entity> named = (*result)->entities;  // As the file names them.
  host_.documentModel().beginStep(tr("Import %1").arg(name));
  const auto ids = host_.documentModel().addImported(std::move((*result)->entities));
  host_.documentModel().endStep();
  if (!ids) {
    reportError(tr("%1 was not added").arg(name), ids.error());
    emit imported(path, false);
    return;
  }
  NamedParts parts;
  for (std::size_t k = 0; k < ids->size(); ++k) addNames(named[k], (*ids)[k], parts);
  reportImport(name, report, parts);
  if (!ids->empty()) host_.selection().set(ids->front());
  const bool held = host_.snapshot() && host_.snapshot()->stylus.held != 0;
  if (!held) host_.viewport().fitAll();
  emit imported(path, true);
}

void FileWork::reportImport(const QString& name, const workcell::ImportReport& report, const NamedParts& parts) {
  reportRemarks(name, report.warnings, parts);
  host_.messages().tell(Severity::kInformation, tr("%1 is added to the cell").arg(name), reportText(report));
}

}  // namespace hapticell::app
