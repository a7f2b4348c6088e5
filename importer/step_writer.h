// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "importer/parent_link.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::importer {

/// Writes a scene as STEP AP214 (millimetres): the tree with names, placements and colours. A node with an origin keeps
/// the exact shape of its file, another is written with a plane face a triangle. Nodes that share a mesh and a colour
/// become uses of one part, which is written once; where their names differ, each use has its own (kSharedPart). May
/// throw what the library throws.
Expected<void> writeStep(const workcell::ImportedScene& scene, const std::filesystem::path& file, ParentLink& parent);

}  // namespace hapticell::importer
