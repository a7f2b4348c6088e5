// SPDX-License-Identifier: Apache-2.0
// The distance of two meshes, and the nearest points, while one passes over the other.
#include <collision/queries/proximity_query.h>
#include <geometry/shapes/shapes.h>

#include <cstdio>
#include <memory>

using hapticell::Pose;
namespace collision = hapticell::collision;
namespace geometry = hapticell::geometry;

int main() {
  // A collider is a mesh with its tree: made once, and shared by every query and thread.
  const std::shared_ptr<const collision::MeshCollider> plate =
      collision::MeshCollider::build(geometry::makeBox({0.4, 0.4, 0.02}));
  const std::shared_ptr<const collision::MeshCollider> ball =
      collision::MeshCollider::build(geometry::makeSphere(0.05));

  // One pair of parts that is asked again and again: each query begins with the last answer.
  collision::ProximityQuery pair(ball, plate);
  std::printf("   x (mm)   distance (mm)   nearest point of the plate (mm)\n");
  for (int step = 0; step <= 4; ++step) {
    const double x = -0.3 + 0.15 * step;
    const Pose X_WBall = Pose::translation({x, 0.0, 0.11});
    const collision::DistanceResult result = pair.distance(X_WBall, Pose::identity());
    std::printf("%9.1f   %13.3f   %.1f %.1f %.1f\n", 1e3 * x, 1e3 * result.distance, 1e3 * result.p_WB.x,
                1e3 * result.p_WB.y, 1e3 * result.p_WB.z);
  }

  // A single question, without an object that remembers.
  const Pose X_WTouching = Pose::translation({0.0, 0.0, 0.04});
  const bool colliding = collision::distance(ball, X_WTouching, plate, Pose::identity()).colliding;
  std::printf("lowered by 70 mm the ball %s the plate\n", colliding ? "is inside" : "is clear of");
  return 0;
}
