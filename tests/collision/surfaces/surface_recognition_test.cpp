// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_recognition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "collision/surfaces/surface_clusters.h"
#include "geometry/shapes/shapes.h"
#include "tests/collision/surfaces/generated_parts.h"
#include "tests/support/test_data.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::test {
namespace {

using collision::RecognisedSurface;
using collision::SurfaceType;

/// Types of triangles found by their middles, because recognition welds and drops.
double shareOfTrueType(const GeneratedPart& part, const RecognisedSurface& found) {
  std::map<std::array<long long, 3>, SurfaceType> truth;
  const auto key = [](const dvec3& p) {
    return std::array<long long, 3>{std::llround(1e8 * p.x), std::llround(1e8 * p.y), std::llround(1e8 * p.z)};
  };
  for (std::uint32_t t = 0; t < part.truth.size(); ++t) truth[key(collision::middleOf(part.mesh, t))] = part.truth[t];
  double all = 0.0, right = 0.0;
  for (std::uint32_t t = 0; t < found.mesh.triangles.size(); ++t) {
    const double area = collision::areaOf(found.mesh, t);
    all += area;
    const auto known = truth.find(key(collision::middleOf(found.mesh, t)));
    if (known != truth.end() && known->second == found.regions[found.region_of[t]].shape.type) right += area;
  }
  return right / all;
}

TEST(SurfaceRecognition, FindsTheTrueTypesAndRadiiOfGeneratedParts) {
  for (const GeneratedPart& part : generatedParts()) {
    const RecognisedSurface found = collision::recogniseSurfaces(part.mesh);
    EXPECT_TRUE(found.closed) << part.name;
    const double share = shareOfTrueType(part, found);
    EXPECT_GE(share, 0.99) << part.name;
    double residual = 0.0, sagitta = 0.0;
    for (const auto& region : found.regions) {
      residual = std::max(residual, region.residual);
      sagitta = std::max(sagitta, region.sagitta);
      const bool round = region.shape.type != SurfaceType::kPlane && region.shape.type != SurfaceType::kCone &&
                         region.shape.type != SurfaceType::kFreeForm;
      if (!round) continue;
      double nearest = 1.0;
      for (const double r : part.radii) nearest = std::min(nearest, std::abs(r - region.shape.radius));
      EXPECT_LE(nearest, 1e-6) << part.name << " radius " << region.shape.radius;
    }
    std::printf("%-20s %6zu triangles, %3zu regions, true %.4f, residual %.1e m, sagitta %.1e m\n", part.name.c_str(),
                found.mesh.triangles.size(), found.regions.size(), share, residual, sagitta);
  }
}

TEST(SurfaceRecognition, KnowsRealParts) {
  struct Real {
    const char* path;
    double scale, least;
  };
  for (const Real& real :
       {Real{"cad/stl/odri_hip_aa_module_shell_base.stl", 0.001, 0.95},
        Real{"cad/stl/odri_transmission_pulley_at3_t30_output.stl", 0.001, 0.98},
        Real{"cad/obj/industreal_gear_base.obj", 1.0, 0.99}, Real{"cad/obj/industreal_gear_small.obj", 1.0, 0.98},
        Real{"cad/obj/factory_round_peg_8mm_tight.obj", 1.0, 0.99},
        Real{"cad/obj/factory_round_hole_8mm_subdiv_3x.obj", 1.0, 0.99}}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(path, real.path);
    Diagnostics diagnostics;
    workcell::MeshReadOptions options;
    options.scale = real.scale;
    const auto mesh = workcell::readMesh(path, options, diagnostics);
    ASSERT_TRUE(mesh.has_value());
    const RecognisedSurface found = collision::recogniseSurfaces(*mesh);
    std::printf("%s: %zu triangles, %s, %zu regions, recognised %.4f\n", real.path, found.mesh.triangles.size(),
                found.closed ? "closed" : "open", found.regions.size(), found.recognisedShare());
    EXPECT_GE(found.recognisedShare(), real.least) << real.path;
    std::size_t triangles = 0;
    for (const auto& region : found.regions) triangles += region.triangles.size();
    EXPECT_EQ(triangles, found.mesh.triangles.size());
  }
}

TEST(SurfaceRecognition, FindsTheSameInSinglePrecisionAndTurned) {
  const Pose X{dvec3(0.3, -0.2, 0.1), quaternionFromRotationVector({0.4, 0.9, -0.3})};
  for (GeneratedPart part : generatedParts()) {
    for (dvec3& p : part.mesh.vertices) {
      const dvec3 q = 1000.0 * (X * p);  // millimetres in a binary STL
      p = dvec3(fvec3(q)) / 1000.0;
    }
    const RecognisedSurface found = collision::recogniseSurfaces(part.mesh);
    EXPECT_GE(shareOfTrueType(part, found), 0.99) << part.name;
    EXPECT_TRUE(found.closed) << part.name;
  }
}

TEST(SurfaceRecognition, TellsBordersApart) {
  const RecognisedSurface found = collision::recogniseSurfaces(generatedPart("bracket with fillet").mesh);
  using collision::BorderKind;
  int smooth = 0, convex = 0, concave = 0;
  for (const auto& region : found.regions) {
    if (region.shape.type != SurfaceType::kCylinder) continue;
    EXPECT_DOUBLE_EQ(region.shape.side, -1.0);
    EXPECT_EQ(region.trims.size(), 1u);
    for (const auto& border : region.borders) {
      smooth += border.kind == BorderKind::kSmooth;
      convex += border.kind == BorderKind::kConvex;
      concave += border.kind == BorderKind::kConcave;
    }
  }
  EXPECT_EQ(smooth, 2);  // floor and wall
  EXPECT_EQ(convex, 2);  // both ends
  EXPECT_EQ(concave, 0);
}

TEST(SurfaceRecognition, TakesAnySoup) {
  EXPECT_TRUE(collision::recogniseSurfaces({}).regions.empty());
  geometry::TriangleMesh sliver;
  sliver.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}};
  sliver.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 0}};
  EXPECT_TRUE(collision::recogniseSurfaces(sliver).regions.empty());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  geometry::TriangleMesh soup;
  for (std::uint32_t i = 0; i < 300; ++i) {
    for (int k = 0; k < 3; ++k) soup.vertices.push_back({uniform(random), uniform(random), uniform(random)});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const RecognisedSurface found = collision::recogniseSurfaces(soup);
  EXPECT_FALSE(found.closed);
  EXPECT_EQ(found.components, 300u);
  const RecognisedSurface hexagon = collision::recogniseSurfaces(geometry::makeCylinder(0.01, 0.02, 6));
  for (const auto& region : hexagon.regions) EXPECT_EQ(region.shape.type, SurfaceType::kPlane);
  EXPECT_EQ(hexagon.regions.size(), 8u);
}

}  // namespace
}  // namespace hapticell::test
