// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/collider_build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "collision/queries/proximity_query.h"
#include "collision/trees/tree_cache.h"
#include "tests/collision/queries/meshes.h"
#include "tests/support/test_data.h"

namespace hapticell::collision {
namespace {

using geometry::TriangleMesh;

double distanceTo(const std::shared_ptr<const MeshCollider>& collider) {
  static const auto ball = MeshCollider::build(test::sphereMesh(0.1));
  return distance(ball, Pose::translation({1.0, 0.3, 0.2}), collider, {}).distance;
}

TEST(ColliderBuild, CountsAndLeavesOutWhatIsUnusual) {
  const TriangleMesh sound = test::boxMesh({1, 1, 1});
  TriangleMesh mesh = sound;
  mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  mesh.vertices.push_back({0, std::numeric_limits<double>::infinity(), 0});
  mesh.triangles.insert(mesh.triangles.begin(), {0, 1, 8});
  mesh.triangles.push_back({9, 1, 2});
  mesh.triangles.push_back({2, 0, 1});  // as the box's first, turned on
  mesh.triangles.push_back({0, 1, 2});  // the same, turned over
  mesh.triangles.push_back({3, 3, 3});
  const auto collider = MeshCollider::build(mesh);
  EXPECT_EQ(collider->census().non_finite, 2u);
  EXPECT_EQ(collider->census().duplicate, 2u);
  EXPECT_EQ(collider->census().degenerate, 1u);
  EXPECT_EQ(collider->mesh().triangles.size(), mesh.triangles.size());
  EXPECT_NEAR(collider->radius(), 0.5 * std::sqrt(3.0), 1e-12);
  EXPECT_EQ(distanceTo(collider), distanceTo(MeshCollider::build(sound)));
  EXPECT_TRUE(collider->contains({0.1, 0.2, 0.3}));
  EXPECT_FALSE(collider->contains({0.1, 0.2, 0.6}));
}

TEST(ColliderBuild, NothingIsNearAMeshWithoutAnyNumber) {
  TriangleMesh mesh;
  mesh.vertices.assign(3, dvec3(std::numeric_limits<double>::quiet_NaN()));
  mesh.triangles = {{0, 1, 2}};
  const auto collider = MeshCollider::build(mesh);
  EXPECT_TRUE(collider->isEmpty());
  EXPECT_FALSE(ProximityQuery(collider, MeshCollider::build(test::boxMesh({1, 1, 1}))).collides({}, {}));
  EXPECT_FALSE(collider->contains({0, 0, 0}));
}

TEST(ColliderBuild, ASoupOfLooseTrianglesSharesItsVertices) {
  const TriangleMesh whole = test::sphereMesh(0.3, 30, 40);
  TriangleMesh soup;
  for (std::uint32_t t = 0; t < whole.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) soup.vertices.push_back(whole.corner(t, i));
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const auto collider = MeshCollider::build(soup);
  EXPECT_EQ(collider->mesh().vertices.size(), whole.vertices.size());
  for (std::uint32_t t = 0; t < whole.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(collider->mesh().corner(t, i), soup.corner(t, i));
  }
  EXPECT_LT(static_cast<double>(collider->memory()) / static_cast<double>(soup.triangles.size()), 150.0);
}

TEST(ColliderBuild, IsCancelledAndToldAbout) {
  const TriangleMesh mesh = test::sphereMesh(0.3, 60, 60);
  BuildProgress progress;
  ColliderBuild how;
  how.progress = &progress;
  how.threads = 2;
  EXPECT_NE(MeshCollider::build(mesh, how), nullptr);
  EXPECT_EQ(progress.triangles_done, mesh.triangles.size());
  progress.cancelled = true;
  EXPECT_EQ(MeshCollider::build(mesh, how), nullptr);
}

class TreeCacheFolder : public testing::Test {
 protected:
  std::filesystem::path onlyFile() const {
    std::filesystem::path found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "trees")) {
      EXPECT_TRUE(found.empty());
      found = entry.path();
    }
    return found;
  }
  ColliderBuild how() const {
    ColliderBuild result;
    result.cache_folder = folder_.path() / "trees";
    return result;
  }
  test::TemporaryFolder folder_;
  TriangleMesh mesh_ = test::sphereMesh(0.3, 40, 40);
};

TEST_F(TreeCacheFolder, GivesBackTheTreeThatWasStored) {
  const TreeCache cache(folder_.path() / "trees");
  EXPECT_FALSE(cache.load(mesh_, contentHash(mesh_)));
  const auto built = MeshCollider::build(mesh_, how());
  const auto kept = cache.load(mesh_, contentHash(mesh_));
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->nodes().size(), built->tree().nodes().size());
  EXPECT_EQ(
      std::memcmp(kept->leaves().data(), built->tree().leaves().data(), kept->leaves().size() * sizeof(LeafBlock)), 0);
  EXPECT_EQ(distanceTo(MeshCollider::build(mesh_, how())), distanceTo(built));
  TriangleMesh other = mesh_;
  other.vertices[7].x = std::nextafter(other.vertices[7].x, 1.0);
  EXPECT_FALSE(cache.load(other, contentHash(other))) << "another content is another file";
}

TEST_F(TreeCacheFolder, PassesOverDamagedFilesAndWritesThemAnew) {
  const double expected = distanceTo(MeshCollider::build(mesh_, how()));
  const std::filesystem::path file = onlyFile();
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(file));
  for (const std::size_t at : {std::size_t{0}, std::size_t{9}, std::size_t{40}, size / 3, size / 2, size - 1}) {
    {
      std::fstream damaged(file, std::ios::binary | std::ios::in | std::ios::out);
      damaged.seekg(static_cast<std::streamoff>(at));
      const char was = static_cast<char>(damaged.get());
      damaged.seekp(static_cast<std::streamoff>(at));
      damaged.put(static_cast<char>(was ^ 0x41));
    }
    EXPECT_FALSE(TreeCache(folder_.path() / "trees").load(mesh_, contentHash(mesh_))) << "byte " << at;
    EXPECT_EQ(distanceTo(MeshCollider::build(mesh_, how())), expected);
    EXPECT_TRUE(TreeCache(folder_.path() / "trees").load(mesh_, contentHash(mesh_)));
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, size / 2, size - 1}) {
    std::filesystem::resize_file(file, length);
    EXPECT_EQ(distanceTo(MeshCollider::build(mesh_, how())), expected);
  }
}

TEST_F(TreeCacheFolder, DoesWithoutAFolderThatCannotBeMade) {
  const auto in_the_way = folder_.write("trees", "a file, not a folder");
  EXPECT_EQ(distanceTo(MeshCollider::build(mesh_, how())), distanceTo(MeshCollider::build(mesh_)));
}

}  // namespace
}  // namespace hapticell::collision
