// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "collision/queries/motion_check.h"
#include "collision/queries/proximity_query.h"
#include "tests/collision/queries/meshes.h"
#include "tests/support/test_data.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::collision {
namespace {

std::shared_ptr<const MeshCollider> read(const std::filesystem::path& file, double scale) {
  workcell::MeshReadOptions options;
  options.scale = scale;
  options.weld = false;
  Diagnostics diagnostics;
  const auto mesh = workcell::readMesh(file, options, diagnostics);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().message());
  return mesh ? MeshCollider::build(*mesh) : nullptr;
}

double bruteForce(const geometry::TriangleMesh& a, const Pose& X_BA, const geometry::TriangleMesh& b) {
  NearestPair best;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    const Corners first{X_BA * a.corner(i, 0), X_BA * a.corner(i, 1), X_BA * a.corner(i, 2)};
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
      improveTriangleDistance(b.corners(j), first, best);
    }
  }
  return std::sqrt(best.squared);
}

TEST(RealParts, PegAndHoleAgreeWithBruteForce) {
  HAPTICELL_SHARED_DATA_OR_SKIP(peg_file, "cad/obj/factory_round_peg_8mm_tight.obj");
  HAPTICELL_SHARED_DATA_OR_SKIP(hole_file, "cad/obj/factory_round_hole_8mm_subdiv_3x.obj");
  const auto peg = read(peg_file, 1.0), hole = read(hole_file, 1.0);
  ASSERT_TRUE(peg && hole);
  EXPECT_TRUE(peg->isClosed());
  ProximityQuery query(peg, hole);
  std::mt19937 random(13);
  for (int i = 0; i < 15; ++i) {
    const Pose X_WP = test::randomPose(random, 0.04);
    const DistanceResult result = query.distance(X_WP, {});
    if (result.contained) continue;
    EXPECT_NEAR(result.distance, bruteForce(peg->mesh(), X_WP, hole->mesh()), 1e-9);
  }
}

TEST(RealParts, TheTightPegGoesIntoItsHoleAndNotBesideIt) {
  HAPTICELL_SHARED_DATA_OR_SKIP(peg_file, "cad/obj/factory_round_peg_8mm_tight.obj");
  HAPTICELL_SHARED_DATA_OR_SKIP(hole_file, "cad/obj/factory_round_hole_8mm_subdiv_3x.obj");
  const auto peg = read(peg_file, 1.0), hole = read(hole_file, 1.0);
  ASSERT_TRUE(peg && hole);
  ProximityQuery query(peg, hole);
  const auto lower = [&](double x) {
    return advance(query, straightMotion(Pose::translation({x, 0, 0.08}), Pose::translation({x, 0, 0.005}), *peg),
                   standingStill({}), {1e-5});
  };
  EXPECT_FALSE(lower(0.0).stopped);
  EXPECT_TRUE(lower(0.001).stopped);
}

}  // namespace
}  // namespace hapticell::collision
