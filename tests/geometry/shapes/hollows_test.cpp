// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/hollows.h"

#include <gtest/gtest.h>

#include <utility>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "geometry/shapes/topology.h"

namespace hapticell::geometry {
namespace {

TEST(Hollows, AreTakenOutOfSolidsAndNothingElse) {
  TriangleMesh bubble = makeSphere(0.2);
  for (Triangle& t : bubble.triangles) std::swap(t[0], t[1]);
  const TriangleMesh box = makeBox(dvec3(1.0)), pipe = makePipe(0.4, 0.2, 1.0);
  TriangleMesh mesh = bubble;
  append(mesh, box, Pose::identity());
  append(mesh, bubble, Pose::translation({0.2, 0.1, 0.0}));
  append(mesh, pipe, Pose::translation({3.0, 0.0, 0.0}));
  ASSERT_EQ(topologyOf(mesh).shells, 4u);
  const TriangleMesh solid = withoutHollows(mesh);
  EXPECT_EQ(topologyOf(solid).shells, 2u);
  EXPECT_EQ(solid.vertices.size(), box.vertices.size() + pipe.vertices.size());
  EXPECT_EQ(solid.triangles.size(), box.triangles.size() + pipe.triangles.size());
  EXPECT_NEAR(massProperties(solid).volume, massProperties(box).volume + massProperties(pipe).volume, 1e-12);
}

}  // namespace
}  // namespace hapticell::geometry
