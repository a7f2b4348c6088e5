// SPDX-License-Identifier: Apache-2.0
#include "app/controls/robot_ghosts.h"

#include <algorithm>

#include "workcell/document/command.h"

namespace hapticell::app {
namespace {

/// Adds what hangs on `carrier`, and what hangs on that. A document has no circles, so it ends.
void addCarried(const workcell::DocumentState& state, const workcell::Entity& carrier, std::vector<GhostPose>& ghosts) {
  for (const auto& entity : state.entities) {
    if (entity->attachment.to != carrier.name) continue;
    workcell::Entity moved = *entity;
    moved.X_WE = workcell::carrierPose(carrier, entity->attachment.link) * entity->attachment.X_LE;
    ghosts.push_back({moved.id, moved.X_WE, moved.joints(), ghosts.front().touches});
    addCarried(state, moved, ghosts);
  }
}

}  // namespace

std::vector<GhostPose> robotGhosts(const workcell::DocumentState& state, workcell::EntityId robot,
                                   const std::vector<double>& joints, bool touches) {
  const workcell::Entity* found = state.find(robot);
  if (!found || !found->robot() || joints.size() != found->robot()->dof()) return {};
  return entityGhosts(state, robot, found->X_WE, joints, touches);
}

std::vector<GhostPose> entityGhosts(const workcell::DocumentState& state, workcell::EntityId entity, const Pose& X_WE,
                                    const std::vector<double>& joints, bool touches) {
  const workcell::Entity* found = state.find(entity);
  if (!found) return {};
  workcell::Entity moved = *found;
  moved.X_WE = X_WE;
  moved.setJoints(joints);
  std::vector<GhostPose> ghosts{{entity, X_WE, joints, touches}};
  addCarried(state, moved, ghosts);
  return ghosts;
}

std::vector<double> jointsBetween(const std::vector<double>& from, const std::vector<double>& to, double s) {
  std::vector<double> result = to;
  for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) result[i] = from[i] + s * (to[i] - from[i]);
  return result;
}

}  // namespace hapticell::app
