// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

/// The change of one entity between two states of a workcell.
struct EntityChange {
  enum class Kind { kMoved, kAdded, kRemoved, kUnchanged };
  std::string name;
  std::string entity_kind;  ///< "solid", "robot" ...
  Kind kind = Kind::kUnchanged;
  Pose X_WBefore;         ///< Identity for added ones.
  Pose X_WAfter;          ///< Identity for removed ones.
  double distance = 0.0;  ///< Metres by which the origin moved.
  double angle = 0.0;     ///< Radians of rotation, 0 to pi.
  std::string joints;     ///< Changed joints: "joint_1 0.1 -> 0.5; ..." (rad, m).
};

/// The state as placed by the files that the entities were imported from: parts of CAD assemblies as in their file, all
/// others at the origin, robots at rest. Reads those files again, coarsely; `monitor` may be null. Errors: a missing or
/// broken file.
Expected<DocumentState> stateAtImport(const DocumentState& state, ImportMonitor* monitor, Diagnostics& diagnostics);

/// Compares by name, in the order of the later state, removed ones last. Changes below 1e-9 m and 1e-9 rad are ignored.
std::vector<EntityChange> compareStates(const DocumentState& before, const DocumentState& after);

/// The changes as CSV with a header line, SI units; `all` also lists unchanged entities.
std::string changesAsCsv(const std::vector<EntityChange>& changes, bool all);

/// "moved", "added", "removed", "unchanged".
const char* wordOf(EntityChange::Kind kind);

}  // namespace hapticell::workcell
