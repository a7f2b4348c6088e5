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
  /// The document's folder. What does not lie in it, or below it, is outside; where the document was never saved
  /// (empty) all is. A link counts where it leads to.
  std::filesystem::path folder = {};
  bool allow_outside = false;
};

struct PlannedCopy {
  std::filesystem::path from;  ///< Where the bytes are: absolute, links followed.
  std::string place;           ///< In the pack, "files/arm/meshes/base.stl".
};

/// All files that a state names, and where they go.
struct PackPlan {
  DocumentState state;  ///< Names the files by their places in the pack.
  std::vector<PlannedCopy> copies;
  std::vector<std::filesystem::path> outside;  ///< Of those that are copied, each once; as it is named.
};

/// Plans a pack. A document may come from a stranger and name any file of this machine. Therefore a file is packed only
/// if it could be read as what it claims to be (isWhatItClaims()). These are: files whose shapes the state holds or
/// that are read here as shapes (also those named only by an assembly); robots with the files that were read for them
/// and their packages' manifests; recordings that are read here; and the files next to these that they name. Errors:
/// any other file, with the name of what refers to it; over 2 GB.
Expected<PackPlan> planPack(DocumentState state, const PackScope& scope, Diagnostics& diagnostics,
                            ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
