// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// True for an SDF file that is a cell and not a robot. A robot is one model with its own links and a moving joint, at
/// the top of the file, in a world or alone in a model, without another model that has a shape (a ground plane has
/// none).
bool isSdfCell(const std::filesystem::path& file);

/// Reads an SDF world or static model (sdformat.org, versions 1.2 to 1.11) as a tree: models, their links if there are
/// several, and their visual shapes (for a link without one, its collision shapes). libsdformat computes their poses:
/// frames, `relative_to`, `placement_frame`, models inside models (see SdfSource). Meshes in any readable format are in
/// metres; Collada is used unchanged, without its up axis, as in Gazebo. See findSdfFile().
///
/// Missing models and meshes, duplicate names, poses with too few numbers and the like are reported; the rest is read.
/// docs/user/formats.md lists what is ignored, reported and an error. Errors: see SdfSource::load(), cancelled. A model
/// with moving joints becomes a robot; a solid if not `with_robots`, or if it cannot become a robot (reported).
Expected<ImportedScene> readSdfCell(const std::filesystem::path& file, ImportMonitor* monitor, bool with_robots = true);

}  // namespace hapticell::workcell
