// SPDX-License-Identifier: Apache-2.0
#include "app/import/export_work.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/import/change_page.h"
#include "app/kit/file_dialog.h"
#include "app/kit/system_open.h"
#include "app/style/plain_lines.h"
#include "workcell/files/pack.h"
#include "workcell/files/scene_export.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {
namespace {

using workcell::DocumentState;

/// What is left of a state when only a family in it is wanted.
DocumentState onlyFamily(const DocumentState& state, workcell::EntityId id) {
  const std::vector<workcell::EntityId> family = workcell::familyOf(state, id);
  DocumentState part;
  for (const auto& entity : state.entities) {
    if (std::find(family.begin(), family.end(), entity->id) == family.end()) continue;
    auto kept = std::make_shared<workcell::Entity>(*entity);
    if (kept->id == id) kept->parent.clear();
    part.entities.push_back(std::move(kept));
  }
  return part;
}

Expected<DocumentState> stateBefore(ExportWork::Against against, const DocumentState& now, const std::string& file,
                                    workcell::ImportMonitor& monitor) {
  Diagnostics notes;
  if (against == ExportWork::Against::kImport) return workcell::stateAtImport(now, &monitor, notes);
  workcell::LoadOptions options;
  options.keep_unloaded = true;
  options.monitor = &monitor;
  auto document = workcell::loadDocument(file, notes, options);
  HAPTICELL_TRY(document);
  return document->state();
}

}  // namespace

ExportWork::ExportWork(Host& host, BackgroundWork& background, QObject* parent)
    : QObject(parent), host_(host), background_(background) {}

void ExportWork::askExport(bool selection_only) {
  const workcell::Entity* entity = host_.documentModel().document().find(host_.selection().current());
  if (selection_only && !entity) return;
  const QString stem = selection_only ? QString::fromStdString(entity->name) : host_.documentModel().title();
  const bool robot = selection_only && entity->robot();
  QStringList filters{tr("STEP (*.step)"), tr("glTF (*.glb)"), tr("STL (*.stl)"), tr("OBJ (*.obj)"), tr("PLY (*.ply)")};
  robot ? filters.prepend(tr("URDF (*.urdf)")) : filters.append(tr("URDF of the robot (*.urdf)"));
  const QString path = askToSave(&host_.window(), tr("Export"), stem + (robot ? ".urdf" : ".step"), filters.join(";;"));
  if (!path.isEmpty()) exportTo(path, selection_only);
}

void ExportWork::askPack() {
  const QString path = askToSave(&host_.window(), tr("Pack the workcell with its files"),
                                 host_.documentModel().title() + ".zip", tr("Archives (*.zip *.tar.gz)"));
  if (!path.isEmpty()) packTo(path);
}

void ExportWork::askReport(Against against) {
  QString other;
  if (against == Against::kOtherCell) {
    other = askToOpen(&host_.window(), tr("Compare with"), {}, tr("Workcells (*.hcell)"));
    if (other.isEmpty()) return;
  }
  const QString path = askToSave(&host_.window(), tr("Save the change report"),
                                 host_.documentModel().title() + tr("-changes.pdf"), tr("PDF (*.pdf);;CSV (*.csv)"));
  if (!path.isEmpty()) reportTo(path, against, other);
}

void ExportWork::reportWritten(const QString& path, const std::vector<Text>& notes) {
  const QString name = QFileInfo(path).fileName();
  for (const Text& note : notes)
    host_.messages().reportCause(Severity::kWarning, tr("%1 was saved with warnings").arg(name), note);
  const QString folder = QFileInfo(path).absolutePath();
  host_.messages().tell(Severity::kInformation, tr("%1 is saved").arg(name), folder,
                        {{tr("Show folder"), [folder] { openWithSystem(folder); }}});
  emit finished(path, true);
}

void ExportWork::run(const QString& path, BackgroundWork::Work work, const QString& failed) {
  background_.start(QFileInfo(path).fileName(), std::move(work), [this, path, failed](const Error& error) {
    host_.messages().reportCause(Severity::kProblem, failed, error);
    emit finished(path, false);
  });
}

void ExportWork::exportTo(const QString& path, bool selection_only) {
  const DocumentState& all = host_.documentModel().document().state();
  const DocumentState state = selection_only ? onlyFamily(all, host_.selection().current()) : all;
  const auto work = [this, path, state](workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
    workcell::ExportOptions options;
    options.monitor = &monitor;
    monitor.report(Text("writing"), 0.0);
    Diagnostics notes;
    const auto written = workcell::exportState(state, path.toStdString(), options, notes);
    HAPTICELL_TRY(written);
    return BackgroundWork::Then([this, path, notes] { reportWritten(path, notes.warnings); });
  };
  run(path, work, tr("%1 was not saved").arg(QFileInfo(path).fileName()));
}

/// A workcell of others may name any file of this computer: what goes into an archive is the user's word.
void ExportWork::askOutside(const QString& path, const QStringList& files) {
  constexpr qsizetype kShown = 15;
  auto* question = new QMessageBox(QMessageBox::Question, tr("Pack the workcell with its files"),
                                   tr("%1 files are outside the workcell's folder. Pack them too?").arg(files.size()),
                                   QMessageBox::NoButton, &host_.window());
  question->setObjectName("askOutside");
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setTextFormat(Qt::PlainText);
  QString list = files.mid(0, kShown).join(QLatin1Char('\n'));
  if (files.size() > kShown) list += QLatin1Char('\n') + tr("and %1 more").arg(files.size() - kShown);
  question->setInformativeText(
      list + QStringLiteral("\n\n") +
      tr("A workcell from someone else can name any file on this computer. Check that all of these belong to it."));
  if (files.size() > kShown) question->setDetailedText(files.join(QLatin1Char('\n')));
  QPushButton* all = question->addButton(tr("Pack them too"), QMessageBox::AcceptRole);
  question->setDefaultButton(question->addButton(QMessageBox::Cancel));
  connect(question, &QMessageBox::buttonClicked, this, [this, path, all](QAbstractButton* clicked) {
    if (clicked == all) return packTo(path, true);
    emit finished(path, false);
  });
  question->open();
}

void ExportWork::packTo(const QString& path, bool allow_outside) {
  const DocumentState state = host_.documentModel().document().state();
  const workcell::PackScope scope{host_.documentModel().document().path().parent_path(), allow_outside};
  const std::string name = (host_.documentModel().title() + ".hcell").toStdString();
  const auto work = [this, path, state, name,
                     scope](workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
    monitor.report(Text("packing"), 0.0);
    Diagnostics notes;
    const auto packed = workcell::pack(state, path.toStdString(), name, scope, notes, &monitor);
    HAPTICELL_TRY(packed);
    if (!packed->isWritten()) {
      QStringList outside;
      for (const auto& file : packed->outside) outside << plainLines(QString::fromStdString(file.string()));
      return BackgroundWork::Then([this, path, outside] { askOutside(path, outside); });
    }
    return BackgroundWork::Then([this, path, notes] { reportWritten(path, notes.warnings); });
  };
  run(path, work, tr("%1 was not saved").arg(QFileInfo(path).fileName()));
}

void ExportWork::reportTo(const QString& path, Against against, const QString& other) {
  const workcell::Document& document = host_.documentModel().document();
  const std::string file = against == Against::kOtherCell ? other.toStdString() : document.path().string();
  const QString failed = tr("%1 was not saved").arg(QFileInfo(path).fileName());
  if (against == Against::kSaved && file.empty()) {
    host_.messages().tell(Severity::kWarning, failed,
                          tr("This cell has never been saved. Compare it with the imported files instead."));
    emit finished(path, false);
    return;
  }
  const QString against_text = against == Against::kImport ? tr("the placements of the imported files")
                                                           : QFileInfo(QString::fromStdString(file)).fileName();
  const auto work = [=, this, state = document.state(), cell = host_.documentModel().title()](
                        workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
    const auto before = stateBefore(against, state, file, monitor);
    HAPTICELL_TRY(before);
    const auto written = writeChanges(workcell::compareStates(*before, state), cell, against_text, path);
    HAPTICELL_TRY(written);
    return BackgroundWork::Then([this, path] { reportWritten(path, {}); });
  };
  run(path, work, failed);
}

}  // namespace hapticell::app
