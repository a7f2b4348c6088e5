// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/entity/import_options.h"

namespace hapticell::importer {

/// What must be known of a Collada file before assimp reads it, and its text in words that assimp 5.2.5 takes.
struct ColladaText {
  std::string text;  ///< Empty: the file is fit as it stands.
  double metres_per_unit = 1.0;
  bool unit_is_stated = false;
  workcell::UpAxis up = workcell::UpAxis::kY;
  std::vector<Text> warnings;
};

/// Reads the file as XML. Taken out or rewritten is what assimp would refuse the whole file for though it plays no part
/// or has a plain meaning: cameras and lights, blanks before a colour's first number, a geometry that stands twice at a
/// node, polygons with holes (cut into triangles); nodes without a name get their id, since names go before ids.
/// Errors: no XML, with its line.
Expected<ColladaText> readColladaText(const std::filesystem::path& file);

}  // namespace hapticell::importer
