// SPDX-License-Identifier: Apache-2.0
#include "app/controls/reference_choice.h"

#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/icon.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

std::vector<Reference> referencesOf(const workcell::DocumentState& state, workcell::EntityId without) {
  std::vector<Reference> found, own;
  for (const auto& entity : state.entities) {
    if (without != 0 && workcell::isCarriedBy(state, *entity, without)) continue;
    const QString name = QString::fromStdString(entity->name);
    if (entity->kind() == workcell::EntityKind::kFrame) found.push_back({name, entity->id});
    for (const workcell::Frame& frame : entity->frames)
      own.push_back({name + QStringLiteral(" · ") + QString::fromStdString(frame.name), entity->id, frame.name});
  }
  found.insert(found.end(), own.begin(), own.end());
  return found;
}

ReferenceChoice::ReferenceChoice(Host& host, const QStringList& fixed, QWidget* parent)
    : QComboBox(parent), host_(host), fixed_(static_cast<int>(fixed.size())) {
  addItems(fixed);
  setMinimumContentsLength(8);
  setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
  connect(this, &QComboBox::activated, this, [this] {
    wanted_ = chosen();
    emit referenceChanged();
  });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &ReferenceChoice::list);
  list();
}

void ReferenceChoice::leaveOut(workcell::EntityId entity) {
  if (entity == without_) return;
  without_ = entity;
  list();
}

std::optional<Reference> ReferenceChoice::chosen() const {
  const int index = currentIndex() - fixed_;
  if (index < 0 || index >= static_cast<int>(references_.size())) return std::nullopt;
  return references_[static_cast<std::size_t>(index)];
}

int ReferenceChoice::fixedEntry() const {
  return currentIndex() < fixed_ ? currentIndex() : -1;
}

void ReferenceChoice::list() {
  const auto before = chosen();
  auto fresh = referencesOf(host_.documentModel().document().state(), without_);
  if (fresh != references_) {
    const bool had = hasFrames();
    references_ = std::move(fresh);
    while (count() > fixed_) removeItem(count() - 1);
    for (const Reference& reference : references_) addItem(icon("frame"), reference.name);
    const auto again = std::find_if(references_.begin(), references_.end(), [&](const Reference& reference) {
      return wanted_ && reference.entity == wanted_->entity && reference.frame == wanted_->frame;
    });
    setCurrentIndex(again == references_.end() ? 0 : fixed_ + static_cast<int>(again - references_.begin()));
    if (had != hasFrames()) emit framesListed();
  }
  if (before || chosen()) emit referenceChanged();
}

bool ReferenceChoice::goesWith(workcell::EntityId entity) const {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  const auto reference = chosen();
  const workcell::Entity* frame = reference ? state.find(reference->entity) : nullptr;
  return frame && workcell::isCarriedBy(state, *frame, entity);
}

std::optional<Pose> ReferenceChoice::frame_W() const {
  const auto reference = chosen();
  return reference ? frame_W(*reference) : std::nullopt;
}

std::optional<Pose> ReferenceChoice::frame_W(const Reference& reference) const {
  const workcell::Entity* entity = host_.documentModel().document().find(reference.entity);
  if (!entity) return std::nullopt;
  const Pose X_WE = host_.viewport().scene().placement_W(*entity);
  if (reference.frame.empty()) return X_WE;
  for (const workcell::Frame& frame : entity->frames)
    if (frame.name == reference.frame) return X_WE * frame.X_EF;
  return std::nullopt;
}

}  // namespace hapticell::app
