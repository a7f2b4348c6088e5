// SPDX-License-Identifier: Apache-2.0
#include "app/edit/moved_entities.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numbers>

namespace hapticell::app {
namespace {

bool isAmong(const std::vector<workcell::EntityId>& ids, workcell::EntityId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// One of `ids` takes the entity along. `depth` guards against documents that hang in circles.
bool isCarried(const workcell::DocumentState& state, const workcell::Entity& entity,
               const std::vector<workcell::EntityId>& ids, std::size_t depth) {
  if (depth > state.entities.size()) return false;
  const auto takesAlong = [&](const workcell::Entity* other) {
    return other && (isAmong(ids, other->id) || isCarried(state, *other, ids, depth + 1));
  };
  if (!entity.attachment.to.empty() && takesAlong(state.findByName(entity.attachment.to))) return true;
  // Below an assembly, however deep, everything goes with it; below others it stays.
  const workcell::Entity* above = state.findByName(entity.parent);
  for (std::size_t step = 0; above && step <= state.entities.size(); ++step) {
    if (above->kind() == workcell::EntityKind::kAssembly && takesAlong(above)) return true;
    above = state.findByName(above->parent);
  }
  return false;
}

}  // namespace

Pose parentPose_W(const workcell::DocumentState& state, const workcell::Entity& entity) {
  if (!entity.attachment.to.empty())
    if (const workcell::Entity* carrier = state.findByName(entity.attachment.to))
      return workcell::carrierPose(*carrier, entity.attachment.link);
  const workcell::Entity* parent = state.findByName(entity.parent);
  return parent ? parent->X_WE : Pose::identity();
}

std::vector<workcell::EntityId> movedTogether(const workcell::DocumentState& state,
                                              const std::vector<workcell::EntityId>& ids) {
  std::vector<workcell::EntityId> moved;
  for (const auto id : ids) {
    const workcell::Entity* entity = state.find(id);
    if (entity && !entity->locked && !isCarried(state, *entity, ids, 0)) moved.push_back(id);
  }
  return moved;
}

std::vector<workcell::Command> moveCommands(const workcell::DocumentState& state,
                                            const std::vector<workcell::EntityId>& ids, const Pose& M_W) {
  std::vector<workcell::Command> commands;
  for (const auto id : ids)
    if (const workcell::Entity* entity = state.find(id))
      commands.push_back(workcell::SetPlacement{id, M_W * entity->X_WE});
  return commands;
}

double stepped(double value, double step) {
  return step > 0.0 ? step * std::round(value / step) : value;
}

Pose motionOnto(const Pose& X_WF, const Pose& X_WT, bool align, bool face_to_face) {
  if (!align) return Pose::translation(X_WT.p - X_WF.p);
  // Half a turn about x: z looks the other way.
  const dquat flip = face_to_face ? glm::angleAxis(std::numbers::pi, dvec3(1, 0, 0)) : dquat(1, 0, 0, 0);
  return X_WT * Pose::rotation(flip) * X_WF.inverse();
}

}  // namespace hapticell::app
