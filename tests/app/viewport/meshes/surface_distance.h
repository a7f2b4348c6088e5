// SPDX-License-Identifier: Apache-2.0
// How far two surfaces are apart, without anything that the program measures or simplifies with: for every point, each
// triangle that could be the nearest is looked at, in double precision, by its plane and its sides.
#pragma once

#include <cstddef>
#include <vector>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::test {

/// A triangle, and a sphere around it.
struct Corners {
  dvec3 a, b, c;
  dvec3 middle;
  double radius;
};

std::vector<Corners> cornersOf(const app::DisplayMesh& mesh, std::size_t step);

/// The point of `surface` that is nearest to `p`.
dvec3 nearestOf(const dvec3& p, const std::vector<Corners>& surface);

/// Points of a surface: about `count`, spread by area, another choice than a grid, and the middle of each triangle.
std::vector<dvec3> pointsOf(const std::vector<Corners>& surface, std::size_t count);

}  // namespace hapticell::test
