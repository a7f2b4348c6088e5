// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// A scene as glTF 2.0 (Khronos Group; ISO/IEC 12113): the tree with names and placements, meshes shared by their
/// nodes, one material per colour. Metres, y up, 32-bit coordinates, linear colours, as the standard requires.
/// `binary`: the bytes of a .glb; else a .gltf with embedded data.
std::string gltfBytes(const ImportedScene& scene, bool binary);

}  // namespace hapticell::workcell
