// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// Whose axes a move follows; kFrame: those of the chosen frame.
enum class EditAxes { kWorld, kParent, kOwn, kFrame };

/// The pose of an entity's parent: the link or solid that carries it, else the entity above it in the tree; identity if
/// it has neither.
Pose parentPose_W(const workcell::DocumentState& state, const workcell::Entity& entity);

/// The entities of `ids` that a common move places. Leaves out locked entities, and those that another of `ids` already
/// moves (because they are below it in the tree or attached to it).
std::vector<workcell::EntityId> movedTogether(const workcell::DocumentState& state,
                                              const std::vector<workcell::EntityId>& ids);

/// The commands that move each entity from its pose X_WE to M_W * X_WE. Unknown ids are left out.
std::vector<workcell::Command> moveCommands(const workcell::DocumentState& state,
                                            const std::vector<workcell::EntityId>& ids, const Pose& M_W);

/// `value` rounded to a multiple of `step` (0: unchanged).
double stepped(double value, double step);

/// The motion that puts frame F of a part onto frame T of another one. Origins meet; with `align`, axes meet too, with
/// the z axes opposed if `face_to_face` (a face put onto a face).
Pose motionOnto(const Pose& X_WF, const Pose& X_WT, bool align, bool face_to_face);

}  // namespace hapticell::app
