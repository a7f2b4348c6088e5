// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The bytes in which a scene goes from and to the importer's process: the same machine, the same program version.
std::string sceneBytes(const ImportedScene& scene);

/// A scene from such bytes. They come from a process that may have gone mad, so everything is checked: lengths against
/// what is there, indices, parents before children, numbers finite and below 1e12, unit quaternions, colours 0 to 1.
Expected<ImportedScene> sceneFromBytes(std::string_view bytes);

/// The name of the assembly that a STEP file of ours has around several or moved roots; it is left out when such a file
/// is read back.
constexpr const char* kWorkcellRoot = "HaptiCell workcell";

/// Turns a frame whose `up` axis points up into one whose z does: (x, -z, y) for y.
Pose turnedUp(UpAxis up);

}  // namespace hapticell::workcell
