// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/error.h"
#include "haptic/server/fault_recorder.h"

namespace hapticell::haptic {

/// Where faults are written when nobody says: $XDG_STATE_HOME/hapticell, else ~/.local/state/hapticell, else here.
std::filesystem::path defaultFaultFolder();

/// Writes fault-TICK.csv, a row a tick, into the folder (made if it is not there); gives its path. Never by the force
/// thread.
Expected<std::filesystem::path> writeFault(const FaultRecord& record, const std::filesystem::path& folder);

}  // namespace hapticell::haptic
