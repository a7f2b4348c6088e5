// SPDX-License-Identifier: Apache-2.0
// Opening, saving, importing: everything of the window that asks for a file.
#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/host/main_window.h"
#include "workcell/robot_reader.h"

namespace hapticell::app {

void MainWindow::connectFileActions() {
  connect(actions_->new_cell, &QAction::triggered, this, [this] {
    if (mayDiscard()) document_.clear();
  });
  connect(actions_->open, &QAction::triggered, this, &MainWindow::openFromDialog);
  connect(actions_->save, &QAction::triggered, this, [this] { saveDocument(false); });
  connect(actions_->save_as, &QAction::triggered, this, [this] { saveDocument(true); });
  connect(actions_->import_mesh, &QAction::triggered, this, &MainWindow::importFromDialog);
  connect(actions_->add_robot, &QAction::triggered, this, &MainWindow::addRobotFromDialog);
  connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_->undo, &QAction::triggered, &document_, &DocumentModel::undo);
  connect(actions_->redo, &QAction::triggered, &document_, &DocumentModel::redo);
}

void MainWindow::tellError(const QString& title, const Error& error) {
  messages_.tell(Severity::kProblem, title,
                 QString::fromStdString(error.message()) + " " + tr("The cell is as it was."));
}

void MainWindow::tellNotices(const QString& title, const Diagnostics& diagnostics) {
  for (const std::string& warning : diagnostics.warnings)
    messages_.tell(Severity::kWarning, title, QString::fromStdString(warning));
}

void MainWindow::importFromDialog() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Import a solid"), {},
                                                    tr("Meshes (*.stl *.obj *.ply *.off);;All files (*)"));
  if (!path.isEmpty()) addFile(path);
}

void MainWindow::addRobotFromDialog() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Add a robot"), {},
                                                    tr("Robots (*.urdf *.xacro *.sdf *.toml);;All files (*)"));
  if (!path.isEmpty()) addFile(path);
}

void MainWindow::openFromDialog() {
  if (!mayDiscard()) return;
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a workcell"), {}, tr("Workcells (*.hcell);;All files (*)"));
  if (!path.isEmpty()) openFile(path);
}

bool MainWindow::openFile(const QString& path) {
  Diagnostics diagnostics;
  const QString name = QFileInfo(path).fileName();
  const auto opened = document_.open(path, diagnostics);
  tellNotices(tr("%1 was read with remarks").arg(name), diagnostics);
  if (!opened) {
    tellError(tr("%1 was not opened").arg(name), opened.error());
    return false;
  }
  showSavedView();
  return true;
}

void MainWindow::showSavedView() {
  const auto& view = document_.document().state().view;
  if (!view) return viewport_->fitAll(false);
  viewport_->setCamera(viewport_->camera().looking(view->p_WEye, view->p_WTarget), false);
}

bool MainWindow::saveDocument(bool ask_where) {
  QString path = QString::fromStdString(document_.document().path().string());
  if (path.isEmpty() || ask_where)
    path = QFileDialog::getSaveFileName(
        this, tr("Save the workcell"), path.isEmpty() ? document_.title() + ".hcell" : path, tr("Workcells (*.hcell)"));
  if (path.isEmpty()) return false;
  const auto saved = document_.save(path);
  if (!saved) {
    messages_.tell(Severity::kProblem, tr("The workcell was not saved"),
                   QString::fromStdString(saved.error().message()));
    return false;
  }
  messages_.tell(Severity::kInformation, tr("%1 is saved").arg(QFileInfo(path).fileName()));
  return true;
}

bool MainWindow::addFile(const QString& path) {
  Diagnostics diagnostics;
  const QString name = QFileInfo(path).fileName();
  const bool robot = workcell::looksLikeRobot(path.toStdString());
  const auto id = robot ? document_.addRobot(path, diagnostics) : document_.importMesh(path, 1.0, diagnostics);
  tellNotices(tr("%1 was read with remarks").arg(name), diagnostics);
  if (!id) {
    tellError(tr("%1 was not added").arg(name), id.error());
    return false;
  }
  selection_.set(*id);
  viewport_->fitAll();
  return true;
}

bool MainWindow::mayDiscard() {
  if (!document_.document().isDirty()) return true;
  QMessageBox question(QMessageBox::Question, tr("Changes are not saved"),
                       tr("%1 has changes that are not saved.").arg(document_.title()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  const int answer = question.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveDocument(false));
}

}  // namespace hapticell::app
