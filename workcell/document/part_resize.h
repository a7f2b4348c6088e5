// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// Gives a built-in part of the document other sizes (metres, in the order of BuiltInPart::sizes) and makes its shape
/// again. If the height of a part on the floor changes, entities attached to it move up or down with its top. Errors:
/// no such part, or unusable sizes; the message states the allowed ones.
Expected<std::vector<Command>> resizePart(const DocumentState& state, EntityId id, const std::vector<double>& sizes);

}  // namespace hapticell::workcell
