// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/loop_feed.h"

#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/recording_hub.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {

void LoopFeed::closeCell() {
  for (const auto& entity : owner_.host().documentModel().document().state().entities)
    closed_ids_ = std::max(closed_ids_, entity->id);
}

void LoopFeed::postDocument() const {
  if (!owner_.loop()) return;
  const workcell::Document& document = owner_.host().documentModel().document();
  workcell::PairPolicy pairs = document.state().pairPolicy();
  if (document.state().findPairSet(owner_.settings().against))
    for (workcell::PairSet& set : pairs.sets) set.enabled = set.name == owner_.settings().against;
  owner_.loop()->post(manipulation::command::SetDocument{document.snapshotEntities(), std::move(pairs), document.revision()});
  postGuides();
}

void LoopFeed::postGuides() const {
  if (!owner_.loop()) return;
  std::vector<workcell::Guide> guides = owner_.host().documentModel().document().state().guides;
  if (const auto& training = owner_.host().recording().guide()) guides.push_back(*training);
  owner_.loop()->post(manipulation::command::SetGuides{std::move(guides)});
}

/// The loop may still be at the cell before.
bool LoopFeed::isOfCell(const manipulation::SceneSnapshot& snapshot) const {
  const auto isOld = [this](workcell::EntityId id) { return id != 0 && id <= closed_ids_; };
  return !isOld(snapshot.stylus.held) &&
         std::none_of(snapshot.pairs.begin(), snapshot.pairs.end(),
                      [&](const auto& pair) { return isOld(pair.moved) || isOld(pair.other); });
}

Pose LoopFeed::cameraPose_W() const {
  const Camera& camera = owner_.host().viewport().camera();
  return {camera.eye_W(), glm::normalize(glm::quat_cast(dmat3(camera.right_W(), camera.up_W(), -camera.forward_W())))};
}

dquat LoopFeed::axes_W() const {
  const workcell::Entity* frame = owner_.host().documentModel().document().findByName(owner_.settings().axes_frame);
  const Pose X_WF = frame ? owner_.host().viewport().scene().placement_W(*frame) : Pose::identity();
  return manipulation::deviceAxes(owner_.settings().axes, cameraPose_W(), X_WF);
}

void LoopFeed::postCamera() const {
  if (!owner_.loop()) return;
  const ViewportWidget& viewport = owner_.host().viewport();
  const Camera& camera = viewport.camera();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  manipulation::command::SetCamera seen;
  seen.X_WCamera = cameraPose_W();
  seen.visible_width = size.width * camera.metresPerPixel(camera.target_W, size);
  seen.p_WFocus = camera.target_W;
  owner_.loop()->post(seen);
  // Beside the first one's tip, that both pens can be taken.
  seen.p_WFocus += 0.12 * seen.visible_width * camera.right_W();
  owner_.loop()->postSecond(seen);
}

}  // namespace hapticell::app
