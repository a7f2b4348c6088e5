// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/cell_state.h"

#include <utility>

#include "geometry/system/assertion.h"

namespace hapticell::manipulation {

void CellState::setScene(std::shared_ptr<const PreparedScene> scene, Placements kept) {
  scene_ = std::move(scene);
  placements_ = std::move(kept);
}

bool CellState::standsOn(workcell::EntityId entity, workcell::EntityId below) const {
  const workcell::Entity* at = scene_->find(entity);
  for (std::size_t deep = 0; at != nullptr && deep <= scene_->entities().size(); ++deep) {
    if (at->id == below) return true;
    at = at->attachment.to.empty() ? nullptr : scene_->find(at->attachment.to);
  }
  return false;
}

EntityConfiguration CellState::placement(workcell::EntityId id) const {
  if (const auto moved = placements_.find(id); moved != placements_.end()) return moved->second;
  const workcell::Entity* found = find(id);
  HAPTICELL_DEMAND(found != nullptr);
  return {found->X_WE, found->joints()};
}

void CellState::tick(std::int64_t now_ns) {
  if (clock_.steps() == 0 || now_ns != clock_.now()) clock_.tick(now_ns);
}

bool areSame(const EntityConfiguration& a, const EntityConfiguration& b) {
  return a.X_WE.p == b.X_WE.p && a.X_WE.q == b.X_WE.q && a.joints == b.joints;
}

}  // namespace hapticell::manipulation
