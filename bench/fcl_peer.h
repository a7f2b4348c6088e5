// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"

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

/// Its least distance of a group to another, and whether they collide: two trees of boxes about the objects (dynamic
/// AABB trees). `standing` is a mesh for each pose, or one for all.
class FclGroup {
 public:
  FclGroup(const std::vector<geometry::TriangleMesh>& moved, const std::vector<geometry::TriangleMesh>& standing,
           const std::vector<Pose>& X_WStanding);
  ~FclGroup();
  double distance(const std::vector<Pose>& X_WMoved);
  bool collides(const std::vector<Pose>& X_WMoved);

 private:
  void place(const std::vector<Pose>& X_WMoved);
  struct Objects;
  std::unique_ptr<Objects> objects_;
};

}  // namespace hapticell::bench
