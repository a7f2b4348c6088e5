// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <span>

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// Some large balls inside the solid of a mesh, free of all its triangles. Where balls of two placed meshes overlap,
/// the meshes collide: both solids have a common point, so their surfaces meet or a piece of one lies inside the other.
/// Immutable; a mesh that encloses nothing has none.
class InnerBalls {
 public:
  /// Half: a quarter fewer collisions are seen at once; twice: four times the pairs of balls.
  static constexpr std::size_t kMost = 16;

  struct Ball {
    dvec3 p{0.0};         ///< Its middle, in the mesh's frame,
    double radius = 0.0;  ///< and its radius, m: less than the distance to the surface.
  };

  /// Some hundred searches for the nearest point: a millisecond for any mesh.
  explicit InnerBalls(const MeshCollider& mesh);

  std::span<const Ball> balls() const { return {balls_.data(), count_}; }
  /// Whether one of these balls of A overlaps one of B's. Any thread.
  bool overlap(const Pose& X_WA, const InnerBalls& b, const Pose& X_WB) const;

 private:
  void fill(const MeshCollider& mesh);
  void round();

  std::array<Ball, kMost> balls_{};
  std::size_t count_ = 0;
  /// The same in float, side by side, smaller by what that rounds; those that are not used are far away.
  alignas(16) float at_[3][kMost];
  alignas(16) float radius_[kMost];
};

/// The balls of a mesh that is asked about often. Any thread; waits for none.
class InnerBallsOnDemand {
 public:
  InnerBallsOnDemand() = default;
  InnerBallsOnDemand(const InnerBallsOnDemand&) = delete;
  InnerBallsOnDemand& operator=(const InnerBallsOnDemand&) = delete;
  ~InnerBallsOnDemand() { delete made_.load(); }

  /// Null for the first questions, so that a cell that is looked at a few times never makes them. `mesh` is always the
  /// same. Allocates once.
  const InnerBalls* get(const MeshCollider& mesh);

 private:
  std::atomic<int> asked_{0};
  std::atomic<const InnerBalls*> made_{nullptr};
};

}  // namespace hapticell::collision
