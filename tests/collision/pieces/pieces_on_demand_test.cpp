// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/pieces_on_demand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "geometry/shapes/shapes.h"
#include "tests/collision/contacts/zone_scenes.h"

namespace hapticell::test {
namespace {

using collision::ConvexPieces;
using collision::MeshCollider;
using collision::PiecesOnDemand;

/// A sheet of `cells` squares a side over [-half, half]^2, its height told for each place.
template <typename Height>
geometry::TriangleMesh sheet(double half, int cells, const Height& height) {
  geometry::TriangleMesh mesh;
  const auto row = static_cast<std::uint32_t>(cells + 1);
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double x = half * (2.0 * i / cells - 1.0), y = half * (2.0 * j / cells - 1.0);
      mesh.vertices.emplace_back(x, y, height(x, y));
    }
  }
  for (std::uint32_t i = 0; i + 1 < row; ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t at = i * row + j;
      mesh.triangles.push_back({at, at + row, at + row + 1});
      mesh.triangles.push_back({at, at + row + 1, at + 1});
    }
  }
  return mesh;
}

/// A groove of 90 degrees along y with a fine wave on its sides that no surface fits.
geometry::TriangleMesh wavyGroove(int cells) {
  return sheet(0.5, cells, [](double x, double y) { return std::abs(x) + 1e-3 * std::sin(100.0 * x + 60.0 * y); });
}

TEST(PiecesOnDemand, HoldEveryTriangleOnceAndNoOtherSurface) {
  for (const ZoneScene& scene : simpleZoneScenes()) {
    if (scene.name == "box among posts") continue;  // Solids that overlap.
    const auto collider = MeshCollider::build(scene.environment);
    const double tolerance = ConvexPieces::onDemand(collider)->tolerance();
    const PiecesOnDemand pieces(collider, tolerance);
    const geometry::TriangleMesh& mesh = collider->mesh();
    std::vector<int> times(mesh.triangles.size(), 0);
    for (std::uint32_t block = 0; block < pieces.blockCount(); ++block) {
      ASSERT_LE(pieces.block(block).size(), PiecesOnDemand::kMostInBlock);
      for (const collision::ConvexPiece& piece : pieces.block(block)) {
        for (const auto triangle : piece.triangles) {
          ++times[triangle];
          EXPECT_EQ(pieces.blockOfEachTriangle()[triangle], block);
        }
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
          const dvec3 middle = (mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3.0;
          double depth = 1e9;
          for (const auto& plane : piece.hull.planes)
            depth = std::min(depth, plane.offset - glm::dot(plane.nhat, middle));
          EXPECT_LE(depth, 2.0 * tolerance) << scene.name;
        }
      }
    }
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; })) << scene.name;
  }
}

TEST(PiecesOnDemand, AreTheSameWhoeverAsksAndWhen) {
  const auto collider = MeshCollider::build(wavyGroove(40));
  const PiecesOnDemand first(collider, 2e-6), second(collider, 2e-6);
  std::vector<std::thread> askers;
  for (int k = 0; k < 2; ++k) {
    askers.emplace_back([&] {
      for (std::uint32_t block = 0; block < first.blockCount(); ++block) first.block(block);
    });
  }
  for (std::thread& asker : askers) asker.join();
  for (std::uint32_t back = second.blockCount(); back > 0; --back) {
    const auto &a = first.block(back - 1), &b = second.block(back - 1);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].triangles, b[i].triangles);
      EXPECT_EQ(a[i].hull.vertices, b[i].hull.vertices);
    }
  }
}

TEST(PiecesOnDemand, TellSimpleScenesAsExactGeometryDoes) {
  for (const ZoneScene& scene : simpleZoneScenes()) {
    ZoneBench bench(scene, ZoneBench::Ways::kFacets, ZoneBench::Cutting::kOnDemand);
    const ZoneReport report = bench.compare(300, 0.3);
    std::puts(line(report).c_str());
    EXPECT_TRUE(report.complete) << scene.name;
    EXPECT_LE(report.entries, 64u) << scene.name;
    EXPECT_EQ(report.holes, 0) << scene.name;
    EXPECT_LE(report.false_walls, 0.01 * report.free) << scene.name;
    EXPECT_LE(report.turned_holes, 0.01 * report.turned) << scene.name;
  }
}

/// Three hundred thousand triangles that no surface fits: both sides of the groove are felt, and nothing that is not there.
TEST(PiecesOnDemand, ALargeFreeFormMeshIsFeltOnBothSides) {
  ZoneScene scene;
  scene.name = "ball in a wavy groove of 300 000";
  scene.environment = wavyGroove(390);
  scene.moving = geometry::makeSphere(0.03, 14);
  scene.radius = 0.01;
  for (const double aside : {0.0, 0.001, -0.0015}) {
    scene.places.push_back(Pose::translation({aside, 0.013, 0.03 * std::sqrt(2.0) + 0.0022}));
  }
  ASSERT_EQ(scene.environment.triangles.size(), 304200u);
  ZoneBench bench(scene, ZoneBench::Ways::kFacets, ZoneBench::Cutting::kOnDemand);
  const ZoneReport report = bench.compare(250, 0.1);
  std::puts(line(report).c_str());
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.holes, 0);
  EXPECT_GT(report.blocked, 15);
  EXPECT_LE(report.false_walls, 0.005 * report.free);
  const auto set = bench.query(scene.places[0]);
  const auto faces = [&](double x) {
    return std::any_of(set.contacts.begin(), set.contacts.end(),
                       [&](const collision::ZoneContact& c) { return x * c.nhat_W.x > 0.4 && c.nhat_W.z > 0.4; });
  };
  EXPECT_TRUE(faces(1.0));
  EXPECT_TRUE(faces(-1.0));
}

}  // namespace
}  // namespace hapticell::test
