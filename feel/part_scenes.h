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

/// What no surface of the kinds that are recognised tells: a dish that is free-form and hollow, a trough of flat
/// facets, a rack with teeth.
std::vector<Part> freeFormParts();

/// The held ball on the top of the part, pressed down and led over it. The truth knows how deep the ball is in the
/// triangles, by a distance query of its own, and of the force nothing: depth and direction are not measured. A part
/// under whose bounds' middle there is nothing is felt beside it, or not at all.
MeshCase makePartCase(const Part& part);

}  // namespace hapticell::feel
