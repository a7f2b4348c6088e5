// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/topology.h"

#include <gtest/gtest.h>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::geometry {
namespace {

TEST(Topology, OfClosedShapesFollowsEuler) {
  EXPECT_EQ(topologyOf(makeBox(dvec3(1.0))).euler_characteristic, 2);
  EXPECT_EQ(topologyOf(makeTorus(0.4, 0.1)).euler_characteristic, 0);
  EXPECT_EQ(topologyOf(makePipe(0.4, 0.2, 1.0)).euler_characteristic, 0);
  EXPECT_EQ(topologyOf(makeSphere(1.0)).holes, 0u);
}

TEST(Topology, CountsShellsAndHoles) {
  TriangleMesh two = makeBox(dvec3(1.0));
  append(two, makeSphere(0.2), Pose::translation({3.0, 0.0, 0.0}));
  two.triangles.erase(two.triangles.begin());
  const Topology topology = topologyOf(two);
  EXPECT_EQ(topology.shells, 2u);
  EXPECT_EQ(topology.holes, 1u);
  EXPECT_EQ(topology.border_edges, 3u);
  EXPECT_EQ(topology.rejected_triangles, 0u);
}

TEST(Topology, CountsWhatDoesNotFit) {
  const TriangleMesh fin{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                         {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 0, 1}}};
  EXPECT_EQ(topologyOf(fin).rejected_triangles, 2u);
  EXPECT_EQ(topologyOf({}).shells, 0u);
}

}  // namespace
}  // namespace hapticell::geometry
