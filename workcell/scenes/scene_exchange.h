// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The bytes for sending a scene to and from the importer's process: same machine, same program version.
std::string sceneBytes(const ImportedScene& scene);

/// A scene from such bytes. The process may have failed, so everything is checked: lengths against the available bytes,
/// indices, parents before children, numbers finite and below 1e12, unit quaternions, colours 0 to 1.
Expected<ImportedScene> sceneFromBytes(std::string_view bytes);

/// The name of the assembly that our STEP files have above several or moved roots; it is left out when such a file is
/// read again.
constexpr const char* kWorkcellRoot = "HaptiCell workcell";

/// Turns a frame with the axis `up` pointing up into one with z up: (x, -z, y) for y.
Pose turnedUp(UpAxis up);

}  // namespace hapticell::workcell
