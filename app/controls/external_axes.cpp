// SPDX-License-Identifier: Apache-2.0
#include "app/controls/external_axes.h"

#include "kinematics/model/mounted_robot.h"

namespace hapticell::app {

std::vector<const workcell::Entity*> externalAxes(const workcell::DocumentState& state, const workcell::Entity& robot) {
  std::vector<const workcell::Entity*> axes;
  const workcell::Entity* at = &robot;
  for (std::size_t k = 0; k < state.entities.size() && !at->attachment.to.empty(); ++k) {
    const workcell::Entity* carrier = state.findByName(at->attachment.to);
    if (!carrier) break;
    const int link = carrier->robot() ? carrier->robot()->findLink(at->attachment.link) : -1;
    if (link >= 0 && !carrier->locked && !carrier->robot()->closure && kinematics::isMoved(*carrier->robot(), link))
      axes.insert(axes.begin(), carrier);
    at = carrier;
  }
  return axes;
}

}  // namespace hapticell::app
