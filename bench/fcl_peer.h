// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace hapticell::bench {

/// The Flexible Collision Library's exact distance of two meshes (OBBRSS trees, nearest points on).
class FclPeer {
 public:
  FclPeer(const geometry::TriangleMesh& moved, const geometry::TriangleMesh& standing);
  ~FclPeer();
  double distance(const Pose& X_WM);
  bool collides(const Pose& X_WM);
  double buildMilliseconds() const;

 private:
  struct Models;
  std::unique_ptr<Models> models_;
};

}  // namespace hapticell::bench
