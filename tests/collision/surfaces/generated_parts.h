// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::test {

/// A closed part made of known surfaces, tessellated as a CAD system does it: vertices on the true surface.
struct GeneratedPart {
  std::string name;
  geometry::TriangleMesh mesh;
  std::vector<collision::SurfaceType> truth;  ///< Per triangle.
  std::vector<double> radii;                  ///< Of its cylinders, spheres and tubes (m), each once.
};

/// Boxes with rounded edges, plate with bores, shaft, torus, sphere, brackets, boss, groove: sizes of 20 to 120 mm.
std::vector<GeneratedPart> generatedParts();
GeneratedPart generatedPart(const std::string& name);

}  // namespace hapticell::test
