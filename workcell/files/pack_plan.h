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

/// Plans a pack. A document may be a stranger's and name any file of this machine; so only what was read as what it
/// claims to be is taken: a file whose shapes the state holds or that is read here as shapes (also one that only an
/// assembly names), a robot with those files that were read for it and their packages' manifests, a recording that is
/// read here as one, and what such a file names beside it (isWhatItClaims()). Errors: a file that is none of these,
/// with who names it; over 2 GB.
Expected<PackPlan> planPack(DocumentState state, const PackScope& scope, Diagnostics& diagnostics,
                            ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
