// SPDX-License-Identifier: Apache-2.0
#include "collision/surface_recognition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>

#include "collision/surface_clusters.h"
#include "geometry/mass_properties.h"
#include "tests/collision/generated_parts.h"
#include "tests/support/test_data.h"
#include "workcell/mesh_reader.h"

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

TEST(SurfaceRecognition, RealParts) {
  struct Real {
    const char* path;
    double scale, least;
  };
  for (const Real& real :
       {Real{"cad/stl/odri_hip_aa_module_shell_base.stl", 0.001, 0.95},
        Real{"cad/stl/odri_transmission_pulley_at3_t30_output.stl", 0.001, 0.95},
        Real{"cad/obj/industreal_gear_base.obj", 1.0, 0.99}, Real{"cad/obj/industreal_gear_small.obj", 1.0, 0.0},
        Real{"cad/obj/industreal_gear_medium.obj", 1.0, 0.0},
        Real{"cad/obj/factory_round_peg_8mm_tight.obj", 1.0, 0.99},
        Real{"cad/obj/factory_round_hole_8mm_subdiv_3x.obj", 1.0, 0.99},
        Real{"robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_6.stl", 1.0, 0.0},
        Real{"robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_5.stl", 1.0, 0.0},
        Real{"robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/visual/link_5.stl", 1.0, 0.0}}) {
    const auto path = sharedData(real.path);
    if (!path) continue;
    Diagnostics diagnostics;
    workcell::MeshReadOptions options;
    options.scale = real.scale;
    const auto mesh = workcell::readMesh(*path, options, diagnostics);
    ASSERT_TRUE(mesh.has_value());
    const std::clock_t start = std::clock();
    const RecognisedSurface found = collision::recogniseSurfaces(*mesh);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::map<SurfaceType, int> count;
    std::map<SurfaceType, double> area;
    for (const auto& region : found.regions) ++count[region.shape.type], area[region.shape.type] += region.area;
    std::printf("%s: %zu triangles, %s, recognised %.4f, %.2f s (%.2f s a 100k):", real.path,
                found.mesh.triangles.size(), found.closed ? "closed" : "open", found.recognisedShare(), seconds,
                1e5 * seconds / static_cast<double>(found.mesh.triangles.size()));
    double all = 0;
    for (const auto& [type, a] : area) all += a;
    for (const auto& [type, n] : count)
      std::printf(" %d:%d(%.1f%%)", static_cast<int>(type), n, 100 * area[type] / all);
    std::printf("\n");
    EXPECT_GE(found.recognisedShare(), real.least) << real.path;
  }
}

}  // namespace
}  // namespace hapticell::test
