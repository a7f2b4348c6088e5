// SPDX-License-Identifier: Apache-2.0
// Opening, saving, importing, closing: everything of the window that asks for a file or keeps what is not in one yet.
#include <QAbstractButton>
#include <QAction>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <optional>
#include <utility>

#include "app/import/file_work.h"
#include "app/kit/file_dialog.h"
#include "app/panels/tree/tree_edits.h"
#include "app/ros2/description_section.h"
#include "app/shell/action_watch.h"
#include "app/shell/crash_guard.h"
#include "app/shell/crash_report.h"
#include "app/shell/file_opening.h"
#include "app/shell/main_window.h"
#include "app/shell/window_log.h"
#include "app/start/recent_files.h"
#include "app/start/start_page.h"

namespace hapticell::app {

namespace {
constexpr int kPictureWidth = 368;  // Pixels: for the first page at 200 %.
}

void MainWindow::connectFileActions() {
  connect(&files_->guard(), &DocumentGuard::changed, this, &MainWindow::updateTitle);
  connect(actions_->file.new_cell, &QAction::triggered, this, [this] { replaceDocument([this] { files_->clear(); }); });
  connect(actions_->file.open, &QAction::triggered, this, &MainWindow::openFromDialog);
  connect(actions_->file.save, &QAction::triggered, this, [this] { saveDocument(false); });
  connect(actions_->file.save_as, &QAction::triggered, this, [this] { saveDocument(true); });
  connect(actions_->file.import_mesh, &QAction::triggered, this, &MainWindow::importFromDialog);
  connect(actions_->file.add_robot_file, &QAction::triggered, this, &MainWindow::addRobotFromDialog);
  ExportWork& exports = files_->exports();
  const auto on = [this](QAction* action, auto&& slot) { connect(action, &QAction::triggered, this, slot); };
  on(actions_->file.export_cell, [&exports] { exports.askExport(false); });
  on(actions_->file.export_selection, [&exports] { exports.askExport(true); });
  on(actions_->file.pack, [&exports] { exports.askPack(); });
  on(actions_->file.report_saved, [&exports] { exports.askReport(ExportWork::Against::kSaved); });
  on(actions_->file.report_import, [&exports] { exports.askReport(ExportWork::Against::kImport); });
  on(actions_->file.report_other, [&exports] { exports.askReport(ExportWork::Against::kOtherCell); });
  on(actions_->edit.mesh_care, [this] { files_->showMeshCare(); });
  on(actions_->file.reload, [this] { files_->reloadSelected(); });
  on(actions_->edit.duplicate, [this] {
    const Entities copies = duplicateEntities(document_, selection_.all());
    if (!copies.empty()) selection_.set(copies.front());
  });
  on(actions_->edit.isolate, [this] { isolateEntities(document_, selection_.all()); });
  on(actions_->edit.show_all, [this] { showAll(document_); });
  if (auto* robot = findChild<DescriptionSection*>())
    connect(robot, &DescriptionSection::received, this, [this](const QString& path) { importFiles({path}); });
  connect(actions_->file.quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_->edit.undo, &QAction::triggered, &document_, &DocumentModel::undo);
  connect(actions_->edit.redo, &QAction::triggered, &document_, &DocumentModel::redo);
}

void MainWindow::connectStart() {
  connect(files_.get(), &FileWork::opened, this, [this](const QString& path, bool done) {
    if (!done) return;
    if (!document_.document().path().empty()) recentFiles().add(path);  // Samples stand on the first page.
    start_->hide();
    showSavedView();
  });
  connect(files_.get(), &FileWork::imported, start_, [this](const QString&, bool done) {
    if (done) start_->hide();
  });
  connectLeftWork();
  recentFiles().fill(*actions_->menus.recent);
  const auto openAfterAsking = [this](const QString& path) { replaceDocument([this, path] { openFile(path); }); };
  connect(&recentFiles(), &RecentFiles::chosen, this, openAfterAsking);
  connect(start_, &StartPage::fileWanted, this, openAfterAsking);
  connect(start_, &StartPage::actionWanted, this, [this](const QString& name) {
    if (name == QLatin1String("actionNew")) start_->hide();
    if (auto* action = findChild<QAction*>(name)) action->trigger();
  });
  connect(actions_->help.first_page, &QAction::triggered, this, &MainWindow::showStartPage);
  connect(&layouts_, &Layouts::chosen, this, [this](const QString& name) {
    // Its dock is made when it is first wanted.
    auto* check = name == QLatin1String("device") ? findChild<QAbstractButton*>("buttonCheckDevice") : nullptr;
    if (check && !findChild<QDockWidget*>("dockDeviceCheck")) check->click();
  });
  connect(actions_->view.reset_layout, &QAction::triggered, &layouts_, &Layouts::reset);
}

void MainWindow::showStartPage() {
  start_->open(files_->leftWork());
}

/// Unsaved work after a crash: seen to on the first page.
void MainWindow::connectLeftWork() {
  connect(files_.get(), &FileWork::leftWorkChanged, this, &MainWindow::showStartPage);
  connect(start_, &StartPage::restoreWanted, this,
          [this](const workcell::LeftWork& left) { replaceDocument([this, left] { files_->restore(left); }); });
  // Queued: the page is made again, and the button that was clicked goes with it.
  const auto after = [this](auto signal, auto act) {
    connect(
        start_, signal, this,
        [this, act](const workcell::LeftWork& left) {
          if (act(left)) showStartPage();
        },
        Qt::QueuedConnection);
  };
  after(&StartPage::laterWanted, [this](const workcell::LeftWork& left) {
    files_->putOffLeft(left.run);
    return true;
  });
  after(&StartPage::discardWanted, [this](const workcell::LeftWork& left) {
    if (!left.copy.empty() && !mayDiscardCopy(left)) return false;
    files_->discardLeft(left.run);
    return true;
  });
}

bool MainWindow::mayDiscardCopy(const workcell::LeftWork& left) {
  const QString name =
      left.document.empty() ? tr("New workcell") : QString::fromStdString(left.document.filename().string());
  QMessageBox question(QMessageBox::Question, tr("Discard the copy"),
                       tr("If you discard the copy, the unsaved changes of %1 are lost for good.").arg(name),
                       QMessageBox::Cancel, this);
  const QAbstractButton* discard = question.addButton(tr("Discard copy"), QMessageBox::DestructiveRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  return question.clickedButton() == discard;
}

void MainWindow::importFromDialog() {
  importFiles(
      askToOpenSeveral(this, tr("Import"), {},
                       tr("All supported files (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf "
                          "*.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAD (*.step *.stp *.p21 "
                          "*.stpz *.iges *.igs);;Meshes (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx "
                          "*.3ds);;Robots and cells (*.urdf *.xacro *.sdf *.world *.toml);;All files (*)")));
}

void MainWindow::addRobotFromDialog() {
  importFiles(askToOpenSeveral(this, tr("Add a robot"), {}, tr("Robots (*.urdf *.xacro *.sdf *.toml);;All files (*)")));
}

void MainWindow::openFromDialog() {
  const QString path = askToOpen(this, tr("Open a workcell or a recording"), {},
                                 tr("Workcells (*.hcell);;Motions and recordings (*.htraj *.mcap);;All files (*)"));
  if (path.isEmpty()) return;
  if (isOwnFile(path)) return openAny(*this, path);
  replaceDocument([this, path] { openFile(path); });
}

void MainWindow::openFile(const QString& path) {
  files_->open(path);
}

void MainWindow::openCell(const QString& path, QObject* context, const std::function<void()>& opened) {
  connect(files_.get(), &FileWork::opened, context, opened, Qt::SingleShotConnection);
  openFile(path);
}

void MainWindow::importFiles(const QStringList& paths, bool ask) {
  if (!paths.isEmpty()) files_->import(paths, ask);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  const auto isFile = [](const QUrl& url) { return url.isLocalFile(); };
  if (std::any_of(urls.begin(), urls.end(), isFile)) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList parts, own;
  QString cell;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (!url.isLocalFile()) continue;
    const QString path = url.toLocalFile();
    if (path.endsWith(".hcell", Qt::CaseInsensitive))
      cell = path;
    else
      (isOwnFile(path) ? own : parts).append(path);
  }
  event->acceptProposedAction();
  // Queued: the program that is dragged from waits until this returns, and a question may follow.
  QMetaObject::invokeMethod(
      this,
      [this, cell, parts, own] {
        if (!cell.isEmpty()) replaceDocument([this, cell] { openFile(cell); });
        for (const QString& path : own) openAny(*this, path);
        importFiles(parts);
      },
      Qt::QueuedConnection);
}

void MainWindow::showSavedView() {
  const auto& view = document_.document().state().view;
  if (!view) return viewport_->fitAll(false);
  viewport_->setCamera(viewport_->camera().looking(view->p_WEye, view->p_WTarget), false);
}

namespace {

enum class SaveAnswer { kElsewhere, kAnyway, kNot };

/// Another program has the file, or has changed it.
SaveAnswer askAboutSaving(QWidget* parent, const QString& path, const QString& doubt) {
  QMessageBox question(QMessageBox::Warning, MainWindow::tr("Save the workcell"),
                       MainWindow::tr("%1 may contain the work of others.").arg(QFileInfo(path).fileName()),
                       QMessageBox::NoButton, parent);
  question.setObjectName("askSaving");
  question.setInformativeText(doubt);
  QPushButton* elsewhere = question.addButton(MainWindow::tr("Save as…"), QMessageBox::AcceptRole);
  QPushButton* anyway = question.addButton(MainWindow::tr("Save anyway"), QMessageBox::DestructiveRole);
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(elsewhere);
  question.exec();
  if (question.clickedButton() == elsewhere) return SaveAnswer::kElsewhere;
  return question.clickedButton() == anyway ? SaveAnswer::kAnyway : SaveAnswer::kNot;
}

}  // namespace

QString MainWindow::placeToSave(bool ask_where) {
  QString path = QString::fromStdString(document_.document().path().string());
  for (;;) {
    if (path.isEmpty() || ask_where)
      path = askToSave(this, tr("Save the workcell"), path.isEmpty() ? document_.title() + ".hcell" : path,
                       tr("Workcells (*.hcell)"));
    if (path.isEmpty()) return {};
    const QString doubt = files_->guard().doubtAbout(path);
    if (doubt.isEmpty()) return path;
    const SaveAnswer answer = askAboutSaving(this, path, doubt);
    if (answer == SaveAnswer::kAnyway) return path;
    if (answer == SaveAnswer::kNot) return {};
    ask_where = true;
  }
}

bool MainWindow::saveDocument(bool ask_where) {
  const QString path = placeToSave(ask_where);
  if (path.isEmpty()) return false;
  const auto saved = document_.save(path);
  if (!saved) {
    messages_.reportCause(Severity::kProblem, tr("The workcell was not saved"), saved.error());
    return false;
  }
  files_->guard().noteSaved();
  if (log_) log_->noteSaved(path);
  recentFiles().add(path);
  keepPicture();
  files_->autosaver().discard();
  messages_.tell(Severity::kInformation, tr("%1 is saved").arg(QFileInfo(path).fileName()));
  return true;
}

bool MainWindow::mayDiscard() {
  if (!document_.isDirty()) return true;
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                       tr("%1 has unsaved changes.").arg(document_.title()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  question.setInformativeText(tr("If you do not save them, they are lost."));
  const int answer = question.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveDocument(false));
}

void MainWindow::keepPicture() {
  const QString path = QString::fromStdString(document_.document().path().string());
  if (settings_.isKept() && !path.isEmpty() && !document_.isDirty())
    recentFiles().keepPicture(path, viewport_->smallPicture(kPictureWidth));
}

void MainWindow::replaceDocument(const std::function<void()>& then) {
  whenRecorded([this, then] {
    if (mayDiscard()) then();
  });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (recording_.isRecording()) {
    event->ignore();
    return whenRecorded([this] { close(); });
  }
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  keepPicture();
  layouts_.store();
  files_->autosaver().discard();
  hide();  // Gone at once; what is under way is given up behind it.
  if (modules_)
    for (Module* module : modules_->modules()) module->stop();
  event->accept();
}

void MainWindow::whenRecorded(const std::function<void()>& then) {
  if (!recording_.isRecording()) return then();
  // ms: a module that does not answer must not keep the window open. Half: a slow disk loses a recording's end; twice:
  // closing seems to hang.
  constexpr int kLongestMilliseconds = 2000;
  auto* once = new QTimer(this);
  once->setSingleShot(true);
  connect(once, &QTimer::timeout, this, [once, then] {
    once->deleteLater();
    then();
  });
  // After those that take the recording into the cell, which were connected before.
  connect(&recording_, &RecordingHub::recorded, once, [once] { once->start(0); });
  once->start(kLongestMilliseconds);
  recording_.stop();
}

void MainWindow::guardAgainstCrash(const std::string& program) {
  Autosaver& autosaver = files_->autosaver();
  const auto folder = autosaver.runFolder();
  if (!folder)
    return messages_.reportCause(Severity::kWarning, tr("The recovery copy could not be saved"), folder.error());
  const auto reports = CrashReport::makeFolder();
  if (!reports) messages_.reportCause(Severity::kWarning, tr("Crash reports cannot be saved"), reports.error());
  std::optional<CrashReport> report;
  if (reports) report.emplace(*reports, program, trail_);
  crash_guard_ = std::make_unique<CrashGuard>([&autosaver] { return autosaver.keepNow(); },
                                              workcell::crashNoteIn(*folder), std::move(report));
  connect(&messages_, &MessageLog::told, this,
          [this](const Message& message) { trail_.add("message: " + message.title.toStdString()); });
  watchActions();
  if (reports) reportImport(*reports);
}

void MainWindow::reportImport(const std::filesystem::path& folder) {
  static constexpr const char* kDecided = "crash/told";
  const auto reports = CrashReport::reportsIn(folder);
  if (reports.empty()) return;
  const QString newest = QString::fromStdString(reports.back().filename().string());
  if (newest <= settings_.value(kDecided).toString()) return;
  settings_.setValue(kDecided, newest);
  messages_.tell(Severity::kInformation, tr("A report of the crash was saved on this computer"),
                 tr("%1 holds the cause and your last actions. Nothing was sent. If you report the fault, you can "
                    "attach this file.")
                     .arg(QString::fromStdString(reports.back().string())));
}

void MainWindow::keepLog(config::LogLevel level, const std::string& program) {
  auto log = config::ProgramLog::open("hapticell", level);
  if (!log) return messages_.reportCause(Severity::kWarning, tr("There is no log file"), log.error());
  log_ = std::make_unique<WindowLog>(std::move(*log), program);
  log_->follow(*viewport_);
  log_->follow(*files_);
  log_->follow(messages_);
  watchActions();
}

void MainWindow::watchActions() {
  if (action_watch_) return;
  action_watch_ = std::make_unique<ActionWatch>(*this, [this](const QString& name) {
    trail_.add(name.toStdString());
    if (log_) log_->noteAction(name);
  });
}

void MainWindow::endNow() {
  whenRecorded([this] {
    layouts_.store();
    files_->autosaver().save();
    if (modules_)
      for (Module* module : modules_->modules()) module->stop();
    QCoreApplication::exit(0);  // quit() would ask the window whether it may close.
  });
}

}  // namespace hapticell::app
