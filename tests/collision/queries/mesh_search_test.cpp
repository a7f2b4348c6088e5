// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/mesh_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/collision/queries/meshes.h"

namespace hapticell::collision {
namespace {

Corners cornersOf(const geometry::TriangleMesh& mesh, std::uint32_t t, const Pose& X = {}) {
  return {X * mesh.corner(t, 0), X * mesh.corner(t, 1), X * mesh.corner(t, 2)};
}

class MeshSearch : public testing::Test {
 protected:
  dvec3 anywhere(double reach) {
    std::uniform_real_distribution<double> uniform(-reach, reach);
    return {uniform(random_), uniform(random_), uniform(random_)};
  }
  std::mt19937 random_{17};
  std::shared_ptr<const MeshCollider> mesh_ = MeshCollider::build(test::soupMesh(random_, 300, 0.3));
};

TEST_F(MeshSearch, NearestPointAgreesWithEveryTriangle) {
  for (int i = 0; i < 300; ++i) {
    const dvec3 p = anywhere(0.8);
    double least = 1e9;
    for (std::uint32_t t = 0; t < mesh_->mesh().triangles.size(); ++t) {
      least = std::min(least, glm::distance(p, closestPointOnTriangle(cornersOf(mesh_->mesh(), t), p)));
    }
    const NearestPoint nearest = nearestPoint(*mesh_, p);
    ASSERT_TRUE(nearest.found);
    EXPECT_NEAR(nearest.distance, least, 1e-12);
    EXPECT_NEAR(glm::distance(nearest.p_MQ, p), least, 1e-12);
    EXPECT_EQ(nearestPoint(*mesh_, p, 0.1).found, least < 0.1);
  }
}

TEST_F(MeshSearch, ClosestPointOnTriangleBeatsEverySampledPoint) {
  for (int i = 0; i < 200; ++i) {
    const Corners corners{anywhere(1), anywhere(1), anywhere(1)};
    const dvec3 p = anywhere(2);
    const double least = glm::distance(p, closestPointOnTriangle(corners, p));
    double sampled = 1e9;
    for (int u = 0; u <= 50; ++u) {
      for (int v = 0; v + u <= 50; ++v) {
        const dvec3 q = corners[0] + (u / 50.0) * (corners[1] - corners[0]) + (v / 50.0) * (corners[2] - corners[0]);
        sampled = std::min(sampled, glm::distance(p, q));
      }
    }
    EXPECT_LE(least, sampled + 1e-12);
    EXPECT_GT(least, sampled - 0.06) << "and a point of the triangle is that near";
  }
}

TEST_F(MeshSearch, TrianglesWithinAreExactlyThoseNearEnough) {
  const geometry::TriangleMesh& mesh = mesh_->mesh();
  const auto other = MeshCollider::build(test::sphereMesh(0.1, 6, 8));
  for (int i = 0; i < 60; ++i) {
    const dvec3 p = anywhere(0.4);
    const Pose X_MO = test::randomPose(random_, 0.4);
    std::vector<std::uint32_t> by_point, by_mesh, point_expected, mesh_expected;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Corners corners = cornersOf(mesh, t);
      if (glm::distance(p, closestPointOnTriangle(corners, p)) <= 0.1) point_expected.push_back(t);
      double least = 1e9;
      for (std::uint32_t j = 0; j < other->mesh().triangles.size(); ++j) {
        least = std::min(least, std::sqrt(triangleDistance(corners, cornersOf(other->mesh(), j, X_MO)).squared));
      }
      if (least <= 0.05) mesh_expected.push_back(t);
    }
    trianglesWithin(*mesh_, p, 0.1, by_point);
    trianglesWithin(*mesh_, *other, X_MO, 0.05, by_mesh);
    std::sort(by_point.begin(), by_point.end());
    EXPECT_EQ(by_point, point_expected);
    EXPECT_EQ(by_mesh, mesh_expected);
  }
}

TEST_F(MeshSearch, TrianglesNearABoxCountThoseInsideIt) {
  const geometry::Bounds box{dvec3(-0.1), dvec3(0.1)};
  const auto solid = MeshCollider::build(test::boxMesh(dvec3(0.2)));
  std::vector<std::uint32_t> found, near_surface;
  trianglesWithin(*mesh_, box, 0.03, found);
  trianglesWithin(*mesh_, *solid, {}, 0.03, near_surface);
  for (std::uint32_t t = 0; t < mesh_->mesh().triangles.size(); ++t) {
    const bool inside = solid->contains(mesh_->mesh().corner(t, 0));
    const bool expected = inside || std::find(near_surface.begin(), near_surface.end(), t) != near_surface.end();
    EXPECT_EQ(std::find(found.begin(), found.end(), t) != found.end(), expected) << t;
  }
}

TEST_F(MeshSearch, RaysMeetTheNearestTriangle) {
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const dvec3 origin = anywhere(0.6), direction = anywhere(1.0);
    const RayHit hit = castRay(*mesh_, origin, direction);
    if (!hit.found) continue;
    ++hits;
    EXPECT_LT(glm::distance(hit.p_MQ, closestPointOnTriangle(cornersOf(mesh_->mesh(), hit.triangle), hit.p_MQ)), 1e-9);
    EXPECT_LT(glm::distance(hit.p_MQ, origin + hit.along * direction), 1e-12);
    // Nothing lies in between: the open stretch before the hit is not met by a needle-thin triangle of the second
    // method.
    const Corners needle{origin, origin + 0.5 * hit.along * direction, origin + 0.999999 * hit.along * direction};
    for (std::uint32_t t = 0; t < mesh_->mesh().triangles.size(); ++t) {
      EXPECT_GT(triangleDistance(needle, cornersOf(mesh_->mesh(), t)).squared, 0.0);
    }
  }
  EXPECT_GT(hits, 20);
}

TEST_F(MeshSearch, RaysThroughEdgesAndCornersOfASolidMeetIt) {
  // Along the diagonals of the six faces of a box, and through its edges and corners, turned in several ways.
  const auto box = MeshCollider::build(test::boxMesh(dvec3(0.2)));
  const Pose turned{{0.1, 0.2, 0.3}, dquat(dvec3(0.3, 0.7, -0.2))};
  for (const Pose& X_WM : {Pose{}, Pose::translation({0.3, -0.1, 0.7}), turned}) {
    const Pose X_MW = X_WM.inverse();
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const dvec3 on_surface = 0.5 * dvec3(x, y, z) * box->mesh().bounds().max;
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) < 2) continue;
          // To the centre of the box: along the lines in which the triangles of a face meet.
          const dvec3 origin = X_MW * (X_WM * (3.0 * on_surface)), direction = X_MW.rotate(X_WM.rotate(-on_surface));
          const RayHit hit = castRay(*box, origin, direction);
          ASSERT_TRUE(hit.found) << x << ' ' << y << ' ' << z;
          EXPECT_NEAR(hit.along, 2.0, 1e-9);
          EXPECT_LT(glm::distance(hit.p_MQ, on_surface), 1e-9);
          EXPECT_FALSE(castRay(*box, origin, -direction).found) << "the box is behind the origin";
        }
      }
    }
  }
}

TEST_F(MeshSearch, CollectingPairsStopsAtTheMaximum) {
  std::vector<TrianglePair> pairs;
  EXPECT_FALSE(trianglePairsWithin(*mesh_, *mesh_, {}, 0.1, pairs, 10));
  EXPECT_EQ(pairs.size(), 10u);
  pairs.clear();
  EXPECT_TRUE(trianglePairsWithin(*mesh_, *mesh_, Pose::translation({9, 0, 0}), 0.1, pairs));
  EXPECT_TRUE(pairs.empty());
}

}  // namespace
}  // namespace hapticell::collision
