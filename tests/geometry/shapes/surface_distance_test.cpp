// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/surface_distance.h"

#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"

namespace hapticell::geometry {
namespace {

TEST(SurfaceDistance, IsThatOfKnownShapes) {
  const TriangleMesh box = makeBox(dvec3(0.1, 0.2, 0.3));
  EXPECT_NEAR(surfaceDistance(box, box).distance, 0.0, 1e-12);
  TriangleMesh moved = box;
  for (dvec3& vertex : moved.vertices) vertex.x += 0.004;
  EXPECT_NEAR(surfaceDistance(box, moved).distance, 0.004, 1e-12);
  // One corner pulled out: as far as it was pulled.
  TriangleMesh pulled = box;
  for (dvec3& vertex : pulled.vertices)
    if (vertex == box.vertices.front()) vertex += 0.01 * glm::normalize(vertex);
  const SurfaceDistance most = surfaceDistance(box, pulled);
  EXPECT_NEAR(most.distance, 0.01, 1e-9);
  EXPECT_LT(glm::distance(most.p, 1.0 * box.vertices.front()), 0.011);
  // A face that is gone is found from the other side: its middle is far from what is left.
  TriangleMesh open = box;
  open.triangles.resize(open.triangles.size() - 2);
  EXPECT_GT(surfaceDistance(open, box).distance, 0.04);
  EXPECT_FALSE(surfaceDistance(box, TriangleMesh{}).distance < 1e300);
}

}  // namespace
}  // namespace hapticell::geometry
