// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/tools/feature_picker.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "app/viewport/meshes/edge_chains.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::app {
namespace {

using collision::SurfaceType;

constexpr workcell::EntityId kPart = 7;

/// A part in front of a camera of 800 x 600 pixels.
struct Stage {
  explicit Stage(geometry::TriangleMesh mesh, const Pose& X_WM = Pose::identity()) {
    RenderItem item;
    item.mesh = std::make_shared<geometry::TriangleMesh>(std::move(mesh));
    item.bounds_M = item.mesh->bounds();
    item.X_WM = X_WM;
    item.entity = kPart;
    items.push_back(item);
    camera.target_W = X_WM.p;
    camera.distance = 0.6;
  }
  std::optional<PickedFeature> at(const dvec3& p_W, const glm::dvec2& beside = {0, 0}, FeatureFilter filter = {}) {
    return picker.pick({&items, kPart, -1, camera, size, *camera.project(p_W, size) + beside, filter});
  }
  std::vector<RenderItem> items;
  Camera camera;
  ViewSize size{800, 600};
  FeaturePicker picker;
};

TEST(FeaturePicker, TheMiddleOfABoxIsAPlaneItsRimAnEdgeItsTipACorner) {
  Stage stage(geometry::makeBox({0.1, 0.1, 0.1}));
  const auto top = stage.at({0.01, -0.013, 0.05});
  ASSERT_TRUE(top);
  EXPECT_EQ(top->kind, FeatureKind::kFace);
  EXPECT_EQ(top->surface_W.type, SurfaceType::kPlane);
  EXPECT_NEAR(top->nhat_W.z, 1.0, 1e-12);
  EXPECT_NEAR(glm::distance(top->p_WQ, dvec3(0.01, -0.013, 0.05)), 0.0, 1e-6);
  EXPECT_EQ(top->outline_W.size(), 4u);
  EXPECT_EQ(featureText(*top), "Plane");

  const auto edge = stage.at({0.05, -0.01, 0.05}, {-2, -2});
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->kind, FeatureKind::kEdge);
  EXPECT_EQ(edge->edge, EdgeShape::kLine);
  EXPECT_NEAR(std::abs(edge->axis_W.y), 1.0, 1e-9);
  EXPECT_NEAR(edge->p_WQ.x, 0.05, 1e-9) << "snapped onto it";
  EXPECT_NEAR(edge->p_WQ.z, 0.05, 1e-9);
  EXPECT_EQ(featureText(*edge), "Edge, 100.0 mm");

  const auto corner = stage.at({0.05, -0.05, 0.05}, {-2, -4});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->kind, FeatureKind::kVertex);
  EXPECT_NEAR(glm::distance(corner->p_WQ, dvec3(0.05, -0.05, 0.05)), 0.0, 1e-12);
}

TEST(FeaturePicker, RightThroughAnEdgeOfTheMeshTheNearFaceIsMetAndNotTheOneBehind) {
  // One of these lies on the diagonal between the two triangles of the top.
  for (const double y : {0.01, -0.01, 0.0}) {
    Stage stage(geometry::makeBox({0.1, 0.1, 0.1}));
    const auto top = stage.at({0.01 * (y != 0.0), y, 0.05});
    ASSERT_TRUE(top);
    EXPECT_NEAR(top->nhat_W.z, 1.0, 1e-12) << y;
    EXPECT_NEAR(top->p_WHit.z, 0.05, 1e-9) << y;
  }
}

TEST(FeaturePicker, AFilterLeavesOutWhatIsNotWanted) {
  Stage stage(geometry::makeBox({0.1, 0.1, 0.1}));
  const dvec3 tip(0.05, -0.05, 0.05);
  EXPECT_EQ(stage.at(tip, {-2, -4}, {true, true, false})->kind, FeatureKind::kEdge);
  EXPECT_EQ(stage.at(tip, {-2, -4}, {true, false, false})->kind, FeatureKind::kFace);
  EXPECT_EQ(stage.at({0, 0, 0.05}, {0, 0}, {false, true, false})->kind, FeatureKind::kEdge)
      << "without faces the nearest edge is meant, however far";
  EXPECT_FALSE(stage.at({0, 0, 0.05}, {0, 0}, {false, false, true})) << "no corner there";
  EXPECT_FALSE(stage.at({0, 0, 0.05}, {390, 0})) << "beside the part";
}

TEST(FeaturePicker, ACylinderHasItsAxisAndItsRimIsACircle) {
  const Pose X_WM{{0.3, -0.2, 0.4}, glm::normalize(dquat(0.9, 0.2, -0.3, 0.1))};
  Stage stage(geometry::makeCylinder(0.04, 0.12, 40), X_WM);
  const dvec3 axis = X_WM.rotate({0, 0, 1});
  const auto side = stage.at(stage.camera.target_W);
  ASSERT_TRUE(side);
  ASSERT_EQ(side->kind, FeatureKind::kFace);
  ASSERT_EQ(side->surface_W.type, SurfaceType::kCylinder);
  EXPECT_NEAR(side->surface_W.radius, 0.04, 1e-6);
  const Pose frame = featureFrame_W(*side);
  EXPECT_NEAR(std::abs(glm::dot(frame.rotate({0, 0, 1}), axis)), 1.0, 1e-9);
  EXPECT_NEAR(glm::length(glm::cross(frame.p - X_WM.p, axis)), 0.0, 1e-7) << "the origin lies on the axis";

  // A point of the upper rim that faces the eye.
  const dvec3 to_eye = X_WM.inverse().rotate(-stage.camera.forward_W());
  const dvec3 out = glm::normalize(dvec3(to_eye.x, to_eye.y, 0.0));
  const double up = to_eye.z >= 0.0 ? 0.06 : -0.06;
  const auto rim = stage.at(X_WM * dvec3(0.0395 * out.x, 0.0395 * out.y, up));
  ASSERT_TRUE(rim);
  EXPECT_EQ(rim->kind, FeatureKind::kEdge);
  ASSERT_EQ(rim->edge, EdgeShape::kCircle);
  EXPECT_NEAR(rim->radius, 0.04, 1e-6);
  EXPECT_NEAR(glm::distance(featureFrame_W(*rim).p, X_WM * dvec3(0, 0, up)), 0.0, 1e-7);
}

TEST(FeaturePicker, TheHitIsOnTheTriangleAndTheFrameIsRightHandedForAnyPlacement) {
  rc::check([] {
    const auto number = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1001)) / 1000.0; };
    const dquat q(number() + 1.5, number(), number(), number());
    const Pose X_WM{{number(), number(), number()}, glm::normalize(q)};
    Stage stage(geometry::makeBox({0.1, 0.12, 0.15}), X_WM);
    stage.camera.azimuth = 3.0 * number();
    stage.camera.elevation = 1.5 * number();
    const auto hit = stage.at(X_WM.p, {2.0 * number(), 2.0 * number()});
    RC_ASSERT(hit.has_value());
    const auto& mesh = *hit->mesh;
    const dvec3 a = mesh.corner(hit->triangle, 0), b = mesh.corner(hit->triangle, 1), c = mesh.corner(hit->triangle, 2);
    const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    RC_ASSERT(std::abs(glm::dot(X_WM.inverse() * hit->p_WHit - a, n)) < 1e-9);
    RC_ASSERT(featureFrame_W(*hit).isValid());
    RC_ASSERT(glm::dot(hit->nhat_W, stage.camera.forward_W()) < 0.3);
  });
}

TEST(EdgeChains, ASlotIsTwoLinesAndTwoArcs) {
  std::vector<dvec3> points;
  const int steps = 12;
  for (int half = 0; half < 2; ++half)
    for (int i = 0; i <= steps; ++i) {
      const double angle = std::numbers::pi * (half + static_cast<double>(i) / steps) - std::numbers::pi / 2;
      points.emplace_back((half == 0 ? 0.05 : -0.05) + 0.01 * std::cos(angle), 0.01 * std::sin(angle), 0.0);
    }
  std::vector<EdgeEnds> edges;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    edges.push_back({i, static_cast<std::uint32_t>((i + 1) % points.size())});
  const auto chains = edgeChains(edges, points);
  int lines = 0, arcs = 0;
  std::size_t covered = 0;
  for (const EdgeChain& chain : chains) {
    lines += chain.is_line;
    arcs += chain.is_circle;
    if (chain.is_circle) {
      EXPECT_NEAR(chain.radius, 0.01, 1e-9);
    }
    covered += chain.vertices.size() - 1;
  }
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(arcs, 2);
  EXPECT_EQ(covered, edges.size()) << "each edge is in one chain";
}

TEST(EdgeChains, AnEllipseIsNeither) {
  std::vector<dvec3> points;
  std::vector<EdgeEnds> edges;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 64.0;
    points.emplace_back(0.06 * std::cos(angle), 0.03 * std::sin(angle), 0.0);
    edges.push_back({i, (i + 1) % 64});
  }
  for (const EdgeChain& chain : edgeChains(edges, points)) {
    EXPECT_FALSE(chain.is_circle && chain.vertices.size() > 12);
    EXPECT_FALSE(chain.is_line);
  }
}

}  // namespace
}  // namespace hapticell::app
