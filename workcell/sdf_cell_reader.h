// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "workcell/import_scene.h"

namespace hapticell::workcell {

/// True for an SDF file that is a cell rather than a robot: it holds a world, or a model without a joint that moves
/// or whose links are all in models inside it.
bool isSdfCell(const std::filesystem::path& file);

/// Reads an SDF world or static model (sdformat.org, versions 1.4 to 1.10) as a tree: models, their links where there
/// are several, and their visual shapes (a link's collision shapes where it has no visual one). Meshes in any readable
/// format are in metres; Collada is taken as it stands, without its up axis, as Gazebo does. "model://NAME" is looked
/// for beside the file, in "models" and upwards from there, and in the folders of GZ_SIM_RESOURCE_PATH,
/// GAZEBO_MODEL_PATH and SDF_PATH.
///
/// A model or mesh that is not there is left out and told; the rest is read. A pose with fewer than six numbers is read
/// as far as it goes, and told. Errors: no XML, nested deeper than 200, not SDF. Planes, height maps, lights, plugins
/// and joints are passed over.
Expected<ImportedScene> readSdfCell(const std::filesystem::path& file, ImportMonitor* monitor);

}  // namespace hapticell::workcell
