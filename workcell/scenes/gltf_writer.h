// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// A scene as glTF 2.0 (Khronos Group; ISO/IEC 12113): the tree with names and placements, meshes shared by their
/// nodes, a material a colour. Metres, y up, 32-bit coordinates, linear colours, as the standard demands. `binary`: the
/// bytes of a .glb; else a .gltf with its data inside.
std::string gltfBytes(const ImportedScene& scene, bool binary);

}  // namespace hapticell::workcell
