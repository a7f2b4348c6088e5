// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::importer {

/// Replaces the <polygons> of a Collada <mesh>, some of which have holes (<ph>), by <triangles> with the same inputs.
/// Returns the number of polygons that could not be converted.
int cutPolygonsWithHoles(pugi::xml_node mesh, pugi::xml_node polygons);

/// Splits a flat polygon with holes into triangles: indices of its points, with `loops` one after another (the outline
/// first); triangles turn like the outline. Empty if that fails (edges that cross, no area).
std::vector<int> cutPolygon(const std::vector<std::vector<dvec3>>& loops);

}  // namespace hapticell::importer
