// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

/// What may go into a pack.
struct PackScope {
  /// The document's folder. Files not in or below it are outside; if the document was never saved (empty), all are. A
  /// link counts as its target.
  std::filesystem::path folder = {};
  bool allow_outside = false;
};

struct PlannedCopy {
  std::filesystem::path from;  ///< The file with the bytes: absolute, links followed.
  std::string place;           ///< Path in the pack, "files/arm/meshes/base.stl".
};

/// All files that a state names, and their paths in the pack.
struct PackPlan {
  DocumentState state;  ///< Names the files by their paths in the pack.
  std::vector<PlannedCopy> copies;
  std::vector<std::filesystem::path> outside;  ///< Of the copied files, each once; as they are named.
};

/// Plans a pack. A document may come from a stranger and name any file of this machine, so a file is packed only if it
/// could be read as what it claims to be (isWhatItClaims()): files whose shapes the state contains or that are read
/// here as shapes (including those named only by an assembly); robots with the files that were read for them and their
/// packages' manifests; recordings that are read here; and files next to these that they name. Errors: any other file,
/// with the name of what refers to it; over 2 GB.
Expected<PackPlan> planPack(DocumentState state, const PackScope& scope, Diagnostics& diagnostics,
                            ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
