// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "collision/surfaces/surface_recognition.h"
#include "collision/trees/tree_cache.h"
#include "tests/collision/surfaces/generated_parts.h"

namespace hapticell::test {
namespace {

using collision::RecognisedSurface;

struct Folder {
  Folder() : path(std::filesystem::temp_directory_path() / ("surface_cache_" + std::to_string(::getpid()))) {}
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

void expectEqual(const RecognisedSurface& a, const RecognisedSurface& b) {
  ASSERT_EQ(a.regions.size(), b.regions.size());
  EXPECT_EQ(a.region_of, b.region_of);
  for (std::size_t i = 0; i < a.regions.size(); ++i) {
    const auto &one = a.regions[i], &other = b.regions[i];
    EXPECT_EQ(one.triangles, other.triangles);
    EXPECT_EQ(one.shape.type, other.shape.type);
    EXPECT_EQ(one.shape.p_M, other.shape.p_M);
    EXPECT_EQ(one.shape.axis_M, other.shape.axis_M);
    EXPECT_EQ(one.shape.radius, other.shape.radius);
    EXPECT_EQ(one.shape.side, other.shape.side);
    EXPECT_EQ(one.area, other.area);
    EXPECT_EQ(one.sagitta, other.sagitta);
    EXPECT_EQ(one.mean_nhat_M, other.mean_nhat_M);
    EXPECT_EQ(one.trims.size(), other.trims.size());
    EXPECT_EQ(one.borders.size(), other.borders.size());
  }
}

TEST(SurfaceCache, GivesBackWhatWasRecognisedToTheLastBit) {
  const Folder folder;
  for (const char* name : {"plate", "torus", "bracket with fillet"}) {
    const auto mesh = generatedPart(name).mesh;
    const auto plain = collision::recogniseSurfaces(mesh);
    const auto first = collision::recogniseSurfaces(mesh, {.cache_folder = folder.path});
    RecognisedSurface kept = plain;
    kept.regions.clear();
    kept.region_of.clear();
    ASSERT_TRUE(collision::SurfaceCache(folder.path).load(collision::contentHash(mesh), kept)) << name;
    EXPECT_EQ(kept.region_of, plain.region_of);
    expectEqual(first, plain);
    expectEqual(collision::recogniseSurfaces(mesh, {.cache_folder = folder.path}), plain);
  }
}

TEST(SurfaceCache, PassesOverDamagedFilesAndWritesThemAnew) {
  const Folder folder;
  const auto mesh = generatedPart("shaft").mesh;
  const auto plain = collision::recogniseSurfaces(mesh, {.cache_folder = folder.path});
  const auto hash = collision::contentHash(mesh);
  const auto path = folder.path / (collision::nameOf(hash) + ".surfaces");
  const auto size = std::filesystem::file_size(path);
  const auto isKept = [&] {
    RecognisedSurface into = plain;
    return collision::SurfaceCache(folder.path).load(hash, into);
  };
  EXPECT_TRUE(isKept());
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(size / 2));
    file.put('\x55').put('\x2a').put('\x55');
  }
  EXPECT_FALSE(isKept());
  expectEqual(collision::recogniseSurfaces(mesh, {.cache_folder = folder.path}), plain);
  EXPECT_TRUE(isKept());
  std::filesystem::resize_file(path, size - 5);
  EXPECT_FALSE(isKept());
  std::filesystem::resize_file(path, 3);
  EXPECT_FALSE(isKept());
}

TEST(SurfaceCache, AnotherMeshFindsNothing) {
  const Folder folder;
  const auto plate = collision::recogniseSurfaces(generatedPart("plate").mesh, {.cache_folder = folder.path});
  RecognisedSurface other = plate;
  EXPECT_FALSE(collision::SurfaceCache(folder.path).load(collision::contentHash(generatedPart("shaft").mesh), other));
  expectEqual(other, plate);
}

}  // namespace
}  // namespace hapticell::test
