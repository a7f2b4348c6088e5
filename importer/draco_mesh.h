// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// A mesh unpacked from KHR_draco_mesh_compression.
struct UnpackedMesh {
  std::vector<float> positions;          ///< Three per vertex.
  std::vector<std::uint32_t> triangles;  ///< Three per triangle.
};

/// Unpacks a mesh with libdraco; `attribute` is the unique number of its positions. If the mesh has no such attribute,
/// the first one that the library calls positions is taken. Errors: of another kind, damaged.
Expected<UnpackedMesh> unpackDraco(std::string_view bytes, std::uint32_t attribute);

}  // namespace hapticell::importer
