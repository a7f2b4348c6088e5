// SPDX-License-Identifier: Apache-2.0
// The panel's menu of postures: the library, and files.
#include <QFileDialog>
#include <QMenu>
#include <QPushButton>
#include <fstream>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/mannequin/mannequin_panel.h"
#include "mannequin/motion_writer.h"
#include "mannequin/posture_file.h"

namespace hapticell::app {

void MannequinPanel::openPostureMenu() {
  auto* menu = new QMenu(postures_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const mannequin::LibraryPosture& posture : mannequin::postureLibrary()) {
    QString name = QString::fromStdString(posture.name);
    QString shown = QString(name).replace('_', ' ');
    shown[0] = shown[0].toUpper();
    QAction* action = menu->addAction(shown, this, [this, name] { takePosture(name); });
    action->setObjectName("posture_" + name);
  }
  menu->addSeparator();
  menu->addAction(tr("Open a posture…"), this, [this] { openPosture(); });
  menu->addAction(tr("Save this posture…"), this, [this] { savePosture(); });
  menu->popup(postures_->mapToGlobal(QPoint(0, postures_->height())));
}

void MannequinPanel::takePosture(const QString& name) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return;
  if (const auto posture = libraryPostureAt(*entity, name.toStdString()))
    context_.host().documentModel().executeAll(tr("Posture %1").arg(QString(name).replace('_', ' ')),
                                               {postureCommand(*entity, *posture)});
}

void MannequinPanel::openPosture() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a posture"), {}, tr("Postures (*.json);;All files (*)"));
  if (!path.isEmpty()) openPostureFile(path);
}

bool MannequinPanel::openPostureFile(const QString& path) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return false;
  bool has_root = false;
  auto posture = mannequin::readPosture(path.toStdString(), &has_root);
  const auto beyond = posture ? mannequin::limitViolations(*posture) : std::vector<std::string>{};
  if (!posture || !beyond.empty()) {
    const std::string why = posture ? beyond.front() : posture.error().message();
    context_.host().messages().tell(Severity::kWarning, tr("The posture was not taken"), QString::fromStdString(why));
    return false;
  }
  const mannequin::Posture placed = has_root ? *posture : placedHere(*entity, *posture);
  return context_.host().documentModel().executeAll(tr("Posture from a file"), {postureCommand(*entity, placed)});
}

void MannequinPanel::savePosture() {
  if (!context_.entity()) return;
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save this posture"), "posture.json",
                                   tr("Postures (*.json);;H-Anim figures (*.x3d);;Motions of one frame (*.bvh)"));
  if (!path.isEmpty()) savePostureFile(path);
}

bool MannequinPanel::savePostureFile(const QString& path) {
  const workcell::Entity* entity = context_.entity();
  if (!entity) return false;
  const mannequin::Posture posture = context_.posture();
  std::string text = mannequin::postureText(posture);
  if (path.endsWith(".x3d", Qt::CaseInsensitive)) text = mannequin::hanimText(*entity->figure, posture, entity->name);
  if (path.endsWith(".bvh", Qt::CaseInsensitive))
    text = mannequin::bvhText(*entity->figure, std::vector{posture}, 1.0 / 120.0);
  std::ofstream file(path.toStdString(), std::ios::binary);
  file << text;
  file.close();
  if (file.good()) {
    context_.host().messages().tell(Severity::kInformation, tr("The posture is saved"), path);
  } else {
    context_.host().messages().tell(Severity::kProblem, tr("The posture was not saved"),
                                    tr("%1 cannot be written. Choose another place.").arg(path));
  }
  return file.good();
}

}  // namespace hapticell::app
