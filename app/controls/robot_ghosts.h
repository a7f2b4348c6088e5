// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/scene/scene_model.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// The robot at other joints, with everything attached to it (grippers, gripped parts). Empty where the document has no
/// such robot.
std::vector<GhostPose> robotGhosts(const workcell::DocumentState& state, workcell::EntityId robot,
                                   const std::vector<double>& joints, bool touches = false);

/// Any entity elsewhere, with all that hangs on it.
std::vector<GhostPose> entityGhosts(const workcell::DocumentState& state, workcell::EntityId entity, const Pose& X_WE,
                                    const std::vector<double>& joints, bool touches = false);

/// Joints at a share `s` (0 .. 1) of the straight way between two.
std::vector<double> jointsBetween(const std::vector<double>& from, const std::vector<double>& to, double s);

}  // namespace hapticell::app
