// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// Writes a robot as URDF at its placement in the cell: a link "world" (or "cell", if that name is taken) and a fixed
/// joint from it to the robot's root at X_WE. Meshes are written as STL (metres) into a folder next to the file,
/// "STEM_meshes"; primitive shapes of the source become meshes too. Keeps limits, axes, couplings (mimic) and colours.
/// Masses and transmissions, which the model does not have, are not written; closed loops, which URDF cannot express,
/// are reported. Each file is written as a temporary file and then moved into place.
///
/// Errors: not a robot, nothing to write.
Expected<void> writeUrdf(const Entity& robot, const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
