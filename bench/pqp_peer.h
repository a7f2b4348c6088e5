// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::bench {

/// The Proximity Query Package 1.3 (rectangle swept spheres for distances, oriented boxes for contact), which begins
/// each distance with the last pair of triangles. Its licence allows research only, so it is measured where it is
/// installed and never a part of the program.
class PqpPeer {
 public:
  PqpPeer(const geometry::TriangleMesh& moved, const geometry::TriangleMesh& standing);
  ~PqpPeer();
  /// With a queue of so many pairs of boxes of which the nearest is opened first; 2: depth first, as PQP does by itself.
  double distance(const Pose& X_WM, int queue = 2);
  bool isWithin(const Pose& X_WM, double tolerance);
  bool collides(const Pose& X_WM);
  /// Forgets the last pair of triangles.
  void forget();

 private:
  struct Models;
  std::unique_ptr<Models> models_;
};

}  // namespace hapticell::bench
