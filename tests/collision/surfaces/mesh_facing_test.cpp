// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/mesh_facing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"

namespace hapticell::collision {
namespace {

using geometry::TriangleMesh;

TriangleMesh turned(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}
TriangleMesh joined(const std::vector<std::pair<TriangleMesh, dvec3>>& parts) {
  TriangleMesh whole;
  for (const auto& [part, p] : parts) geometry::append(whole, part, Pose::translation(p));
  return whole;
}
/// As STL has it: no vertex is shared.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (const dvec3& p : mesh.corners(t)) result.vertices.push_back(p);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}
double volumeOf(const TriangleMesh& mesh) {
  return geometry::massProperties(mesh).volume;
}
/// A square of the xy plane, facing up.
TriangleMesh square(double size) {
  const double h = 0.5 * size;
  return {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(MeshFacing, LeavesWhatIsRightToTheLastBit) {
  const TriangleMesh mesh = geometry::makeSphere(0.1, 24);
  const MeshFacing facing = facingOf(mesh);
  EXPECT_EQ(facing.mesh.triangles, mesh.triangles);
  EXPECT_EQ(facing.turned_triangles, 0u);
  EXPECT_EQ(facing.sheets, 0u);
}

TEST(MeshFacing, AClosedBodyFacesOutwardHoweverItIsWritten) {
  const TriangleMesh box = geometry::makeBox({0.4, 0.4, 0.02});
  const double volume = volumeOf(box);
  for (const TriangleMesh& mesh : {turned(box), soup(turned(box))}) {
    const MeshFacing facing = facingOf(mesh);
    EXPECT_NEAR(volumeOf(facing.mesh), volume, 1e-15);
    EXPECT_EQ(facing.bodies_turned, 1u);
    EXPECT_EQ(facing.sheets, 0u);
  }
  // Any of the triangles the wrong way: 2^12 ways.
  for (std::uint32_t bits = 0; bits < 4096; bits += 7) {
    TriangleMesh mesh = soup(box);
    for (std::uint32_t t = 0; t < 12; ++t) {
      if ((bits >> t & 1u) != 0) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    ASSERT_NEAR(volumeOf(facingOf(mesh).mesh), volume, 1e-15) << bits;
  }
}

TEST(MeshFacing, EveryBodyOfAMeshIsJudgedByItself) {
  const TriangleMesh box = geometry::makeBox({0.1, 0.1, 0.1}), ball = geometry::makeSphere(0.05, 20);
  const MeshFacing facing =
      facingOf(joined({{box, {0, 0, 0}}, {turned(ball), {0.3, 0, 0}}, {turned(box), {0.6, 0, 0}}}));
  EXPECT_NEAR(volumeOf(facing.mesh), 2.0 * volumeOf(box) + volumeOf(ball), 1e-12);
  EXPECT_EQ(facing.bodies_turned, 2u);
}

TEST(MeshFacing, ACavityStaysOneAndWhatIsInItIsSolid) {
  const TriangleMesh outer = geometry::makeBox({0.4, 0.4, 0.4}), inner = geometry::makeBox({0.2, 0.2, 0.2}),
                     part = geometry::makeBox({0.05, 0.05, 0.05});
  const double right = volumeOf(outer) - volumeOf(inner) + volumeOf(part);
  const auto cell = [&](bool out, bool in, bool own) {
    return joined(
        {{out ? outer : turned(outer), {}}, {in ? inner : turned(inner), {}}, {own ? part : turned(part), {}}});
  };
  EXPECT_NEAR(volumeOf(facingOf(cell(true, false, true)).mesh), right, 1e-12) << "as it should be";
  EXPECT_NEAR(volumeOf(facingOf(cell(false, true, false)).mesh), right, 1e-12) << "inside out as a whole";
  EXPECT_NEAR(volumeOf(facingOf(cell(true, false, false)).mesh), right, 1e-12) << "the part alone";
}

TEST(MeshFacing, ASolidWithGapsIsNoSheet) {
  TriangleMesh ball = geometry::makeSphere(0.1, 40);
  ball.triangles.erase(ball.triangles.begin() + 200);
  ball.triangles.erase(ball.triangles.begin() + 500);
  EXPECT_EQ(facingOf(ball).turned_triangles, 0u);
  const MeshFacing inverted = facingOf(turned(ball));
  EXPECT_EQ(inverted.turned_triangles, ball.triangles.size());
  EXPECT_EQ(inverted.sheets, 0u);
  // Every triangle by itself, a micrometre smaller: nothing is joined, and still it is a solid.
  TriangleMesh cracked = soup(turned(geometry::makeBox({0.1, 0.1, 0.1})));
  for (std::size_t t = 0; t < cracked.triangles.size(); ++t) {
    const dvec3 middle = (cracked.vertices[3 * t] + cracked.vertices[3 * t + 1] + cracked.vertices[3 * t + 2]) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) cracked.vertices[3 * t + k] += 1e-4 * (middle - cracked.vertices[3 * t + k]);
  }
  const MeshFacing facing = facingOf(cracked);
  EXPECT_EQ(facing.sheets, 0u);
  EXPECT_NEAR(volumeOf(facing.mesh), 1e-3, 1e-6);
}

TEST(MeshFacing, OpenSheetsAreFoundAndMadePlates) {
  TriangleMesh tray = geometry::makeBox({0.3, 0.2, 0.1});
  std::erase_if(tray.triangles, [&](const geometry::Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](auto v) { return tray.vertices[v].z > 0.049; });
  });
  const double area = 0.3 * 0.2 + 2.0 * (0.3 + 0.2) * 0.1;
  for (const TriangleMesh& mesh : {tray, turned(tray), soup(tray)}) {
    const MeshFacing facing = facingOf(mesh);
    ASSERT_EQ(facing.sheets, 1u);
    const TriangleMesh plates = withSheetsAsPlates(facing, 1e-4);
    EXPECT_TRUE(MeshCollider::build(plates)->isClosed());
    EXPECT_NEAR(volumeOf(plates), area * 1e-4, 0.01 * area * 1e-4);
  }
  const TriangleMesh plate = withSheetsAsPlates(facingOf(square(0.4)));
  EXPECT_TRUE(MeshCollider::build(plate)->isClosed());
  EXPECT_EQ(plate.triangles.size(), 2u * 2u + 2u * 4u);
  for (const auto& t : plate.triangles) {
    for (const auto v : t)
      EXPECT_NEAR(std::abs(plate.vertices[v].z), 14.1e-6, 0.1e-6) << "half of 5e-5 of the diagonal";
  }
}

TEST(MeshFacing, ABodyBesideASheetIsLeftAlone) {
  const TriangleMesh box = geometry::makeBox({0.1, 0.1, 0.1});
  const MeshFacing facing = facingOf(joined({{square(0.5), {0, 0, -0.2}}, {turned(box), {}}}));
  EXPECT_EQ(facing.sheets, 1u);
  EXPECT_EQ(facing.bodies_turned, 1u);
  EXPECT_EQ(std::count(facing.sheet_of.begin(), facing.sheet_of.end(), 0u), 2);
}

TEST(MeshFacing, AnythingIsTaken) {
  EXPECT_EQ(facingOf({}).sheets, 0u);
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 0, 1}, {0, 1, 1}}};
  EXPECT_EQ(feltMesh(flat).triangles.size(), 3u);
  // A Moebius strip of four quads faces no way at all.
  TriangleMesh strip;
  constexpr int kQuads = 12;
  for (int i = 0; i < kQuads; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kQuads, half = 0.5 * a;
    const dvec3 out(std::cos(a), std::sin(a), 0.0), across = 0.2 * (std::cos(half) * out + dvec3(0, 0, std::sin(half)));
    strip.vertices.push_back(out + across);
    strip.vertices.push_back(out - across);
  }
  for (std::uint32_t i = 0; i < kQuads; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * i + 1, last = i + 1 == kQuads ? 1u : 0u;
    const std::uint32_t c = (2 * i + 2) % (2 * kQuads) + last, d = (2 * i + 3) % (2 * kQuads) - last;
    strip.triangles.push_back({a, b, c});
    strip.triangles.push_back({b, d, c});
  }
  EXPECT_EQ(facingOf(strip).mesh.triangles, strip.triangles);
}

}  // namespace
}  // namespace hapticell::collision
