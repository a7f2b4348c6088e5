// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::importer {

/// Replaces the <polygons> of a Collada <mesh>, of which some have holes (<ph>), by <triangles> with the same inputs.
/// Gives the number of polygons that could not be cut.
int cutPolygonsWithHoles(pugi::xml_node mesh, pugi::xml_node polygons);

/// Cuts a flat polygon with holes into triangles: numbers of its points, `loops` one after another (the outline first),
/// turning as the outline does. Empty where that fails (edges that cross, no area).
std::vector<int> cutPolygon(const std::vector<std::vector<dvec3>>& loops);

}  // namespace hapticell::importer
