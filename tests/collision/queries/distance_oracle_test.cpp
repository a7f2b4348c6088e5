// SPDX-License-Identifier: Apache-2.0
// Poses without number against brute force in double. HAPTICELL_ORACLE_POSES: how many (10000 for the full run),
// shared among the kinds of meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "collision/queries/proximity_query.h"
#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using geometry::TriangleMesh;

int posesAskedFor() {
  const char* asked = std::getenv("HAPTICELL_ORACLE_POSES");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : 400;
}

NearestPair bruteForce(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b) {
  NearestPair best;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    const Corners first{X_WA * a.corner(i, 0), X_WA * a.corner(i, 1), X_WA * a.corner(i, 2)};
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
      improveTriangleDistance(first, b.corners(j), best);
    }
  }
  return best;
}

struct Kind {
  const char* name;
  TriangleMesh mesh;
};

/// Boxes, balls, sheets, soups, slivers beside large faces, and the same 20 m from the mesh's origin.
std::vector<Kind> kinds() {
  std::mt19937 random(77);
  std::vector<Kind> result;
  result.push_back({"box", test::boxMesh({0.3, 0.2, 0.1})});
  result.push_back({"crumb", test::boxMesh({0.02, 0.01, 0.02})});
  result.push_back({"ball", test::sphereMesh(0.15, 10, 14)});
  result.push_back({"sheet", test::sheetMesh(0.5, 10, 0.06)});
  result.push_back({"soup", test::soupMesh(random, 200, 0.3)});
  TriangleMesh mixed = test::boxMesh({2.0, 2.0, 0.02});
  geometry::append(mixed, test::sphereMesh(0.02, 8, 9), Pose::translation({0.1, 0.1, 0.02}));
  geometry::append(mixed, test::boxMesh({0.001, 1.5, 0.04}), Pose::translation({-0.1, 0.0, 0.03}));
  result.push_back({"plate with slivers", mixed});
  for (dvec3& vertex : mixed.vertices) vertex += dvec3(20.0, -20.0, 20.0);
  result.push_back({"plate 20 m away", mixed});
  return result;
}

TEST(DistanceOracle, EveryKindAgainstEveryKind) {
  std::mt19937 random(101);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const std::vector<Kind> all = kinds();
  const int each = posesAskedFor() / static_cast<int>(all.size() * all.size()) + 1;
  int apart = 0, colliding = 0, contained = 0;
  for (const Kind& kind_a : all) {
    for (const Kind& kind_b : all) {
      const auto a = MeshCollider::build(kind_a.mesh), b = MeshCollider::build(kind_b.mesh);
      ProximityQuery query(a, b);
      for (int i = 0; i < each; ++i) {
        // Both middles near each other, at all distances from through to far.
        const double reach = 0.5 * std::pow(10.0, unit(random));
        Pose X_WA = Pose::rotation(test::randomPose(random, 1.0).q);
        X_WA.p = b->center() + reach * dvec3(unit(random), unit(random), unit(random)) - X_WA.rotate(a->center());
        const NearestPair expected = bruteForce(a->mesh(), X_WA, b->mesh());
        const double distance = std::sqrt(expected.squared);
        const DistanceResult result = query.distance(X_WA, {});
        EXPECT_EQ(result.colliding && !result.contained, distance <= kTouchingDistance) << kind_a.name << kind_b.name;
        EXPECT_NEAR(glm::distance(result.p_WA, result.p_WB), result.distance, 1e-9);
        EXPECT_EQ(query.collides(X_WA, {}), result.colliding);
        if (result.contained) {
          ++contained;
          continue;
        }
        EXPECT_NEAR(result.distance, distance, 1e-9) << kind_a.name << " to " << kind_b.name;
        const double margin = distance * (1.0 + 0.1 * unit(random));
        EXPECT_EQ(query.within(X_WA, {}, margin), distance <= std::max(margin, kTouchingDistance));
        ++(result.colliding ? colliding : apart);
      }
    }
  }
  EXPECT_GT(apart, posesAskedFor() / 4);
  EXPECT_GT(colliding, posesAskedFor() / 10);
  std::printf("%d apart, %d intersecting, %d contained\n", apart, colliding, contained);
}

}  // namespace
}  // namespace hapticell::collision
