// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "importer/parent_link.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::importer {

/// Writes a scene as STEP AP214 (millimetres): the tree with names, placements and colours. A node with an origin keeps
/// the exact shape of its file; others are written with one plane face per triangle. Nodes of one name that share a
/// mesh become uses of one part. May throw the library's exceptions.
Expected<void> writeStep(const workcell::ImportedScene& scene, const std::filesystem::path& file, ParentLink& parent);

}  // namespace hapticell::importer
