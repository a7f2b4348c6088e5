// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/command.h"

#include "workcell/document/perform_command.h"

namespace hapticell::workcell {

Pose carrierPose(const Entity& carrier, const std::string& link) {
  const int index = carrier.robot() && !link.empty() ? carrier.robot()->findLink(link) : -1;
  if (index < 0) return carrier.X_WE;
  std::vector<Pose> X_EL;
  const bool known = carrier.joints().size() == carrier.robot()->dof();
  kinematics::forwardKinematics(*carrier.robot(),
                                known ? carrier.joints() : kinematics::restPositions(*carrier.robot()), X_EL);
  return carrier.X_WE * X_EL[static_cast<std::size_t>(index)];
}

Expected<EntityId> apply(const Command& command, DocumentState& state, EntityId new_id) {
  StateEdit edit(state, new_id);
  return std::visit([&](const auto& kind) { return perform(kind, edit); }, command);
}

}  // namespace hapticell::workcell
