// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::test {

/// A closed box of 12 triangles, outward, centred on the origin.
geometry::TriangleMesh boxMesh(const dvec3& size);

/// A closed sphere of latitude bands.
geometry::TriangleMesh sphereMesh(double radius, int bands = 12, int sectors = 20);

/// An open wavy sheet in the xy plane with 2 * cells * cells triangles.
geometry::TriangleMesh sheetMesh(double size, int cells, double height);

/// Loose triangles in a ball: a soup without any order, some of them needles.
geometry::TriangleMesh soupMesh(std::mt19937& random, int triangles, double radius);

/// The mesh turned inside out.
geometry::TriangleMesh flipped(geometry::TriangleMesh mesh);

/// Uniformly random rotation, position within `reach` of the origin on each axis.
Pose randomPose(std::mt19937& random, double reach);

}  // namespace hapticell::test
