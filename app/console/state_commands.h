// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "workcell/document/command.h"

namespace hapticell::app {

class DocumentModel;

/// Commands that lead from one state of a cell to another; entities are the same if their names are, or if one is gone
/// and a single new one has its shape (then it was renamed). The commands are tried on a copy, and the text of what comes
/// of them is compared with that of `wanted`, numbers within 1e-9. Added entities come before all that names them, and
/// count as numbered from the largest id of `now` on. Error: no such commands were found. Any thread.
Expected<std::vector<workcell::Command>> commandsBetween(const workcell::DocumentState& now,
                                                         const workcell::DocumentState& wanted);

/// Executes them on a document of the state `now` as one step of undo with this text; all or none. The document numbers
/// added entities in its own way, which later commands then follow. Error: a command is refused. GUI thread.
Expected<void> executeCommands(DocumentModel& model, const QString& text, const std::vector<workcell::Command>& commands);

}  // namespace hapticell::app
