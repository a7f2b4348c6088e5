// SPDX-License-Identifier: Apache-2.0
#include "app/host/document_model.h"

#include <algorithm>
#include <utility>

#include "app/style/library_text.h"
#include "workcell/format/document_io.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::app {
namespace {

/// It changes where things stand, and nothing else. Attaching counts: it is how a glove takes hold.
bool onlyMoves(const workcell::Command& command) {
  return std::holds_alternative<workcell::SetPlacement>(command) ||
         std::holds_alternative<workcell::SetJoints>(command) ||
         std::holds_alternative<workcell::SetConfiguration>(command) ||
         std::holds_alternative<workcell::Attach>(command) || std::holds_alternative<workcell::Detach>(command);
}

}  // namespace

QString DocumentModel::title() const {
  const auto& path = document_.path();
  if (!path.empty()) return QString::fromStdString(path.stem().string());
  return origin_.empty() ? tr("New workcell") : tr("%1 copy").arg(QString::fromStdString(origin_.stem().string()));
}

bool DocumentModel::execute(const workcell::Command& command) {
  endTrialFor({command});
  const auto done = document_.execute(command);
  if (!done) {
    emit refused(shownText(done.error()));
    return false;
  }
  emit changed();
  return true;
}

bool DocumentModel::executeAll(const QString& text, const std::vector<workcell::Command>& commands) {
  endTrialFor(commands);
  const Entities before = document_.state().entities;
  document_.beginCompound(text.toStdString());
  for (const workcell::Command& command : commands) {
    const auto done = document_.execute(command);
    if (done) continue;
    if (trial_) {
      goBackTo(before);
      document_.endCompound();
    } else {
      document_.cancelCompound();
    }
    emit refused(shownText(done.error()));
    return false;
  }
  document_.endCompound();
  emit changed();
  return true;
}

bool DocumentModel::executeWithin(const std::vector<workcell::Command>& commands) {
  endTrialFor(commands);
  bool all = true;
  for (const workcell::Command& command : commands) all = all && document_.execute(command).has_value();
  emit changed();
  return all;
}

void DocumentModel::undo() {
  if (document_.undo()) emit changed();
}

void DocumentModel::redo() {
  if (document_.redo()) emit changed();
}

void DocumentModel::goTo(int steps) {
  bool moved = false;
  const auto done = [this] { return static_cast<int>(document_.undoTexts().size()); };
  while (done() > steps && document_.undo()) moved = true;
  while (done() < steps && document_.redo()) moved = true;
  if (moved) emit changed();
}

void DocumentModel::beginStep(const QString& text) {
  drop_step_ = false;
  if (trial_) trial_->step = document_.state().entities;
  document_.beginCompound(text.toStdString());
}

void DocumentModel::endStep() {
  if (!document_.inCompound()) return;
  if (std::exchange(drop_step_, false)) return cancelStep();
  if (trial_ && !trial_->step) return;
  document_.endCompound();
  if (trial_) trial_->step.reset();
  emit changed();
}

void DocumentModel::cancelStep() {
  if (!document_.inCompound()) return;
  drop_step_ = false;
  if (trial_) {
    if (!trial_->step) return;
    goBackTo(*std::exchange(trial_->step, std::nullopt));
    document_.endCompound();
  } else {
    document_.cancelCompound();
  }
  emit changed();
}

void DocumentModel::beginTrial() {
  endTrial();
  endStep();
  trial_ = Trial{document_.isDirty(), std::nullopt};
  document_.beginCompound({});
}

void DocumentModel::endTrial() {
  if (!trial_) return;
  drop_step_ = trial_->step.has_value();
  trial_.reset();
  document_.cancelCompound();
  if (drop_step_) document_.beginCompound({});
  emit changed();
  emit trialEnded();
}

void DocumentModel::endTrialFor(const std::vector<workcell::Command>& commands) {
  if (trial_ && !std::all_of(commands.begin(), commands.end(), onlyMoves)) endTrial();
}

/// Ids and order are the same: in a trial things are only moved.
void DocumentModel::goBackTo(const Entities& before) {
  for (const auto& entity : before) {
    const workcell::Entity* now = document_.find(entity->id);
    if (now && now != entity.get())
      (void)document_.execute(workcell::SetConfiguration{entity->id, entity->X_WE, entity->joints()});
  }
}

void DocumentModel::clear() {
  replaceBy(workcell::Document(), {});
}

void DocumentModel::adopt(workcell::Document document) {
  std::filesystem::path origin = document.path();
  replaceBy(std::move(document), std::move(origin));
}

void DocumentModel::adoptCopy(workcell::Document document) {
  std::filesystem::path origin = document.path();
  document.setPath({});
  replaceBy(std::move(document), std::move(origin));
}

void DocumentModel::replaceBy(workcell::Document document, std::filesystem::path origin) {
  endTrial();
  cancelStep();
  emit closing();
  document.continueAfter(document_);
  document_ = std::move(document);
  origin_ = std::move(origin);
  ++number_;
  emit opened();
  emit changed();
}

Expected<void> DocumentModel::save(const QString& path) {
  endTrial();
  const std::vector<workcell::TrajectoryReference> before = document_.state().trajectories;
  auto saved = workcell::saveDocument(document_, path.toStdString());
  std::map<std::string, std::string> moved;
  for (const auto& reference : before)
    if (const auto* now = document_.state().findTrajectory(reference.name); now && now->path != reference.path)
      moved[reference.path] = now->path;
  if (!moved.empty()) emit recordingsMoved(moved);
  if (saved) origin_ = document_.path();
  if (saved) emit changed();
  return saved;
}

Expected<std::vector<workcell::EntityId>> DocumentModel::addImported(std::vector<workcell::Entity> entities,
                                                                     const Pose& X_WF) {
  endTrial();
  auto ids = workcell::addImported(document_, std::move(entities), X_WF);
  if (ids && !document_.inCompound()) emit changed();
  return ids;
}

}  // namespace hapticell::app
