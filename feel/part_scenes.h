// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "feel/mesh_scenes.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::feel {

/// A mesh of which no exact geometry is known; metres.
struct Part {
  std::string name;
  geometry::TriangleMesh mesh;
};

/// Parts that no recognised surface describes: a hollow free-form dish, a trough of flat facets, a rack with teeth.
std::vector<Part> freeFormParts();

/// The held ball presses down on top of the part and moves across it. A separate distance query gives the reference
/// depth of the ball in the triangles. The exact force is not known, so depth and direction of the force are not
/// measured. If there is no surface below the middle of the part's bounds, the ball may touch the part beside that
/// point or not at all.
MeshCase makePartCase(const Part& part);

}  // namespace hapticell::feel
