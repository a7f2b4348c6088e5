// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// What is packed by KHR_draco_mesh_compression.
struct UnpackedMesh {
  std::vector<float> positions;          ///< Three for each vertex.
  std::vector<std::uint32_t> triangles;  ///< Three for each triangle.
};

/// Unpacks a mesh with libdraco; `attribute` is the unique number of its positions. Errors: not of that kind, damaged.
Expected<UnpackedMesh> unpackDraco(std::string_view bytes, std::uint32_t attribute);

}  // namespace hapticell::importer
