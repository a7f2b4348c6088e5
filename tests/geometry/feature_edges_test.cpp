// SPDX-License-Identifier: Apache-2.0
#include "geometry/feature_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/shapes.h"

namespace hapticell::geometry {
namespace {

using Kind = FeatureEdge::Kind;

std::size_t count(const std::vector<FeatureEdge>& edges, Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [&](const FeatureEdge& edge) { return edge.kind == kind; }));
}

TEST(FeatureEdges, aBoxHasTwelveAndNoDiagonals) {
  const auto edges = featureEdges(makeBox({1.0, 2.0, 3.0}));
  EXPECT_EQ(edges.size(), 12u);
  EXPECT_EQ(count(edges, Kind::kCrease), 12u);
}

TEST(FeatureEdges, aCylinderHasItsTwoRims) {
  EXPECT_EQ(featureEdges(makeCylinder(0.5, 1.0, 24)).size(), 48u);
  // Eight sides meet at 45 degrees: those are edges too, unless the user allows for more.
  EXPECT_EQ(featureEdges(makeCylinder(0.5, 1.0, 8)).size(), 24u);
  EXPECT_EQ(featureEdges(makeCylinder(0.5, 1.0, 8), 0.9).size(), 16u);
}

TEST(FeatureEdges, bordersAreShown) {
  TriangleMesh open = makeBox(dvec3(1.0));
  open.triangles.pop_back();
  EXPECT_EQ(count(featureEdges(open), Kind::kBorder), 3u);
}

TEST(FeatureEdges, edgesOfThreeFacesAndOfTurnedFacesAreShown) {
  const TriangleMesh fin{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_EQ(count(featureEdges(fin), Kind::kNonManifold), 1u);
  EXPECT_EQ(count(featureEdges(fin), Kind::kBorder), 6u);
  const TriangleMesh turned{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_EQ(count(featureEdges(turned), Kind::kNonManifold), 1u);
}

TEST(FeatureEdges, aTriangleWithoutAreaMakesNoEdge) {
  const TriangleMesh sliver{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(count(featureEdges(sliver), Kind::kCrease), 0u);
}

}  // namespace
}  // namespace hapticell::geometry
