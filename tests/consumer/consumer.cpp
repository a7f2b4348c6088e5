// SPDX-License-Identifier: Apache-2.0
#include <collision/queries/proximity_query.h>
#include <geometry/shapes/shapes.h>

#include <cstdio>

int main() {
  using namespace hapticell;
  const auto block = collision::MeshCollider::build(geometry::makeBox({0.1, 0.1, 0.1}));
  const auto result = collision::distance(block, Pose::identity(), block, Pose::translation({0.3, 0.0, 0.0}));
  std::printf("distance %.3f m\n", result.distance);
  return result.distance > 0.19 && result.distance < 0.21 ? 0 : 1;
}
