// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/entity/import_options.h"

namespace hapticell::importer {

/// Data of a Collada file that are needed before assimp reads it, and its text in a form that assimp 5.2.5 accepts.
struct ColladaText {
  std::string text;  ///< Empty: the file can be used unchanged.
  double metres_per_unit = 1.0;
  bool unit_is_stated = false;
  workcell::UpAxis up = workcell::UpAxis::kY;
  std::vector<Text> warnings;
};

/// Reads the file as XML. Removes or rewrites content for which assimp would reject the whole file although it is not
/// needed or has a clear meaning: cameras and lights, blanks before a colour's first number, a geometry that occurs
/// twice at a node, polygons with holes (split into triangles). Nodes without a name get their id, because names are
/// preferred to ids. Error: no XML, with its line.
Expected<ColladaText> readColladaText(const std::filesystem::path& file);

}  // namespace hapticell::importer
