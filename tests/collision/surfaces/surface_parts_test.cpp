// SPDX-License-Identifier: Apache-2.0
// Surfaces as contacts see them: elements, corners, rims and rods, and which of them stand in a ball's way.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "collision/queries/mesh_search.h"
#include "collision/surfaces/region_grower.h"
#include "collision/surfaces/region_properties.h"
#include "collision/surfaces/signature.h"
#include "collision/surfaces/signature_groups.h"
#include "collision/surfaces/signature_repair.h"
#include "collision/surfaces/surface_model.h"
#include "collision/surfaces/surface_model_builder.h"
#include "collision/surfaces/surface_recognition.h"
#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::collision {
namespace {

geometry::TriangleMesh grooveProfile() {
  const std::vector<glm::dvec2> outline{{0, 0},      {0.3, 0},    {0.3, 0.1}, {0.2, 0.1},
                                        {0.2, 0.05}, {0.1, 0.05}, {0.1, 0.1}, {0, 0.1}};
  return geometry::makePrism(outline, 0.1);
}

RC_GTEST_PROP(Signature, IsASetOfSmallNumbers, ()) {
  const auto index = rc::gen::inRange(0, static_cast<int>(Signature::kMostElements));
  const auto first = *rc::gen::container<std::set<int>>(index), second = *rc::gen::container<std::set<int>>(index);
  Signature a, b;
  for (const int i : first) a.add(static_cast<std::size_t>(i));
  for (const int i : second) b.add(static_cast<std::size_t>(i));
  RC_ASSERT(a.count() == static_cast<int>(first.size()));
  for (std::size_t i = 0; i < Signature::kMostElements; ++i) RC_ASSERT(a.has(i) == first.contains(static_cast<int>(i)));
  RC_ASSERT(a.contains(b) == std::includes(first.begin(), first.end(), second.begin(), second.end()));
  RC_ASSERT((a == b) == (first == second));
  RC_ASSERT(!(a < a) && (a < b || b < a || a == b));
  if (a == b) RC_ASSERT(SignatureHash()(a) == SignatureHash()(b));
}

TEST(SurfaceModel, OfABoxHasItsFacesCornersAndEdges) {
  const auto model = SurfaceModel::build(geometry::makeBox(dvec3(0.2, 0.3, 0.4)));
  EXPECT_EQ(model->surface().regions.size(), 6u);
  EXPECT_EQ(model->points().size(), 8u);
  EXPECT_TRUE(model->circles().empty());
  ASSERT_EQ(model->rods(SurfaceModel::RodKind::kEdge).size(), 12u);
  EXPECT_TRUE(model->rods(SurfaceModel::RodKind::kRound).empty());
  EXPECT_NE(model->rodLines(SurfaceModel::RodKind::kEdge), nullptr);
  EXPECT_EQ(model->rodLines(SurfaceModel::RodKind::kRim), nullptr);
  EXPECT_EQ(model->thickestRod(), 0.0);
  for (const BodyPoint& point : model->points()) {
    EXPECT_EQ(glm::abs(point.p_M), dvec3(0.1, 0.15, 0.2));
    EXPECT_EQ(point.radius, 0.0);
  }
  for (const BodyRod& rod : model->rods(SurfaceModel::RodKind::kEdge)) {
    EXPECT_NEAR(glm::dot(rod.n1_M, rod.n2_M), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(rod.b_M - rod.a_M, rod.n1_M), 0.0, 1e-12) << "along both faces";
    EXPECT_GT(glm::dot(0.5 * (rod.a_M + rod.b_M), rod.n1_M + rod.n2_M), 0.0) << "outward";
  }
  for (std::uint32_t t = 0; t < model->surface().mesh.triangles.size(); ++t) {
    const SurfaceElement& element = model->elements()[model->elementOf(t)];
    EXPECT_EQ(element.shape.type, SurfaceType::kPlane);
    EXPECT_FALSE(element.facet || element.edge);
  }
}

TEST(SurfaceModel, OfACylinderHasTwoRimsAndItsAxis) {
  const auto model = SurfaceModel::build(geometry::makeCylinder(0.05, 0.2, 40));
  EXPECT_EQ(model->surface().regions.size(), 3u);
  ASSERT_EQ(model->circles().size(), 2u);
  for (const BodyCircle& circle : model->circles()) {
    EXPECT_TRUE(circle.isWhole());
    EXPECT_NEAR(circle.ring, 0.05, 1e-9);
    EXPECT_NEAR(std::abs(circle.center_M.z), 0.1, 1e-9);
    for (const double angle : {0.0, 1.0, 4.0})
      EXPECT_NEAR(glm::distance(circle.at(angle), circle.center_M), 0.05, 1e-9);
  }
  ASSERT_GE(model->rods(SurfaceModel::RodKind::kRound).size(), 1u);
  EXPECT_NEAR(model->thickestRod(), 0.05, 1e-9);
}

TEST(SurfaceModel, ASphereIsOneBall) {
  const auto model = SurfaceModel::build(geometry::makeSphere(0.04, 32));
  ASSERT_EQ(model->points().size(), 1u);
  EXPECT_LT(glm::length(model->points()[0].p_M), 1e-9);
  EXPECT_NEAR(model->points()[0].radius, 0.04, 1e-9);
}

TEST(SurfaceModel, ElementsSayTheSignedDistance) {
  const auto model = SurfaceModel::build(geometry::makeBox(dvec3(0.2)));
  const SurfaceElement* top = nullptr;
  for (const SurfaceElement& element : model->elements()) {
    if (!element.edge && element.shape.axis_M.z > 0.9) top = &element;
  }
  ASSERT_NE(top, nullptr);
  EXPECT_NEAR(elementValue(*top, {0, 0, 0.13}, 0.0), 0.03, 1e-12);
  EXPECT_NEAR(elementValue(*top, {0, 0, 0.13}, 0.02), 0.01, 1e-12) << "less the ball's radius";
  EXPECT_NEAR(elementValue(*top, {0.05, 0, 0.04}, 0.0), -0.06, 1e-12);
}

TEST(SurfaceModelBuilder, PlanesAndUnknownSurfacesAreNotRound) {
  EXPECT_FALSE(isRound(SurfaceType::kPlane) || isRound(SurfaceType::kFreeForm));
  for (const auto type : {SurfaceType::kCylinder, SurfaceType::kCone, SurfaceType::kSphere, SurfaceType::kTorus}) {
    EXPECT_TRUE(isRound(type));
  }
}

TEST(RegionProperties, AreMeasuredFromTheFacets) {
  const geometry::TriangleMesh pipe = geometry::makePipe(0.05, 0.03, 0.1, 32);
  const RecognisedSurface found = recogniseSurfaces(pipe);
  RecognisedSurface again = found;
  for (SurfaceRegion& region : again.regions) {
    region.residual = region.sagitta = region.area = 0.0;
    region.mean_nhat_M = dvec3(0.0);
    region.trims.clear();
    region.borders.clear();
  }
  measureRegions(again);
  double area = 0.0;
  for (std::size_t i = 0; i < found.regions.size(); ++i) {
    const SurfaceRegion &a = found.regions[i], &b = again.regions[i];
    EXPECT_NEAR(a.area, b.area, 1e-15);
    EXPECT_EQ(a.borders.size(), b.borders.size());
    EXPECT_EQ(a.trims.size(), b.trims.size());
    EXPECT_LT(b.residual, 1e-9) << "the vertices lie on the surface";
    area += b.area;
    if (b.shape.type != SurfaceType::kCylinder) continue;
    const double chord = b.shape.radius * (1.0 - std::cos(std::numbers::pi / 32));
    EXPECT_NEAR(b.sagitta, chord, 1e-9) << "the middle of a chord is off by r (1 - cos(pi / n))";
    EXPECT_LT(glm::length(b.mean_nhat_M), 1e-9) << "all round they cancel";
    ASSERT_EQ(b.borders.size(), 2u);
    for (const RegionBorder& border : b.borders) {
      EXPECT_EQ(border.kind, BorderKind::kConvex);
      EXPECT_EQ(border.edges, 32u);
    }
  }
  double facets = 0.0;
  for (std::uint32_t t = 0; t < found.mesh.triangles.size(); ++t) facets += areaOf(found.mesh, t);
  EXPECT_NEAR(area, facets, 1e-12);
}

TEST(RegionGrower, GrowsACylinderFromAnyOfItsFacets) {
  const RecognisedSurface surface = connectedSurface(geometry::makeCylinder(0.05, 0.2, 24));
  const PlanarClusters clusters = planarClusters(surface, 1e-6);
  for (std::uint32_t seed = 0; seed < surface.mesh.triangles.size(); seed += 7) {
    RegionGrower grower(surface, clusters);
    const bool is_side = std::abs(surface.normals[seed].z) < 0.5;
    EXPECT_EQ(grower.isCurvedAt(seed), is_side);
    const auto region = grower.regionFrom(seed, 1e-6);
    if (!is_side) continue;
    ASSERT_TRUE(region);
    EXPECT_EQ(region->shape.type, SurfaceType::kCylinder);
    EXPECT_NEAR(region->shape.radius, 0.05, 1e-7);
    EXPECT_NEAR(std::abs(region->shape.axis_M.z), 1.0, 1e-7);
    EXPECT_EQ(region->shape.side, 1.0);
    EXPECT_EQ(region->triangles.size(), 48u);
    for (const std::uint32_t t : region->triangles) EXPECT_TRUE(grower.belongs(t, region->shape, 1e-6));
    grower.take(region->triangles);
    EXPECT_FALSE(grower.isFree(seed));
    EXPECT_FALSE(grower.isCurvedAt(seed)) << "its neighbours are taken";
  }
}

TEST(RegionGrower, FindsNothingCurvedInABox) {
  const RecognisedSurface surface = connectedSurface(geometry::makeBox(dvec3(0.2)));
  const PlanarClusters clusters = planarClusters(surface, 1e-6);
  RegionGrower grower(surface, clusters);
  for (std::uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    EXPECT_FALSE(grower.isCurvedAt(t));
    EXPECT_FALSE(grower.regionFrom(t, 1e-6));
  }
}

/// Free by the groups: each has an element that is in front.
bool isFreeByGroups(const SignatureCell& cell, const SurfaceModel& model, const dvec3& p, double radius) {
  return std::all_of(cell.groups.begin(), cell.groups.end(), [&](const auto& group) {
    return std::any_of(group.begin(), group.end(),
                       [&](std::uint32_t name) { return elementValue(cell.element(model, name), p, radius) > 0.0; });
  });
}

TEST(SignatureGroups, ABallIsFreeWhereTheSurfaceIsFartherThanItsRadius) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const geometry::TriangleMesh& mesh : {geometry::makeBox(dvec3(0.2)), grooveProfile()}) {
    const auto model = SurfaceModel::build(mesh);
    for (const double radius : {0.0, 0.01}) {
      SignatureCache cache(*model);
      int free = 0, blocked = 0;
      for (int i = 0; i < 600; ++i) {
        const dvec3 p = model->bounds().center() + uniform(random) * dvec3(0.6, 0, 0) * model->bounds().size() +
                        uniform(random) * dvec3(0, 0.6, 0) * model->bounds().size() +
                        uniform(random) * dvec3(0, 0, 0.6) * model->bounds().size();
        const NearestPoint nearest = nearestPoint(model->collider(), p);
        const double distance = model->collider().contains(p) ? -nearest.distance : nearest.distance;
        if (std::abs(distance - radius) < 1e-4 || distance < -0.02 || distance > radius + 0.02) continue;
        const SignatureCell& cell = cache.cell(p, radius, 0.05);
        ASSERT_FALSE(cell.overfull || cell.free_form || cell.facets);
        EXPECT_TRUE(cache.knows(p, radius, 0.05));
        const bool is_free = distance > radius;
        EXPECT_EQ(isFreeByGroups(cell, *model, p, radius), is_free) << p.x << " " << p.y << " " << p.z;
        ++(is_free ? free : blocked);
      }
      EXPECT_GT(free, 20);
      EXPECT_GT(blocked, 20);
      EXPECT_GT(cache.takeWork(), 0u);
      EXPECT_EQ(cache.takeWork(), 0u) << "counted since the last call";
      EXPECT_EQ(&cache.model(), model.get());
    }
  }
}

TEST(SignatureGroups, FarFromEverythingThereIsNoGroupAndCellsAreKept) {
  const auto model = SurfaceModel::build(geometry::makeBox(dvec3(0.2)));
  SignatureCache cache(*model);
  EXPECT_FALSE(cache.knows({5, 5, 5}, 0.0, 0.05));
  EXPECT_TRUE(cache.cell({5, 5, 5}, 0.0, 0.05).groups.empty());
  EXPECT_TRUE(cache.cell({5.0001, 5, 5}, 0.0, 0.05).groups.empty());
  EXPECT_EQ(cache.cellCount(), 1u) << "the same small cube";
  (void)cache.cell({5, 5, 5}, 0.01, 0.05);
  (void)cache.cell({5, 5, 5}, 0.0, 0.2);
  EXPECT_EQ(cache.cellCount(), 3u) << "another ball, another reach";
}

TEST(SignatureRepair, WithoutSamplesThereIsNothingToRepair) {
  const auto model = SurfaceModel::build(grooveProfile());
  SignatureCell cell;
  EXPECT_EQ(repairGroups({.model = *model, .radius = 0.0, .samples = {}, .signatures = {}, .groups = {}}, cell), 0u);
  EXPECT_TRUE(cell.groups.empty() && cell.own.empty());
}

TEST(SignatureRepair, AFalseWallIsOpened) {
  // Beside the groove the planes of its walls go on through the air above and beside the part: a group of one of them
  // alone would block free places. All samples of the wall stay blocked.
  const auto model = SurfaceModel::build(grooveProfile());
  std::uint32_t wall = kNoIndex;
  std::vector<SignedSample> samples;
  for (std::uint32_t t = 0; t < model->surface().mesh.triangles.size(); ++t) {
    const SurfaceElement& element = model->elements()[model->elementOf(t)];
    if (element.shape.axis_M.x > 0.9 && element.shape.p_M.x < 0.15) wall = model->elementOf(t);  // x = 0.1, faces +x
  }
  ASSERT_NE(wall, kNoIndex);
  Signature behind;
  behind.add(wall);
  const dvec3 on_wall(0.1, 0.075, 0.05), on_left_top(0.05, 0.1, 0.05);
  samples.push_back({on_wall, {1, 0, 0}, 0});
  samples.push_back({on_left_top, {0, 1, 0}, 0});
  const std::vector<Signature> signatures{behind};
  SignatureCell cell;
  cell.groups = {{wall}};
  const dvec3 above = on_left_top + dvec3(0, 1e-4, 0);
  EXPECT_FALSE(isFreeByGroups(cell, *model, above, 0.0)) << "air, but behind the wall's plane";
  const std::size_t work = repairGroups(
      {.model = *model, .radius = 0.0, .samples = samples, .signatures = signatures, .groups = signatures}, cell);
  EXPECT_GT(work, 0u);
  EXPECT_TRUE(isFreeByGroups(cell, *model, above, 0.0));
  EXPECT_FALSE(isFreeByGroups(cell, *model, on_wall - dvec3(1e-3, 0, 0), 0.0)) << "inside the material";
}

}  // namespace
}  // namespace hapticell::collision
