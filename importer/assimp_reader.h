// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/system/error.h"
#include "importer/reading.h"

namespace hapticell::importer {

/// Reads glTF, GLB, Collada, 3MF, FBX or 3DS with assimp. Scales and mirrorings of nodes are applied to the meshes, so
/// that every placement is rigid; triangles with a corner that is not finite are dropped and reported. May throw.
Expected<workcell::ImportedScene> readWithAssimp(const Reading& reading, ParentLink& parent);

}  // namespace hapticell::importer
