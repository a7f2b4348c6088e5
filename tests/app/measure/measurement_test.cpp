// SPDX-License-Identifier: Apache-2.0
#include "app/measure/measurement.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numbers>

#include "app/measure/part_distance.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

PickedFeature corner(const dvec3& p_W) {
  PickedFeature f;
  f.kind = FeatureKind::kVertex;
  f.p_WQ = p_W;
  return f;
}

PickedFeature edge(const dvec3& a, const dvec3& b) {
  PickedFeature f;
  f.kind = FeatureKind::kEdge;
  f.edge = EdgeShape::kLine;
  f.outline_W = {{a, b}};
  f.axis_W = glm::normalize(b - a);
  f.p_WQ = 0.5 * (a + b);
  return f;
}

PickedFeature plane(const dvec3& p_W, const dvec3& normal_W) {
  PickedFeature f;
  f.surface_W.type = collision::SurfaceType::kPlane;
  f.surface_W.p_M = f.p_WQ = p_W;
  f.surface_W.axis_M = glm::normalize(normal_W);
  return f;
}

PickedFeature circle(const dvec3& center_W, const dvec3& axis_W, double radius) {
  PickedFeature f;
  f.kind = FeatureKind::kEdge;
  f.edge = EdgeShape::kCircle;
  f.center_W = center_W;
  f.axis_W = glm::normalize(axis_W);
  f.radius = radius;
  const dvec3 x = glm::normalize(glm::cross(f.axis_W, dvec3(0.3, 0.5, 0.7))), y = glm::cross(f.axis_W, x);
  std::vector<dvec3> line;
  for (int i = 0; i <= 720; ++i) {
    const double angle = i * glm::two_pi<double>() / 720;
    line.push_back(center_W + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  f.outline_W = {line};
  f.p_WQ = line.front();
  return f;
}

dvec3 anyPoint() {
  return {*rc::gen::inRange(-100, 100) * 0.01, *rc::gen::inRange(-100, 100) * 0.01,
          *rc::gen::inRange(-100, 100) * 0.01};
}

RC_GTEST_PROP(Measurement, EdgesAreAsFarApartAsTheirDenselySampledPointsAre, ()) {
  const dvec3 a = anyPoint(), b = anyPoint(), c = anyPoint(), d = anyPoint();
  RC_PRE(glm::length(b - a) > 0.05 && glm::length(d - c) > 0.05);
  const Measurement m = measure(edge(a, b), edge(c, d));
  double sampled = 1e9;
  constexpr int kCount = 100;
  for (int i = 0; i <= kCount; ++i)
    for (int j = 0; j <= kCount; ++j)
      sampled = std::min(sampled, glm::length(a + (b - a) * (1.0 * i / kCount) - c - (d - c) * (1.0 * j / kCount)));
  RC_ASSERT(m.distance.has_value());
  RC_ASSERT(*m.distance <= sampled + 1e-12);
  RC_ASSERT(sampled - *m.distance <= 0.5 * (glm::length(b - a) + glm::length(d - c)) / kCount + 1e-12);
  RC_ASSERT(std::abs(glm::length(m.p_WB - m.p_WA) - *m.distance) < 1e-12);
}

TEST(Measurement, OfOneFeatureItsLengthAndRadiusAreTold) {
  EXPECT_NEAR(*measure(edge({0, 0, 0}, {0.3, 0.4, 0})).length, 0.5, 1e-12);
  const Measurement round = measure(circle({1, 2, 3}, {0, 0, 1}, 0.02));
  EXPECT_NEAR(*round.radius, 0.02, 1e-12);
  EXPECT_NEAR(*round.length, glm::two_pi<double>() * 0.02, 1e-6);
  EXPECT_FALSE(measure(corner({1, 2, 3})).distance.has_value());
}

TEST(Measurement, APointIsMeasuredSquareOntoAPlane) {
  const Measurement m = measure(corner({0.1, 0.2, 0.5}), plane({7, 8, 0.2}, {0, 0, 1}));
  EXPECT_NEAR(*m.distance, 0.3, 1e-12);
  EXPECT_NEAR(glm::length(m.p_WB - dvec3(0.1, 0.2, 0.2)), 0.0, 1e-12);
  const Measurement other_way = measure(plane({7, 8, 0.2}, {0, 0, 1}), corner({0.1, 0.2, 0.5}));
  EXPECT_NEAR(glm::length(other_way.p_WA - m.p_WB), 0.0, 1e-12);
}

TEST(Measurement, ParallelPlanesHaveADistanceOthersAnAngle) {
  const Measurement parallel = measure(plane({0, 0, 0}, {0, 0, 1}), plane({5, 5, 0.04}, {0, 0, -1}));
  EXPECT_NEAR(*parallel.distance, 0.04, 1e-12);
  EXPECT_NEAR(*parallel.angle, 0.0, 1e-12);
  EXPECT_FALSE(parallel.between_picks);
  const Measurement slanted = measure(plane({0, 0, 0}, {0, 0, 1}), plane({0.3, 0, 0.4}, {1, 0, 1}));
  EXPECT_NEAR(*slanted.angle, std::numbers::pi / 4, 1e-12);
  EXPECT_TRUE(slanted.between_picks);
  EXPECT_NEAR(*slanted.distance, 0.5, 1e-12);
}

TEST(Measurement, AnEdgeInAPlaneHasNoAngleToIt) {
  EXPECT_NEAR(*measure(edge({0, 0, 1}, {1, 1, 1}), plane({0, 0, 0}, {0, 0, 1})).angle, 0.0, 1e-9);
  EXPECT_NEAR(*measure(edge({0, 0, 1}, {0, 0, 2}), plane({0, 0, 0}, {0, 0, 1})).angle, glm::half_pi<double>(), 1e-9);
}

TEST(Measurement, CentresOfCirclesAndAxesOfBoresAreMeasured) {
  EXPECT_NEAR(*measure(circle({0, 0, 0}, {0, 0, 1}, 0.01), circle({0.3, 0.4, 0}, {0, 1, 0}, 0.02)).between_axes, 0.5,
              1e-12);
  PickedFeature bore;
  bore.surface_W.type = collision::SurfaceType::kCylinder;
  bore.surface_W.axis_M = {0, 0, 1};
  PickedFeature other = bore;
  other.surface_W.p_M = {0.06, 0.08, 5.0};
  EXPECT_NEAR(*measure(bore, other).between_axes, 0.1, 1e-12);
  other.surface_W.axis_M = glm::normalize(dvec3(0, 1, 1));
  EXPECT_FALSE(measure(bore, other).between_axes.has_value());
}

TEST(Measurement, PartsAreAsFarApartAsTheirFaces) {
  const auto box = std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.1, 0.1, 0.1}));
  ColliderCache cache;
  const std::vector<PlacedMesh> here{{box, Pose::identity()}};
  const auto apart = partDistance(here, {{box, Pose::translation({0.35, 0, 0})}}, cache);
  ASSERT_TRUE(apart.has_value());
  EXPECT_NEAR(apart->distance, 0.25, 1e-12);
  EXPECT_EQ(cache.size(), 1u) << "one tree for one mesh";
  const auto nearer =
      partDistance(here, {{box, Pose::translation({0.35, 0, 0})}, {box, Pose::translation({0, 0.15, 0})}}, cache);
  EXPECT_NEAR(nearer->distance, 0.05, 1e-12);
  EXPECT_TRUE(partDistance(here, {{box, Pose::translation({0.05, 0, 0})}}, cache)->colliding);
  EXPECT_FALSE(partDistance(here, {}, cache).has_value());
  EXPECT_FALSE(partDistance(here, here, cache, [] { return true; }).has_value());
}

}  // namespace
}  // namespace hapticell::app
