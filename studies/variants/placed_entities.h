// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studies/variants/variant_cell.h"

namespace hapticell::studies {

/// Moves an entity of a variant's cell, a locked one too: the lock is for people at the window. What is attached to it or
/// below it moves along.
Expected<void> place(workcell::Document& document, workcell::EntityId id, const Pose& X_WE);

/// Puts another body in the place of a mannequin, in the same posture, its feet where those of the other stand.
/// `fresh` is a mannequin.
Expected<void> replaceBody(workcell::Document& document, workcell::EntityId id, const workcell::Entity& fresh);

}  // namespace hapticell::studies
