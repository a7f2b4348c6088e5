// SPDX-License-Identifier: Apache-2.0
// Zone contacts of real parts: read from the shared test data, skipped where it is not there.
#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

#include "tests/collision/contacts/zone_scenes.h"
#include "tests/support/test_data.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::test {
namespace {

geometry::TriangleMesh read(const std::filesystem::path& path, double scale = 1.0) {
  Diagnostics diagnostics;
  workcell::MeshReadOptions options;
  options.scale = scale;
  auto mesh = workcell::readMesh(path, options, diagnostics);
  EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().message());
  return mesh ? *mesh : geometry::TriangleMesh{};
}

TEST(ZoneContactsOfRealParts, PegInHole) {
  HAPTICELL_SHARED_DATA_OR_SKIP(peg, "cad/obj/factory_round_peg_8mm_tight.obj");
  HAPTICELL_SHARED_DATA_OR_SKIP(hole, "cad/obj/factory_round_hole_8mm_subdiv_3x.obj");
  ZoneBench bench({"peg in hole",
                   read(peg),
                   read(hole),
                   {at(0, 0, 0.0), at(0, 0, 0.004), at(0.00003, 0.00002, 0.006), at(0, 0, 0.0088), at(0, 0, 0.0095),
                    at(0, 0, 0.012), at(0.001, 0, 0.0095), at(0.006, 0.001, 0.0091, dvec3(0.2, 0.1, 0))},
                   0.02});
  const ZoneReport report = bench.compare(1000, 0.1);
  std::puts(line(report).c_str());
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.holes, 0);
}

TEST(ZoneContactsOfRealParts, PiecesHoldEveryTriangle) {
  for (const char* name : {"cad/obj/industreal_gear_base.obj", "cad/stl/odri_transmission_pulley_at3_t30_output.stl",
                           "cad/stl/odri_hip_aa_module_shell_base.stl",
                           "robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_2.stl",
                           "robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_5.stl",
                           "robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_6.stl"}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(path, name);
    const auto mesh = read(path);
    const std::clock_t start = std::clock();
    const auto pieces = collision::ConvexPieces::build(mesh);
    std::size_t triangles = 0, vertices = 0;
    for (const auto& piece : pieces->pieces()) {
      triangles += piece.triangles.size();
      vertices += piece.hull.vertices.size();
    }
    std::printf("%s: %zu triangles, size %.3f m, %zu pieces (%zu triangles, %zu vertices), %.2f s\n", name,
                mesh.triangles.size(), glm::length(mesh.bounds().size()), pieces->pieces().size(), triangles, vertices,
                static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    std::fflush(stdout);
    EXPECT_EQ(triangles, mesh.triangles.size()) << name;
  }
}

TEST(ZoneContactsOfRealParts, RobotLinkAtHousing) {
  HAPTICELL_SHARED_DATA_OR_SKIP(
      link, "robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_6.stl");
  HAPTICELL_SHARED_DATA_OR_SKIP(
      big_link, "robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/link_5.stl");
  HAPTICELL_SHARED_DATA_OR_SKIP(shell, "cad/stl/odri_hip_aa_module_shell_base.stl");
  const auto housing = read(shell, 0.001);
  for (const auto& path : {link, big_link}) {
    ZoneScene scene{"link at housing", read(path), housing, {}, 0.06};
    // From far on six sides along a line to the housing's middle, stopped a little before touch.
    const auto a = collision::MeshCollider::build(scene.moving);
    const auto b = collision::MeshCollider::build(scene.environment);
    const dvec3 start_M = a->bounds().center();
    for (int k = 0; k < 6; ++k) {
      dvec3 from(0.1, 0.2, 0.15);
      from[k % 3] = k < 3 ? 1.0 : -1.0;
      double clearance = 0.0;
      Pose X_WM;
      const dvec3 way = glm::normalize(from);
      for (double s = 1.0; s > 0.0; s -= clearance) {
        X_WM = Pose{b->bounds().center() + s * way - start_M, dquat(1, 0, 0, 0)};
        clearance = collision::distance(a, X_WM, b, Pose::identity()).distance;
        if (clearance < 0.003) break;
      }
      scene.places.push_back(X_WM);
    }
    ZoneBench bench(scene);
    const ZoneReport report = bench.compare(200, 0.1);
    std::puts(line(report).c_str());
    EXPECT_EQ(report.holes, 0);
  }
}

}  // namespace
}  // namespace hapticell::test
