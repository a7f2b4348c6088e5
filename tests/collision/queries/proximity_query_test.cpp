// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/proximity_query.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

using geometry::TriangleMesh;
using test::boxMesh;
using test::sphereMesh;

using Collider = std::shared_ptr<const MeshCollider>;

/// The second method: every triangle against every triangle, in the world.
double bruteForce(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB) {
  NearestPair best;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    const Corners first{X_WA * a.corner(i, 0), X_WA * a.corner(i, 1), X_WA * a.corner(i, 2)};
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
      improveTriangleDistance(first, {X_WB * b.corner(j, 0), X_WB * b.corner(j, 1), X_WB * b.corner(j, 2)}, best);
    }
  }
  return std::sqrt(best.squared);
}

double distanceToTriangle(const TriangleMesh& mesh, const Pose& X_WM, std::uint32_t t, const dvec3& p_W) {
  const Corners corners{X_WM * mesh.corner(t, 0), X_WM * mesh.corner(t, 1), X_WM * mesh.corner(t, 2)};
  return glm::distance(closestPointOnTriangle(corners, p_W), p_W);
}

std::vector<Collider> meshKinds() {
  std::mt19937 random(5);
  TriangleMesh degenerate = boxMesh({0.2, 0.2, 0.2});
  degenerate.vertices.push_back({0.4, 0.0, 0.0});
  degenerate.triangles.push_back({0, 0, 8});
  degenerate.triangles.push_back({8, 8, 8});
  std::vector<Collider> result;
  for (const TriangleMesh& mesh : {boxMesh({0.3, 0.2, 0.1}), sphereMesh(0.15), test::sheetMesh(0.4, 8, 0.05),
                                   test::soupMesh(random, 120, 0.15), degenerate, boxMesh({0.4, 0.4, 0.0})}) {
    result.push_back(MeshCollider::build(mesh));
  }
  return result;
}

TEST(ProximityQuery, AgreesWithBruteForce) {
  std::mt19937 random(1);
  int apart = 0, colliding = 0;
  const std::vector<Collider> meshes = meshKinds();
  for (const Collider& a : meshes) {
    for (const Collider& b : meshes) {
      ProximityQuery query(a, b);
      for (int i = 0; i < 40; ++i) {
        const Pose X_WA = test::randomPose(random, 0.3), X_WB = test::randomPose(random, 0.15);
        const double expected = bruteForce(a->mesh(), X_WA, b->mesh(), X_WB);
        const DistanceResult result = query.distance(X_WA, X_WB);
        if (result.contained) {
          EXPECT_GT(expected, 0.0);
          continue;
        }
        EXPECT_NEAR(result.distance, expected, 1e-9);
        EXPECT_EQ(result.colliding, expected <= kTouchingDistance);
        EXPECT_NEAR(glm::distance(result.p_WA, result.p_WB), result.distance, 1e-9);
        EXPECT_NEAR(glm::length(result.nhat_BA_W), 1.0, 1e-12);
        EXPECT_LT(glm::distance(result.p_WA, result.p_WB + result.distance * result.nhat_BA_W), 1e-9);
        EXPECT_LT(distanceToTriangle(a->mesh(), X_WA, result.triangle_A, result.p_WA), 1e-9);
        EXPECT_LT(distanceToTriangle(b->mesh(), X_WB, result.triangle_B, result.p_WB), 1e-9);
        ++(result.colliding ? colliding : apart);
      }
    }
  }
  EXPECT_GT(apart, 200);
  EXPECT_GT(colliding, 200);
}

TEST(ProximityQuery, LimitsAndMarginsAgreeWithTheDistance) {
  std::mt19937 random(2);
  const Collider a = MeshCollider::build(sphereMesh(0.1)), b = MeshCollider::build(test::sheetMesh(0.5, 20, 0.05));
  ProximityQuery cold(a, b), warm(a, b);
  for (int i = 0; i < 500; ++i) {
    const Pose X_WA = test::randomPose(random, 0.4);
    const DistanceResult exact = cold.distance(X_WA, {});
    const double limit = 0.05;
    const DistanceResult limited = warm.distance(X_WA, {}, limit);
    EXPECT_EQ(limited.beyond_limit, exact.distance >= limit);
    EXPECT_NEAR(limited.distance, std::min(exact.distance, limit), 1e-9);
    EXPECT_EQ(warm.within(X_WA, {}, limit), exact.distance <= limit);
    EXPECT_EQ(warm.collides(X_WA, {}), exact.colliding);
  }
}

TEST(ProximityQuery, AToleranceTellsFarDistancesAtMostThatMuchTooLarge) {
  std::mt19937 random(23);
  const Collider a = MeshCollider::build(sphereMesh(0.1)), b = MeshCollider::build(test::soupMesh(random, 200, 0.4));
  ProximityQuery exact(a, b), loose(a, b);
  int inexact = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose X_WA = test::randomPose(random, 0.6);
    const double expected = exact.distance(X_WA, {}).distance;
    const DistanceResult told = loose.distance(X_WA, {}, DistanceDemand{10.0, 0.05, 0.03});
    EXPECT_GE(told.distance, expected - 1e-12);
    EXPECT_LE(told.distance, expected <= 0.05 ? expected + 1e-12 : 1.03 * expected + 1e-9);
    EXPECT_NEAR(glm::distance(told.p_WA, told.p_WB), told.distance, 1e-9);
    EXPECT_FALSE(loose.distance(X_WA, {}, DistanceDemand{1.001 * expected + 1e-9, 0.05, 0.03}).beyond_limit);
    inexact += told.distance > expected + 1e-9;
  }
  EXPECT_GT(inexact, 0) << "and it is made use of";
}

TEST(ProximityQuery, TouchingBoxesAreAtZero) {
  const Collider box = MeshCollider::build(boxMesh({1, 1, 1}));
  for (const dvec3& offset : {dvec3(1, 0, 0), dvec3(1, 1, 0), dvec3(1, 1, 1), dvec3(0, 0.25, -1)}) {
    const DistanceResult result = distance(box, Pose::translation(offset), box, {});
    EXPECT_TRUE(result.colliding) << offset.x << offset.y << offset.z;
    EXPECT_EQ(result.distance, 0.0);
    EXPECT_EQ(result.p_WA, result.p_WB);
  }
  EXPECT_NEAR(distance(box, Pose::translation({1 + 1e-6, 0, 0}), box, {}).distance, 1e-6, 1e-12);
}

TEST(ProximityQuery, CommonPointLiesOnBothSurfaces) {
  std::mt19937 random(3);
  const Collider a = MeshCollider::build(sphereMesh(0.2)), b = MeshCollider::build(boxMesh({0.3, 0.3, 0.3}));
  ProximityQuery query(a, b);
  for (int i = 0; i < 200; ++i) {
    const Pose X_WA = test::randomPose(random, 0.25);
    const DistanceResult result = query.distance(X_WA, {});
    if (!result.colliding || result.contained) continue;
    EXPECT_EQ(result.p_WA, result.p_WB);
    EXPECT_LT(distanceToTriangle(a->mesh(), X_WA, result.triangle_A, result.p_WA), 1e-12);
    EXPECT_LT(distanceToTriangle(b->mesh(), {}, result.triangle_B, result.p_WA), 1e-12);
  }
}

TEST(ProximityQuery, ASolidInsideAnotherCollides) {
  const Collider small = MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), large = MeshCollider::build(boxMesh({1, 1, 1}));
  ProximityQuery query(small, large), swapped(large, small);
  // The surfaces never cross on the way in and out: the answer must not depend on the path.
  for (const double x : {3.0, 0.0, 0.1, 0.2, 3.0, 0.3, 0.0}) {
    const Pose X_WS = Pose::translation({x, 0, 0});
    const DistanceResult result = query.distance(X_WS, {});
    EXPECT_EQ(result.contained, x < 1.0);
    EXPECT_EQ(result.colliding, x < 1.0);
    EXPECT_EQ(result.distance == 0.0, x < 1.0);
    EXPECT_EQ(query.collides(X_WS, {}), x < 1.0);
    EXPECT_EQ(swapped.distance({}, X_WS).contained, x < 1.0);
    if (x == 0.3) {
      EXPECT_NEAR(result.nhat_BA_W.x, 1.0, 1e-12) << "out of B";
      EXPECT_NEAR(swapped.distance({}, X_WS).nhat_BA_W.x, -1.0, 1e-12);
    }
  }
}

TEST(ProximityQuery, APartInACavityIsFree) {
  TriangleMesh housing = boxMesh({1, 1, 1});
  geometry::append(housing, test::flipped(boxMesh({0.8, 0.8, 0.8})), {});
  const Collider part = MeshCollider::build(boxMesh({0.1, 0.1, 0.1})), hollow = MeshCollider::build(housing);
  const DistanceResult free = distance(part, {}, hollow, {});
  EXPECT_FALSE(free.colliding);
  EXPECT_NEAR(free.distance, 0.35, 1e-12);
  const Collider crumb = MeshCollider::build(boxMesh({0.01, 0.01, 0.01}));
  EXPECT_TRUE(distance(crumb, Pose::translation({0.45, 0, 0}), hollow, {}).contained) << "inside the wall";
  const Collider sheet = MeshCollider::build(test::sheetMesh(0.1, 4, 0.01));
  EXPECT_FALSE(distance(part, {}, sheet, Pose::translation({0, 0, 0.2})).colliding) << "open meshes hold nothing";
}

TEST(ProximityQuery, FarFromTheOriginTheAnswersKeepTheirPrecision) {
  std::mt19937 random(4);
  const Collider a = MeshCollider::build(sphereMesh(0.1)), b = MeshCollider::build(boxMesh({0.2, 0.3, 0.1}));
  const Pose X_far = {{20.0, -17.0, 11.0}, glm::normalize(dquat(0.3, 0.5, -0.2, 0.7))};
  ProximityQuery near(a, b), far(a, b);
  for (int i = 0; i < 200; ++i) {
    const Pose X_WA = test::randomPose(random, 0.4);
    EXPECT_NEAR(near.distance(X_WA, {}).distance, far.distance(X_far * X_WA, X_far).distance, 1e-12);
  }
  TriangleMesh shifted = boxMesh({0.2, 0.3, 0.1});
  for (dvec3& vertex : shifted.vertices) vertex += dvec3(20.0, 20.0, 20.0);
  const Collider c = MeshCollider::build(shifted);
  const Pose X_WA = Pose::translation({20.3, 20.0, 20.0});
  EXPECT_NEAR(distance(a, X_WA, c, {}).distance, distance(a, Pose::translation({0.3, 0, 0}), b, {}).distance, 1e-12);
}

RC_GTEST_PROP(ProximityQuery, IsSymmetricAndRigidlyInvariant, (int seed)) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const Collider a = MeshCollider::build(test::soupMesh(random, 40, 0.2)),
                 b = MeshCollider::build(sphereMesh(0.1, 6, 8));
  const Pose X_WA = test::randomPose(random, 0.5), X_WB = test::randomPose(random, 0.5),
             X_VW = test::randomPose(random, 5);
  const DistanceResult one = distance(a, X_WA, b, X_WB), two = distance(b, X_WB, a, X_WA);
  const DistanceResult moved = distance(a, X_VW * X_WA, b, X_VW * X_WB);
  RC_ASSERT(std::abs(one.distance - two.distance) < 1e-12);
  RC_ASSERT(one.colliding == two.colliding);
  RC_ASSERT(std::abs(one.distance - moved.distance) < 1e-12);
  if (!one.colliding) RC_ASSERT(glm::length(one.nhat_BA_W + two.nhat_BA_W) < 1e-6);
}

TEST(ProximityQuery, NothingIsNearAnEmptyMesh) {
  const Collider empty = MeshCollider::build({}), box = MeshCollider::build(boxMesh({1, 1, 1}));
  EXPECT_TRUE(distance(empty, {}, box, {}).beyond_limit);
  EXPECT_TRUE(distance(box, {}, empty, {}, 0.1).beyond_limit);
  ProximityQuery query(empty, empty);
  EXPECT_FALSE(query.collides({}, {}));
}

}  // namespace
}  // namespace hapticell::collision
