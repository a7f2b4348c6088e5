// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::bench {

/// A moved mesh, a standing one, and a walk of 1000 poses, 3.1 mm and 0.5 degrees each: 200 from afar, 600 along the
/// surface at 1 to 10 mm, 200 away.
struct Scene {
  std::string name;
  geometry::TriangleMesh moved;
  geometry::TriangleMesh standing;
  std::vector<Pose> X_WM;
};

inline constexpr int kApproach = 200, kSlide = 600;

/// Bolts, pipes and domes on a block of 0.3 m, and on a ribbed plate of 2 m: huge triangles beside tiny ones. About so
/// many triangles each.
geometry::TriangleMesh cadPart(int triangles);
geometry::TriangleMesh cadPlate(int triangles);

/// A bumpy blob of 0.3 m and a bumpy terrain of 2 m, as scanners give them: triangles of one size.
geometry::TriangleMesh scanPart(int triangles);
geometry::TriangleMesh scanTerrain(int triangles);

/// The moved mesh led over the standing one.
Scene makeScene(const std::string& name, geometry::TriangleMesh moved, geometry::TriangleMesh standing);

/// Some of the sliding poses, each step cut in `pieces`: what a hand does between two queries at 1 kHz.
std::vector<Pose> hapticSteps(const std::vector<Pose>& walk, int first, int steps, int pieces);

/// Seven links of a chain, 16,000 triangles each, and the poses of all links step by step (0.5 degrees a joint).
struct Chain {
  std::vector<geometry::TriangleMesh> links;
  std::vector<std::vector<Pose>> X_WL;
};
Chain makeChain(int steps);

/// A link in the frame of the one before (the first: in the world), turned by `angle` (rad).
Pose chainJoint(std::size_t link, double angle);
/// The poses of its links, a joint's angle (rad) each.
std::vector<Pose> chainPoses(const std::vector<double>& angles);

/// A standing part of the cell.
struct PlacedPart {
  geometry::TriangleMesh mesh;
  Pose X_WP;
};

/// So many parts of so many triangles each around the chain, none touching it on its way.
std::vector<PlacedPart> partsAround(const Chain& chain, int parts, int triangles);

}  // namespace hapticell::bench
