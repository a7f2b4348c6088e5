// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace hapticell::bench {

/// A moved mesh, a standing one, and a walk: from afar to some millimetres, along the surface, and back.
struct Scene {
  std::string name;
  geometry::TriangleMesh moved;
  geometry::TriangleMesh standing;
  std::vector<Pose> X_WM;
};

/// A gripper-like part over a plate with posts, domes and rings; about `triangles` each.
Scene cadScene(const std::string& name, int triangles);

/// Two meshes of files in millimetres or metres, the moved one walked over the standing one.
Scene fileScene(const std::string& name, geometry::TriangleMesh moved, geometry::TriangleMesh standing);

}  // namespace hapticell::bench
