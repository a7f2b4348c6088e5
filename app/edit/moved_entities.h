// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// Whose axes a move follows; kFrame: those of a frame that is chosen.
enum class EditAxes { kWorld, kParent, kOwn, kFrame };

/// The parent of an entity: the link or solid that carries it, else the entity it stands below in the tree; identity
/// where there is neither.
Pose parentPose_W(const workcell::DocumentState& state, const workcell::Entity& entity);

/// Those of `ids` that a common move places: locked ones are left out, and so are those that another of them takes
/// along (it stands below or hangs on it).
std::vector<workcell::EntityId> movedTogether(const workcell::DocumentState& state,
                                              const std::vector<workcell::EntityId>& ids);

/// The commands that take each of them from its pose X_WE to M_W * X_WE. Unknown ids are left out.
std::vector<workcell::Command> moveCommands(const workcell::DocumentState& state,
                                            const std::vector<workcell::EntityId>& ids, const Pose& M_W);

/// `value` moved to the next multiple of `step` (0: as it is).
double stepped(double value, double step);

/// The motion that puts frame F of a part onto frame T of another: origins meet; `align`: and so do the axes, with z
/// against z where `face_to_face` (a face put onto a face).
Pose motionOnto(const Pose& X_WF, const Pose& X_WT, bool align, bool face_to_face);

}  // namespace hapticell::app
