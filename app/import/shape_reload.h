// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::app {

/// The commands that load the shapes again from the files, with new collision shapes, and the files that could not be
/// read.
struct ShapeReload {
  std::vector<workcell::Command> commands;
  std::vector<Text> problems;  ///< A sentence each; those entities stay as they are.
};

/// Reads all entities of `state` again whose file is one of `paths`. Blocks; any thread.
ShapeReload reloadShapes(const workcell::DocumentState& state, const std::vector<std::string>& paths,
                         workcell::ImportMonitor& monitor);

}  // namespace hapticell::app
