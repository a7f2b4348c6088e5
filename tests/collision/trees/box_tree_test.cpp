// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "tests/collision/queries/meshes.h"

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

TEST_F(BoxTreeBounds, ATriangleIsNeverNearerToABoxThanItsBound) {
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

TEST_F(BoxTreeBounds, ALongSlantingTriangleIsBoundedWithinTheOtherBoxsSize) {
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

/// Every triangle under a slot, once each; checks on the way that all its corners are in the slot's box.
void collectTriangles(const BoxTree& tree, const geometry::TriangleMesh& mesh, BoxTree::Slot slot,
                      std::vector<std::uint32_t>& found) {
  const std::size_t before = found.size();
  const std::uint32_t child = tree.child(slot);
  if (BoxTree::isLeaf(child)) {
    const LeafBlock& leaf = tree.leaf(child);
    ASSERT_TRUE(leaf.count >= 1 && leaf.count <= 4);
    found.insert(found.end(), leaf.triangle, leaf.triangle + leaf.count);
  } else {
    for (std::uint32_t lane = 0; lane < tree.node(child).count; ++lane) {
      collectTriangles(tree, mesh, child * kTreeWidth + lane, found);
    }
  }
  const OrientedBox box = tree.box(slot);
  EXPECT_NEAR(std::abs(glm::determinant(box.R)), 1.0, 1e-6);
  for (std::size_t i = before; i < found.size(); ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_EQ(lowerBoundSquared(box, mesh.corner(found[i], c)), 0.0);
  }
}

TEST_F(BoxTreeBounds, BoxesHoldTheirTrianglesAlsoWhenThoseAreNeedlesOrFarAway) {
  for (const double far : {0.0, 20.0}) {
    geometry::TriangleMesh mesh = test::soupMesh(random_, 300, 1.0);
    for (const geometry::Triangle& triangle : mesh.triangles) {
      const dvec3 middle = 0.5 * (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]]);
      if (triangle[0] % 2 == 0) mesh.vertices[triangle[2]] = middle;
    }
    for (dvec3& vertex : mesh.vertices) vertex += dvec3(far);
    std::vector<std::uint32_t> all(mesh.triangles.size()), found;
    std::iota(all.begin(), all.end(), 0u);
    const BoxTree tree(mesh, all);
    collectTriangles(tree, mesh, BoxTree::kRoot, found);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, all);
  }
}

TEST_F(BoxTreeBounds, TheTreeDoesNotDependOnTheNumberOfThreads) {
  const geometry::TriangleMesh mesh = test::sphereMesh(0.3, 120, 150);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  BuildControl three;
  three.threads = 3;
  const BoxTree one(mesh, all), other(mesh, all, three);
  ASSERT_EQ(one.nodes().size(), other.nodes().size());
  ASSERT_EQ(one.leaves().size(), other.leaves().size());
  EXPECT_EQ(std::memcmp(one.nodes().data(), other.nodes().data(), one.nodes().size() * sizeof(BoxNode)), 0);
  EXPECT_EQ(std::memcmp(one.leaves().data(), other.leaves().data(), one.leaves().size() * sizeof(LeafBlock)), 0);
}

TEST_F(BoxTreeBounds, ATreeOfEqualTrianglesStaysShallow) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(5000, {0, 1, 2});
  std::vector<std::uint32_t> all(mesh.triangles.size()), found;
  std::iota(all.begin(), all.end(), 0u);
  const BoxTree tree(mesh, all);
  collectTriangles(tree, mesh, BoxTree::kRoot, found);
  EXPECT_EQ(found.size(), all.size());
  EXPECT_LT(tree.leaves().size(), all.size() / 2);
}

}  // namespace
}  // namespace hapticell::collision
