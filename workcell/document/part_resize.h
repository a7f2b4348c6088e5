// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// Gives a built-in part of the document other sizes (metres, in the order of BuiltInPart::sizes): the shape anew, and
/// where the height of what stands on the floor changes, what is attached to it goes up or down with its top. Errors:
/// no such part, or sizes that cannot be used; the sentence says which can.
Expected<std::vector<Command>> resizePart(const DocumentState& state, EntityId id, const std::vector<double>& sizes);

}  // namespace hapticell::workcell
