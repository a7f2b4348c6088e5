// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/mannequin_context.h"

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/viewport/widget/viewport_widget.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

bool isMannequin(const workcell::Entity* entity) {
  return entity && entity->figure() && entity->robot();
}

}  // namespace

MannequinContext::MannequinContext(Host& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&host_.selection(), &Selection::changed, this, &MannequinContext::follow);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    follow();
    emit documentChanged();
  });
  follow();
}

void MannequinContext::follow() {
  const workcell::Document& document = host_.documentModel().document();
  const workcell::Entity* selected = document.find(host_.selection().current());
  if (isMannequin(selected)) id_ = selected->id;
  if (selected && !isMannequin(selected) && (selected->mesh() || selected->robot())) target_ = selected->id;
  if (!isMannequin(document.find(id_))) {
    id_ = 0;
    for (const auto& other : document.state().entities) {
      if (isMannequin(other.get()) && id_ == 0) id_ = other->id;
    }
  }
  const workcell::Entity* now = entity();
  const bool same = now && seen_ && now->id == seen_->id && now->figure() == seen_->figure() &&
                    now->name == seen_->name && now->locked == seen_->locked;
  if (same || (!now && !seen_)) return;
  seen_ = now ? std::make_shared<const workcell::Entity>(*now) : nullptr;
  emit mannequinChanged();
}

const workcell::Entity* MannequinContext::entity() const {
  return id_ ? host_.documentModel().document().find(id_) : nullptr;
}

const workcell::Entity* MannequinContext::target() const {
  return target_ ? host_.documentModel().document().find(target_) : nullptr;
}

mannequin::Posture MannequinContext::posture() const {
  const workcell::Entity* now = entity();
  if (!now) return {};
  const SceneModel& scene = host_.viewport().scene();
  return mannequin::toPosture(*now->figure(), {scene.placement_W(*now), scene.joints(*now)});
}

bool MannequinContext::isHeld() const {
  return id_ && host_.snapshot() && host_.snapshot()->stylus.held == id_;
}

bool MannequinContext::isFree() const {
  return entity() && !entity()->locked && !isHeld();
}

}  // namespace hapticell::app
