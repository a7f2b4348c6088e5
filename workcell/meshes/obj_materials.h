// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// Colours (Kd) by the names of a material library (MTL, Wavefront; sRGB as on the screen). Leaves out materials
/// without a colour, or whose colour is not three finite numbers; does not read Kd as a curve ("spectral") or in CIE
/// XYZ. Reports pictures (map_Kd) and unknown lines in `diagnostics`. Safe for any bytes.
std::map<std::string, Color> parseObjMaterials(std::string_view content, Diagnostics& diagnostics);

/// The colours of all libraries that an OBJ file names. Searches in and below the file's own folder, never above it:
/// for a name that leads elsewhere ("../x.mtl", "C:\\x.mtl", "/x.mtl", a link), only a file of that name next to the
/// OBJ file is used. A file that is missing, too large (16 MB) or not a regular file gives a warning.
std::map<std::string, Color> readObjMaterials(const std::filesystem::path& obj_file,
                                              const std::vector<std::string>& libraries, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
