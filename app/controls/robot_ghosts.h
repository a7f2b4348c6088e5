// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/scene/scene_model.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// The robot at other joint values, with everything attached to it (grippers, gripped parts). Empty if the document has
/// no such robot.
std::vector<GhostPose> robotGhosts(const workcell::DocumentState& state, workcell::EntityId robot,
                                   const std::vector<double>& joints, bool touches = false);

/// Any entity at another pose, with everything attached to it.
std::vector<GhostPose> entityGhosts(const workcell::DocumentState& state, workcell::EntityId entity, const Pose& X_WE,
                                    const std::vector<double>& joints, bool touches = false);

/// Joint values at a fraction `s` (0 to 1) of the straight line between the two.
std::vector<double> jointsBetween(const std::vector<double>& from, const std::vector<double>& to, double s);

}  // namespace hapticell::app
