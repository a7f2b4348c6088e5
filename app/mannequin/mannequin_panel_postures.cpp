// SPDX-License-Identifier: Apache-2.0
// The panel's menu of postures: the library, and files.
#include <QCoreApplication>
#include <QDir>
#include <QMenu>
#include <QPushButton>
#include <QStandardPaths>
#include <map>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/mannequin/mannequin_panel.h"
#include "app/style/library_text.h"
#include "geometry/system/atomic_file.h"
#include "mannequin/motion/motion_writer.h"
#include "mannequin/posture/posture_file.h"

namespace hapticell::app {

namespace {

/// The words of the built-in postures.
const std::map<std::string, const char*> kNames{
    {"zero", QT_TRANSLATE_NOOP("PostureNames", "Zero")},
    {"standing", QT_TRANSLATE_NOOP("PostureNames", "Standing")},
    {"t_pose", QT_TRANSLATE_NOOP("PostureNames", "Arms to the sides")},
    {"seated", QT_TRANSLATE_NOOP("PostureNames", "Seated")},
    {"typing", QT_TRANSLATE_NOOP("PostureNames", "Typing")},
    {"overhead", QT_TRANSLATE_NOOP("PostureNames", "Overhead")},
    {"reaching", QT_TRANSLATE_NOOP("PostureNames", "Reaching")},
    {"both_hands_forward", QT_TRANSLATE_NOOP("PostureNames", "Both hands forward")},
    {"pushing", QT_TRANSLATE_NOOP("PostureNames", "Pushing")},
    {"stooping", QT_TRANSLATE_NOOP("PostureNames", "Stooping")},
    {"squatting", QT_TRANSLATE_NOOP("PostureNames", "Squatting")},
    {"kneeling", QT_TRANSLATE_NOOP("PostureNames", "Kneeling")},
    {"kneeling_one", QT_TRANSLATE_NOOP("PostureNames", "Kneeling on one knee")},
    {"lying", QT_TRANSLATE_NOOP("PostureNames", "Lying")}};

QString shownName(const std::string& posture) {
  const auto known = kNames.find(posture);
  return known == kNames.end() ? QString::fromStdString(posture)
                               : QCoreApplication::translate("PostureNames", known->second);
}

}  // namespace

QString MannequinPanel::postureFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/postures");
}

void MannequinPanel::openPostureMenu() {
  auto* menu = new QMenu(postures_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const mannequin::LibraryPosture& posture : mannequin::postureLibrary()) {
    const QString name = QString::fromStdString(posture.name);
    QAction* action = menu->addAction(shownName(posture.name), this, [this, name] { takePosture(name); });
    action->setObjectName("posture_" + name);
  }
  const QFileInfoList own = QDir(postureFolder()).entryInfoList({"*.json"}, QDir::Files, QDir::Name);
  if (!own.isEmpty()) menu->addSection(tr("Own postures"));
  for (const QFileInfo& file : own) {
    const QString path = file.absoluteFilePath();
    QAction* action = menu->addAction(file.completeBaseName(), this, [this, path] { openPostureFile(path); });
    action->setObjectName("own_posture_" + file.completeBaseName());
  }
  menu->addSeparator();
  menu->addAction(tr("Open a posture…"), this, &MannequinPanel::openPosture);
  menu->addAction(tr("Save this posture…"), this, &MannequinPanel::savePosture)->setObjectName("savePosture");
  menu->popup(postures_->mapToGlobal(QPoint(0, postures_->height())));
}

void MannequinPanel::takePosture(const QString& name) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return;
  if (const auto posture = libraryPostureAt(*entity, name.toStdString()))
    context_.host().documentModel().executeAll(tr("Posture %1").arg(shownName(name.toStdString())),
                                               {postureCommand(*entity, *posture)});
}

bool MannequinPanel::lacksMannequin() {
  if (context_.entity() != nullptr) return false;
  context_.host().messages().tell(Severity::kInformation, tr("No mannequin is selected"),
                                  tr("A posture is that of a mannequin. Select one, or add one first."));
  return true;
}

void MannequinPanel::openPosture() {
  if (lacksMannequin()) return;
  const QString path = askToOpen(this, tr("Open a posture"), postureFolder(), tr("Postures (*.json);;All files (*)"));
  if (!path.isEmpty()) openPostureFile(path);
}

bool MannequinPanel::openPostureFile(const QString& path) {
  const workcell::Entity* entity = context_.entity();
  if (!entity || !context_.isFree()) return false;
  bool has_root = false;
  auto posture = mannequin::readPosture(path.toStdString(), &has_root);
  const auto beyond = posture ? mannequin::limitViolations(*posture) : std::vector<mannequin::LimitViolation>{};
  if (!posture || !beyond.empty()) {
    const QString why = posture ? shownText(textOf(beyond.front())) : shownText(posture.error());
    context_.host().messages().tell(Severity::kWarning, tr("The posture was not loaded"), why);
    return false;
  }
  const mannequin::Posture placed = has_root ? *posture : placedHere(*entity, *posture);
  return context_.host().documentModel().executeAll(tr("Posture from a file"), {postureCommand(*entity, placed)});
}

void MannequinPanel::savePosture() {
  if (lacksMannequin()) return;
  QDir().mkpath(postureFolder());  // What is saved there stands in the menu.
  const QString path = askToSave(this, tr("Save this posture"), postureFolder() + "/posture.json",
                                 tr("Postures (*.json);;H-Anim figures (*.x3d);;Motions of one frame (*.bvh)"));
  if (!path.isEmpty()) savePostureFile(path);
}

bool MannequinPanel::savePostureFile(const QString& path) {
  const workcell::Entity* entity = context_.entity();
  if (!entity) return false;
  const mannequin::Posture posture = context_.posture();
  std::string text = mannequin::postureText(posture);
  if (path.endsWith(".x3d", Qt::CaseInsensitive)) text = mannequin::hanimText(*entity->figure(), posture, entity->name);
  if (path.endsWith(".bvh", Qt::CaseInsensitive))
    text = mannequin::bvhText(*entity->figure(), std::vector{posture}, 1.0 / 120.0);
  const auto written = writeFileAtomically(path.toStdString(), text);
  if (written) {
    context_.host().messages().tell(Severity::kInformation, tr("The posture is saved"), path);
  } else {
    context_.host().messages().reportCause(Severity::kProblem, tr("The posture was not saved"), written.error());
  }
  return written.has_value();
}

}  // namespace hapticell::app
