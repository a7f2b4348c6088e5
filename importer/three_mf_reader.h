// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "importer/gltf_reader.h"

namespace hapticell::importer {

/// The content of a 3MF file, in its own unit.
struct ThreeMfModel {
  ModelScene model;
  double metres_per_unit = 1e-3;  ///< Of the root model (3MF core specification 1.3, section 3.4.1).
};

/// Reads the build of a 3MF file: meshes, components, also in other parts of the package (production extension),
/// placements, names (of the object; if it has none, those that slicers store next to the model) and colours (base
/// materials, colour groups). Error: a required extension that is not supported, by its name.
Expected<ThreeMfModel> readThreeMf(const std::filesystem::path& file);

}  // namespace hapticell::importer
