// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "feel/scene.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::feel {

/// The same thing twice: as meshes through the proximity engine, and as exact geometry.
struct MeshCase {
  std::string name;
  std::unique_ptr<FeelScene> mesh;   ///< What a client of meshes sees.
  std::unique_ptr<FeelScene> exact;  ///< The truth.
};

/// Spheres, a box and a peg as meshes (chords of at most 0.1 mm and 0.3 rad, as CAD importers make them) that touch
/// meshes of plane, cylinders, bore, corner and hole. Made by manipulation's own constraint builder: what it recognises
/// of a mesh is felt here too.
std::vector<std::string> meshCaseNames();
MeshCase makeMeshCase(const std::string& name);  ///< One of these names (contract).

/// Radius of the held ball, m: leaves a radius of 10 in the bore R15. Half: it falls deeper between teeth; twice: a
/// radius of 5 is left in the bore.
inline constexpr double kBallRadius = 0.005;
/// The ball as it is drawn: vertices on the sphere, facets inside it.
geometry::TriangleMesh heldBall();
/// What a client sees of the ball against this part at X_WP.
std::unique_ptr<FeelScene> ballAgainst(const std::string& name, const geometry::TriangleMesh& part, const Pose& X_WP);

}  // namespace hapticell::feel
