// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// The parts of a 3MF file (a ZIP archive, ECMA-376 part 2) that are read, by their absolute names in the archive
/// ("/3D/3dmodel.model"): models, relations and the names that slicers store next to them.
struct ModelPackage {
  std::map<std::string, std::string> parts;
};

/// Unpacks them into memory. Errors: not an archive, an entry that leads out of it or is a link, more than a gigabyte
/// when unpacked, or more than 200 times the file (a bomb).
Expected<ModelPackage> unpackModel(const std::filesystem::path& file);

}  // namespace hapticell::importer
