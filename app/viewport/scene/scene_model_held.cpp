// SPDX-License-Identifier: Apache-2.0
// Which parts keep their shape in motion.
#include <algorithm>

#include "app/viewport/scene/scene_model.h"

namespace hapticell::app {

/// What a stylus holds, or what is chosen alone: what the hand or the eye is at; with all that hangs on it.
std::vector<workcell::EntityId> SceneModel::held() const {
  std::vector<workcell::EntityId> ids;
  if (snapshot_ && snapshot_->held != 0) ids.push_back(snapshot_->held);
  if (snapshot_ && snapshot_->second && snapshot_->second->held != 0) ids.push_back(snapshot_->second->held);
  if (selected_.size() == 1) ids.push_back(selected_.front());
  const auto has = [&ids](workcell::EntityId id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const workcell::Entity* carrier = find(ids[i]);
    if (!carrier) continue;
    for (const workcell::Entity& entity : entities_)
      if (!entity.attachment.to.empty() && entity.attachment.to == carrier->name && !has(entity.id))
        ids.push_back(entity.id);
  }
  return ids;
}

/// What is held, and all that is near a part of it.
void SceneModel::markKept(std::vector<RenderItem>& items) const {
  const std::vector<workcell::EntityId> ids = held();
  std::vector<geometry::Bounds> boxes;
  for (RenderItem& item : items) {
    item.keeps_shape = std::find(ids.begin(), ids.end(), item.entity) != ids.end();
    if (item.keeps_shape && !item.unseen) boxes.push_back(geometry::transformed(item.X_WM, item.bounds_M));
  }
  if (boxes.empty()) return;
  for (RenderItem& item : items) {
    const geometry::Bounds box = geometry::transformed(item.X_WM, item.bounds_M);
    item.keeps_shape = item.keeps_shape || std::any_of(boxes.begin(), boxes.end(), [&](const geometry::Bounds& one) {
                         const dvec3 apart = glm::max(glm::max(one.min - box.max, box.min - one.max), dvec3(0.0));
                         return glm::length(apart) < kNearHeld;
                       });
  }
}

}  // namespace hapticell::app
