// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::app {

/// The commands that replace shapes by those read from the files, with new collision shapes, and the files that could
/// not be read.
struct ShapeReload {
  std::vector<workcell::Command> commands;
  std::vector<Text> problems;  ///< One sentence each; those entities do not change.
};

/// Reads all entities of `state` whose file is one of `paths` again. Blocks; any thread.
ShapeReload reloadShapes(const workcell::DocumentState& state, const std::vector<std::string>& paths,
                         workcell::ImportMonitor& monitor);

}  // namespace hapticell::app
