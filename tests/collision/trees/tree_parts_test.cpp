// SPDX-License-Identifier: Apache-2.0
// What trees of boxes are made of, part by part, each against trying everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <set>

#include "collision/trees/box_fit.h"
#include "collision/trees/box_tree_builder.h"
#include "collision/trees/cache_file.h"
#include "collision/trees/dual_traversal.h"
#include "collision/trees/mesh_collider.h"
#include "collision/trees/ray.h"
#include "collision/trees/triangle_census.h"
#include "tests/collision/queries/meshes.h"
#include "tests/support/test_data.h"

namespace hapticell::collision {
namespace {

class TreePartsTest : public testing::Test {
 protected:
  dvec3 vector(double size = 1.0) { return size * dvec3(normal_(random_), normal_(random_), normal_(random_)); }
  std::mt19937 random_{19};
  std::normal_distribution<double> normal_;
};

TEST_F(TreePartsTest, ARayMeetsATriangleWhereMoellerAndTrumboreSay) {
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Corners t{vector(), vector(), vector()};
    const Ray ray{vector(2.0), vector()};
    const dvec3 e1 = t[1] - t[0], e2 = t[2] - t[0], h = glm::cross(ray.direction, e2);
    const double det = glm::dot(e1, h);
    const dvec3 s = ray.origin - t[0], q = glm::cross(s, e1);
    const double u = glm::dot(s, h) / det, v = glm::dot(ray.direction, q) / det, along = glm::dot(e2, q) / det;
    if (std::min({std::abs(u), std::abs(v), std::abs(1.0 - u - v), std::abs(along)}) < 1e-9) continue;
    const bool expected = u > 0.0 && v > 0.0 && u + v < 1.0 && along > 0.0;
    const RayCrossing crossing = meetTriangle(ray, t);
    EXPECT_EQ(crossing.meets, expected);
    EXPECT_FALSE(crossing.grazes);
    if (!expected) continue;
    ++met;
    EXPECT_NEAR(crossing.along, along, 1e-7 * (1.0 + along));
    EXPECT_EQ(crossing.leaving, glm::dot(ray.direction, glm::cross(e1, e2)) > 0.0);
  }
  EXPECT_GT(met, 50);
}

TEST_F(TreePartsTest, ARayThroughAnEdgeACornerOrAlongTheFaceGrazes) {
  const Corners t{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)};
  const dvec3 down(0, 0, -2);
  EXPECT_TRUE(meetTriangle({{0.5, 0.0, 1.0}, down}, t).grazes);
  EXPECT_TRUE(meetTriangle({{0.0, 0.0, 1.0}, down}, t).grazes);
  EXPECT_TRUE(meetTriangle({{-1.0, 0.2, 0.0}, {1, 0, 0}}, t).grazes);
  EXPECT_FALSE(meetTriangle({{0.5, 0.0, -1.0}, down}, t).grazes) << "all of it is behind the origin";
  const RayCrossing middle = meetTriangle({{0.2, 0.2, 1.0}, down}, t);
  EXPECT_TRUE(middle.meets && !middle.grazes && !middle.leaving);
  EXPECT_NEAR(middle.along, 0.5, 1e-15) << "in lengths of the direction";
}

TEST_F(TreePartsTest, ARayMeetsABoxWhereItMeetsItsFaces) {
  for (int i = 0; i < 1000; ++i) {
    const Pose X = test::randomPose(random_, 0.5);
    const OrientedBox box{X.R(), X.p, 0.4 * glm::abs(vector()) + 0.05};
    const Ray ray{vector(2.0), vector()};
    const geometry::TriangleMesh faces = test::boxMesh(2.0 * box.half);
    double nearest = std::numeric_limits<double>::infinity();
    bool is_inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      is_inside = is_inside && std::abs(glm::dot(box.R[axis], ray.origin - box.center)) < box.half[axis];
    }
    for (std::uint32_t t = 0; t < faces.triangles.size(); ++t) {
      const RayCrossing crossing =
          meetTriangle(ray, {X * faces.corner(t, 0), X * faces.corner(t, 1), X * faces.corner(t, 2)});
      if (crossing.meets) nearest = std::min(nearest, crossing.along);
    }
    if (is_inside) nearest = 0.0;
    double entry = -1.0;
    const bool meets = meetsBox(ray, box, std::numeric_limits<double>::infinity(), entry);
    EXPECT_EQ(meets, std::isfinite(nearest));
    if (!meets) continue;
    EXPECT_NEAR(entry, nearest, 1e-9 * (1.0 + nearest));
    EXPECT_FALSE(meetsBox(ray, box, 0.99 * nearest - 1e-9, entry)) << "farther than that does not count";
  }
}

TEST_F(TreePartsTest, AFlatBoxInTheWayIsMet) {
  double entry = 0.0;
  const OrientedBox sheet{dmat3(1.0), {0, 0, 3}, {1.0, 1.0, 0.0}};
  EXPECT_TRUE(meetsBox({{0.2, 0.3, 0.0}, {0, 0, 2}}, sheet, 10.0, entry));
  EXPECT_NEAR(entry, 1.5, 1e-9);
  EXPECT_FALSE(meetsBox({{0.2, 0.3, 0.0}, {0, 0, -2}}, sheet, 10.0, entry));
  EXPECT_FALSE(meetsBox({{2.0, 0.3, 0.0}, {0, 0, 2}}, sheet, 10.0, entry));
}

TEST_F(TreePartsTest, TheCensusCountsWhatIsUnusual) {
  geometry::TriangleMesh mesh = test::boxMesh(dvec3(1.0));
  const std::size_t plain = mesh.triangles.size();
  const geometry::Triangle first = mesh.triangles[0];
  mesh.triangles.push_back({first[1], first[2], first[0]});  // the same, turned
  mesh.triangles.push_back({first[0], first[2], first[1]});  // the same, inside out
  mesh.triangles.push_back({first[0], first[0], first[1]});  // a segment
  mesh.triangles.push_back({first[2], first[2], first[2]});  // a point
  const auto bad = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  mesh.vertices.push_back({0, std::numeric_limits<double>::infinity(), 0});
  mesh.triangles.push_back({bad, 0, 1});
  mesh.triangles.push_back({0, 1, bad + 1});
  const CountedTriangles counted = countTriangles(mesh);
  EXPECT_EQ(counted.census.duplicate, 2u);
  EXPECT_EQ(counted.census.degenerate, 2u);
  EXPECT_EQ(counted.census.non_finite, 2u);
  ASSERT_EQ(counted.kept.size(), plain + 2);
  EXPECT_TRUE(std::is_sorted(counted.kept.begin(), counted.kept.end()));
  EXPECT_EQ(countTriangles({}).kept.size(), 0u);
}

TEST_F(TreePartsTest, ASoupSharesVerticesThatAreEqualToTheLastBit) {
  const geometry::TriangleMesh box = test::boxMesh(dvec3(1.0));
  geometry::TriangleMesh soup;
  for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
    const auto at = static_cast<std::uint32_t>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(box.corner(t, k));
    soup.triangles.push_back({at, at + 1, at + 2});
  }
  soup.vertices[0].x = std::nextafter(soup.vertices[0].x, 9.0);
  const geometry::TriangleMesh shared = shareVertices(soup);
  EXPECT_EQ(shared.vertices.size(), 9u) << "eight corners and the one that is off by a bit";
  ASSERT_EQ(shared.triangles.size(), soup.triangles.size());
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(shared.corner(t, k), soup.corner(t, k));
  }
  EXPECT_EQ(shareVertices(box).vertices, box.vertices) << "nothing to share";
  EXPECT_TRUE(shareVertices({}).vertices.empty());
}

std::vector<BuildItem> buildItems(const geometry::TriangleMesh& mesh) {
  std::vector<BuildItem> items;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    BuildItem item{};
    item.triangle = t;
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) item.corner[3 * k + axis] = static_cast<float>(mesh.corner(t, k)[axis]);
    }
    items.push_back(item);
  }
  return items;
}

TEST_F(TreePartsTest, AFittedBoxHoldsItsTrianglesAndIsNoLargerThanTheGivenOne) {
  for (int trial = 0; trial < 50; ++trial) {
    geometry::TriangleMesh mesh =
        trial % 2 == 0 ? test::soupMesh(random_, 3 + trial, 0.3) : test::boxMesh({0.8, 0.1, 0.02});
    const Pose X = test::randomPose(random_, 0.1);
    for (dvec3& v : mesh.vertices) v = X * v;
    const std::vector<BuildItem> items = buildItems(mesh);
    const BuildAxes given;
    Extent along_given;
    for (const BuildItem& item : items) along_given.add(extentOf(item, given));
    const FittedBox box = fitBox(items.data(), items.size(), given, along_given);
    EXPECT_LE(box.extent.surface(), along_given.surface() * 1.0001f);
    for (const BuildItem& item : items) {
      for (int k = 0; k < 3; ++k) {
        const Float4 at = box.axes.along(item.corner + 3 * k);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GE(at[axis], box.extent.low[axis] - 1e-5f);
          EXPECT_LE(at[axis], box.extent.high[axis] + 1e-5f);
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const float size = box.axes.x[axis] * box.axes.x[axis] + box.axes.y[axis] * box.axes.y[axis] +
                         box.axes.z[axis] * box.axes.z[axis];
      EXPECT_NEAR(size, 1.0f, 1e-4f) << "unit axes";
    }
  }
}

TEST_F(TreePartsTest, AnySizeOfTreeHoldsEachTriangleOnceWhateverTheThreads) {
  for (const int count : {1, 4, 5, 33, 700}) {
    const geometry::TriangleMesh mesh = test::soupMesh(random_, count, 0.5);
    std::vector<std::uint32_t> all(mesh.triangles.size());
    for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    const TreeParts one = buildTree(mesh, all, {});
    std::atomic<std::size_t> done{0};
    const TreeParts four = buildTree(mesh, all, {.threads = 4, .done = &done});
    EXPECT_EQ(done.load(), all.size());
    std::vector<int> times(all.size(), 0);
    for (const LeafBlock& leaf : one.leaves) {
      ASSERT_GE(leaf.count, 1u);
      ASSERT_LE(leaf.count, static_cast<std::uint32_t>(kLeafSize));
      for (std::uint32_t i = 0; i < leaf.count; ++i) ++times[leaf.triangle[i]];
    }
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; })) << count;
    ASSERT_EQ(one.nodes.size(), four.nodes.size());
    ASSERT_EQ(one.leaves.size(), four.leaves.size());
    EXPECT_EQ(std::memcmp(one.leaves.data(), four.leaves.data(), one.leaves.size() * sizeof(LeafBlock)), 0);
  }
  const std::atomic<bool> cancelled{true};
  const geometry::TriangleMesh mesh = test::soupMesh(random_, 700, 0.5);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  EXPECT_TRUE(buildTree(mesh, all, {.cancelled = &cancelled}).leaves.empty());
}

std::span<const std::byte> asBytes(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

ContentHash hashOfText(const std::string& text) {
  ContentHash hash{};
  addToHash(hash, asBytes(text));
  return hash;
}

TEST_F(TreePartsTest, EachBitAndTheLengthChangeTheNameOfAContent) {
  std::set<std::string> names;
  std::string text = "thirty-one bytes of some content";
  names.insert(nameOf(hashOfText(text)));
  EXPECT_EQ(names.begin()->size(), 32u);
  EXPECT_EQ(names.begin()->find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(nameOf(hashOfText(text)), *names.begin());
  std::size_t different = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit, ++different) {
      text[i] = static_cast<char>(text[i] ^ (1 << bit));
      names.insert(nameOf(hashOfText(text)));
      text[i] = static_cast<char>(text[i] ^ (1 << bit));
    }
  }
  for (std::size_t zeros = 0; zeros < 40; ++zeros, ++different)
    names.insert(nameOf(hashOfText(std::string(zeros, '\0'))));
  EXPECT_EQ(names.size(), different) << "zeros at the end count as well";
}

TEST_F(TreePartsTest, ACacheFileIsWrittenWholeOrNotAtAll) {
  const hapticell::test::TemporaryFolder folder;
  const auto file = folder.path() / "made" / "for it" / "a.tree";
  writeWhole(file, {asBytes("one, "), asBytes(""), asBytes("two")});
  std::ifstream stream(file, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "one, two");
  const auto blocked = folder.write("file", "x") / "below a file";
  writeWhole(blocked, {asBytes("lost")});  // quietly
  EXPECT_FALSE(std::filesystem::exists(blocked));
}

/// Collects all pairs of triangles that the traversal comes to, and the least bound of what it leaves out.
struct PairCollector {
  float limit = 0.08f;
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  float least_left_out = std::numeric_limits<float>::infinity();
  float limitSquared() const { return limit * limit; }
  bool isDone() const { return false; }
  void leafPair(const TraversalBox&, const TraversalBox&, const LeafBlock& a, const LeafBlock& b,
                const LeafTransform&) {
    for (std::uint32_t i = 0; i < a.count; ++i) {
      for (std::uint32_t j = 0; j < b.count; ++j) pairs.insert({a.triangle[i], b.triangle[j]});
    }
  }
  void culled(const TraversalBox&, const TraversalBox&, bool, unsigned, float least_squared) {
    least_left_out = std::min(least_left_out, least_squared);
  }
};

TEST_F(TreePartsTest, TheTraversalComesToEachPairThatIsNearEnough) {
  for (int trial = 0; trial < 10; ++trial) {
    const auto a = MeshCollider::build(test::soupMesh(random_, 120, 0.4));
    const auto b =
        MeshCollider::build(trial % 2 == 0 ? test::sheetMesh(1.0, 5, 0.1) : test::soupMesh(random_, 90, 0.3));
    const Pose X_AB = test::randomPose(random_, 0.6);
    PairCollector collector;
    DualTraversal<PairCollector>(a->tree(), b->tree(), X_AB, collector).run();
    EXPECT_GE(collector.least_left_out, 0.08f * 0.08f);
    std::size_t near = 0;
    for (std::uint32_t i = 0; i < a->mesh().triangles.size(); ++i) {
      for (std::uint32_t j = 0; j < b->mesh().triangles.size(); ++j) {
        const Corners moved{X_AB * b->mesh().corner(j, 0), X_AB * b->mesh().corner(j, 1),
                            X_AB * b->mesh().corner(j, 2)};
        if (triangleDistance(a->mesh().corners(i), moved).squared >= 0.079 * 0.079) continue;
        ++near;
        EXPECT_TRUE(collector.pairs.contains({i, j})) << i << " " << j;
      }
    }
    if (near == 0) continue;
    EXPECT_LT(collector.pairs.size(), a->mesh().triangles.size() * b->mesh().triangles.size()) << "and leaves some out";
  }
}

}  // namespace
}  // namespace hapticell::collision
