// SPDX-License-Identifier: Apache-2.0
#include "collision/box_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/collision/meshes.h"

namespace hapticell::collision {
namespace {

/// The second method: the triangle against the box's twelve faces; 0 where they meet or the triangle is inside.
double distanceToBox(const Corners& triangle, const OrientedBox& box) {
  const geometry::TriangleMesh faces = test::boxMesh(2.0 * box.half);
  NearestPair best;
  for (std::uint32_t t = 0; t < faces.triangles.size(); ++t) {
    Corners face;
    for (int i = 0; i < 3; ++i) face[static_cast<std::size_t>(i)] = box.center + box.R * faces.corner(t, i);
    improveTriangleDistance(face, triangle, best);
  }
  return std::sqrt(best.squared);
}

class BoxTreeBounds : public testing::Test {
 protected:
  dvec3 direction() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  OrientedBox box(double size) {
    const Pose X = test::randomPose(random_, 1.0);
    return {X.R(), X.p, size * (glm::abs(direction()) + 0.01)};
  }
  std::mt19937 random_{8};
  std::normal_distribution<double> normal_;
};

TEST_F(BoxTreeBounds, aTriangleIsNeverNearerToABoxThanItsBound) {
  for (int i = 0; i < 2000; ++i) {
    const dvec3 middle = 3.0 * direction();
    const double spread = i % 2 == 0 ? 4.0 : 0.2;
    Corners triangle{middle + spread * direction(), middle + spread * direction(), middle + spread * direction()};
    if (i % 5 == 0) triangle[2] = 0.5 * (triangle[0] + triangle[1]) + 1e-9 * direction();
    if (i % 7 == 0) triangle[1] = triangle[0];
    const OrientedBox near = box(0.3);
    EXPECT_LE(std::sqrt(lowerBoundSquared(near, triangle)), distanceToBox(triangle, near) + 1e-12);
  }
}

TEST_F(BoxTreeBounds, aLongSlantingTriangleIsBoundedWithinTheOtherBoxsSize) {
  // Its own box comes nearer by metres; small parts beside large ones would try every triangle (a query of 60 ms).
  for (int i = 0; i < 500; ++i) {
    const Corners triangle{dvec3(0.0), dvec3(100.0, 3.0, 1.0), dvec3(100.0, 3.0, 1.0) + direction()};
    OrientedBox near = box(0.1);
    near.center += dvec3(50.0, 20.0, 0.0);
    const double bound = std::sqrt(lowerBoundSquared(near, triangle));
    EXPECT_GE(bound, distanceToBox(triangle, near) - glm::length(near.half));
    EXPECT_GT(bound, 10.0);
  }
}

TEST_F(BoxTreeBounds, leavesHoldTheirTrianglesAlsoWhenThoseAreNeedles) {
  geometry::TriangleMesh mesh = test::soupMesh(random_, 300, 1.0);
  for (const geometry::Triangle& triangle : mesh.triangles) {
    const dvec3 middle = 0.5 * (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]]);
    if (triangle[0] % 2 == 0) mesh.vertices[triangle[2]] = middle;
  }
  const BoxTree tree(mesh);
  for (std::uint32_t index = 0; index < tree.nodeCount(); ++index) {
    const BoxTree::Node& node = tree.node(index);
    EXPECT_NEAR(std::abs(glm::determinant(node.box.R)), 1.0, 1e-14);
    for (std::uint32_t slot = node.first; node.isLeaf() && slot < node.first + node.count; ++slot) {
      for (const dvec3& corner : tree.corners(slot)) {
        EXPECT_LE(std::sqrt(lowerBoundSquared(node.box, corner)), 1e-14);
        EXPECT_LE(std::sqrt(lowerBoundSquared(tree.root().box, corner)), 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace hapticell::collision
