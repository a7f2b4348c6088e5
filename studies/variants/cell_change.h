// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/document.h"

namespace hapticell::studies {

/// What a variant changes: the entities of `variant` that differ from those of the `given` cell in shape, place,
/// joints, tool or attachment, in the order of the tree. Both are of one study (Study::cell(), Study::cellOf()).
std::vector<const workcell::Entity*> changedEntities(const workcell::Document& given,
                                                     const workcell::Document& variant);

/// Commands that bring the same entities of another document (found by name) into the state that they have in
/// `variant`; everything else in it stays, and so do its locks. The commands are tried on a copy, and the outcome is
/// compared with the variant. Errors: the document has no entity of such a name, or one of another kind; a command that
/// is refused; a result that differs.
Expected<std::vector<workcell::Command>> commandsFor(const workcell::Document& given, const workcell::Document& variant,
                                                     const workcell::DocumentState& present);

}  // namespace hapticell::studies
