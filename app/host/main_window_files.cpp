// SPDX-License-Identifier: Apache-2.0
// Opening, saving, importing: everything of the window that asks for a file.
#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/host/main_window.h"

namespace hapticell::app {

void MainWindow::connectFileActions() {
  connect(actions_->new_cell, &QAction::triggered, this, [this] {
    if (mayDiscard()) document_.clear();
  });
  connect(actions_->import_mesh, &QAction::triggered, this, &MainWindow::importFromDialog);
  connect(actions_->add_robot, &QAction::triggered, this, &MainWindow::addRobotFromDialog);
  connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_->undo, &QAction::triggered, &document_, &DocumentModel::undo);
  connect(actions_->redo, &QAction::triggered, &document_, &DocumentModel::redo);
}

void MainWindow::tellError(const QString& title, const Error& error) {
  messages_.tell(Severity::kProblem, title, QString::fromStdString(error.message()) + " " + tr("The cell is as it was."));
}

void MainWindow::tellNotices(const QString& title, const Diagnostics& diagnostics) {
  for (const std::string& warning : diagnostics.warnings) messages_.tell(Severity::kWarning, title, QString::fromStdString(warning));
}

void MainWindow::importFromDialog() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Import a solid"), {}, tr("Meshes (*.stl *.obj *.ply *.off);;All files (*)"));
  if (!path.isEmpty()) addFile(path);
}

void MainWindow::addRobotFromDialog() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Add a robot"), {}, tr("Robots (*.urdf);;All files (*)"));
  if (!path.isEmpty()) addFile(path);
}

bool MainWindow::openFile(const QString&) { return false; }

bool MainWindow::addFile(const QString& path) {
  Diagnostics diagnostics;
  const QString name = QFileInfo(path).fileName();
  const bool robot = path.endsWith(".urdf", Qt::CaseInsensitive);
  const auto id = robot ? document_.addRobot(path, diagnostics) : document_.importMesh(path, 1.0, diagnostics);
  tellNotices(tr("%1 was read with remarks").arg(name), diagnostics);
  if (!id) {
    tellError(tr("%1 was not added").arg(name), id.error());
    return false;
  }
  selection_.set(*id);
  viewport_->fit(viewport_->scene().bounds_W());
  return true;
}

bool MainWindow::mayDiscard() {
  if (!document_.document().isDirty()) return true;
  QMessageBox question(QMessageBox::Question, tr("Changes are not saved"),
                       tr("%1 has changes that are not saved.").arg(document_.title()),
                       QMessageBox::Discard | QMessageBox::Cancel, this);
  return question.exec() == QMessageBox::Discard;
}

}  // namespace hapticell::app
