// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// True for an SDF file that is a cell rather than a robot. A robot is one model with links of its own and a joint that
/// moves, at the top of the file, in a world or alone in a model, with no other model beside it that has a shape
/// (a ground plane has none).
bool isSdfCell(const std::filesystem::path& file);

/// Reads an SDF world or static model (sdformat.org, versions 1.2 to 1.11) as a tree: models, their links where there
/// are several, and their visual shapes (a link's collision shapes where it has no visual one). libsdformat says where
/// they stand: frames, `relative_to`, `placement_frame`, models inside models (see SdfSource). Meshes in any readable
/// format are in metres; Collada is taken as it stands, without its up axis, as Gazebo does. See findSdfFile().
///
/// A model or mesh that is not there, a name that is there twice, a pose of too few numbers and the like are told; the
/// rest is read. What is silent, told and refused stands in docs/user/formats.md. Errors: see SdfSource::load(),
/// cancelled. A model with joints that move is a robot, a solid where `with_robots` is false or it makes no robot
/// (told).
Expected<ImportedScene> readSdfCell(const std::filesystem::path& file, ImportMonitor* monitor, bool with_robots = true);

}  // namespace hapticell::workcell
