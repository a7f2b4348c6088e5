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

/// Colours (Kd) by the names of a material library (MTL, Wavefront; sRGB as on the screen). Materials without one, or
/// with one that is no three finite numbers, are not among them; Kd as a curve ("spectral") or in CIE XYZ is not read.
/// Pictures (map_Kd) and unknown lines are reported in `diagnostics`. Any bytes are survived.
std::map<std::string, Color> parseObjMaterials(std::string_view content, Diagnostics& diagnostics);

/// The colours of all libraries that an OBJ file names. They are looked for in the file's own folder and below it,
/// never above: of a name that leads elsewhere ("../x.mtl", "C:\\x.mtl", "/x.mtl", a link) only a file of that name
/// beside the OBJ file is taken. A file that is missing, too large (16 MB) or not a regular file gives a warning.
std::map<std::string, Color> readObjMaterials(const std::filesystem::path& obj_file,
                                              const std::vector<std::string>& libraries, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
