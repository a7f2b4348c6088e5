// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "workcell/meshes/byte_source.h"
#include "workcell/meshes/color_channels.h"
#include "workcell/meshes/mesh_pieces.h"
#include "workcell/meshes/polygon_soup.h"
#include "workcell/meshes/shared_corners.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <typename T>
std::string rawBytes(T value, bool is_turned) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return is_turned ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

RC_GTEST_PROP(ByteSource, NumbersAreReadInEitherOrder, (std::uint16_t a, std::int32_t b, double c)) {
  const bool is_big = std::endian::native == std::endian::big;
  RC_ASSERT(readNumber<std::uint16_t>(rawBytes(a, is_big), std::endian::little) == a);
  RC_ASSERT(readNumber<std::uint16_t>(rawBytes(a, !is_big), std::endian::big) == a);
  RC_ASSERT(readNumber<std::int32_t>(rawBytes(b, !is_big), std::endian::big) == b);
  RC_ASSERT(std::bit_cast<std::uint64_t>(readNumber<double>(rawBytes(c, !is_big), std::endian::big)) ==
            std::bit_cast<std::uint64_t>(c));
  RC_ASSERT(readNumber<std::uint8_t>("\x7f"
                                     "rest",
                                     std::endian::big) == 0x7f);
}

RC_GTEST_PROP(SharedCorners, NumbersAreThoseOfAMap, (std::vector<std::uint8_t> from)) {
  std::vector<dvec3> points;
  for (const std::uint8_t k : from) points.emplace_back(k % 5, k % 3, k % 2 == 0 ? 0.0 : -0.0);
  std::vector<std::uint32_t> numbers(points.size());
  SharedCorners many, one;
  many.add(points, numbers.data());
  std::vector<dvec3> wanted;  // In the order of their first corners; +0 and -0 differ.
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto same = [&](const dvec3& p) { return std::memcmp(&p, &points[k], sizeof p) == 0; };
    const auto known = std::find_if(wanted.begin(), wanted.end(), same);
    RC_ASSERT(numbers[k] == static_cast<std::uint32_t>(known - wanted.begin()));
    RC_ASSERT(one.add(points[k]) == numbers[k]);
    if (known == wanted.end()) wanted.push_back(points[k]);
  }
  RC_ASSERT(many.vertices().size() == wanted.size());
  RC_ASSERT(many.vertices() == one.vertices());
  // Different places behind them, some known: found together, then added, as the second half of a file is.
  const std::vector<dvec3> behind{{0, 0, 0.0}, {7, 0, 0}, {1, 1, -0.0}, {8, 0, 0}};
  std::array<std::uint32_t, 4> found{}, added{};
  many.find(behind, found.data());
  for (const bool last : {false, true}) {
    SharedCorners all;
    all.add(points, numbers.data());
    added = found;
    all.addMissing(behind, added.data(), last);
    SharedCorners by_one;
    for (const dvec3& p : points) by_one.add(p);
    for (std::size_t k = 0; k < behind.size(); ++k) RC_ASSERT(added[k] == by_one.add(behind[k]));
    RC_ASSERT(all.take() == by_one.take());
  }
}

TEST(ColorChannels, TheGreatestNumberTellsTheRange) {
  ColorChannels bytes, shares;
  bytes.set(1, {255, 0, 51});
  shares.set(0, {1.0, 0.0, 0.2});
  const auto of_bytes = std::move(bytes).take(3, {}), of_shares = std::move(shares).take(1, {});
  ASSERT_EQ(of_bytes.size(), 3u);
  EXPECT_FALSE(isColor(of_bytes[0]) || isColor(of_bytes[2])) << "those that got none";
  EXPECT_NEAR(of_bytes[1][2], 0.2f, 1e-6f);
  EXPECT_NEAR(of_shares[0][2], 0.2f, 1e-6f);
  ColorChannels stated;
  stated.set(0, {128, 65535, 70000});
  const auto of_words = std::move(stated).take(1, 65535.0);
  EXPECT_EQ(of_words[0][1], 1.0f);
  EXPECT_EQ(of_words[0][2], 1.0f) << "cut";
  EXPECT_TRUE(std::move(*std::make_unique<ColorChannels>()).take(5, {}).empty()) << "no element has one";
}

TEST(ColorChannels, WhatIsNoColourIsCounted) {
  ColorChannels channels;
  Diagnostics diagnostics;
  channels.report(ColorChannels::Of::kVertices, diagnostics);
  EXPECT_TRUE(diagnostics.warnings.empty());
  channels.set(0, {-0.1, 0, 0});
  channels.set(1, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  channels.set(2, {std::numeric_limits<double>::infinity(), 0, 0});
  channels.report(ColorChannels::Of::kVertices, diagnostics);
  ASSERT_EQ(diagnostics.warnings.size(), 1u);
  EXPECT_THAT(english(diagnostics.warnings[0]), HasSubstr("3 vertices"));
}

TEST(ColorChannels, TheMeanIsNoneWhereACornerHasNone) {
  const std::vector<Color> both{{1, 0, 0}, {0, 0.5f, 0}}, with_none{{1, 0, 0}, kNoColor};
  EXPECT_EQ(meanColor(both), (Color{0.5f, 0.25f, 0.0f}));
  EXPECT_FALSE(isColor(meanColor(with_none)));
}

/// n corners round a circle, as a polygon of a soup.
PolygonSoup ringSoup(int corners) {
  PolygonSoup soup;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners;
    soup.vertices.push_back({std::cos(angle), std::sin(angle), 2.0});
    soup.corners.push_back(static_cast<std::uint32_t>(i));
  }
  soup.closePolygon();
  return soup;
}

double areaOfSoup(const geometry::TriangleMesh& mesh) {
  double area = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    area += 0.5 * glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0)).z;
  }
  return area;
}

TEST(PolygonSoup, ConvexAndConcavePolygonsKeepTheirAreaAndTurn) {
  Diagnostics diagnostics;
  const auto ring = triangulate(ringSoup(12), diagnostics);
  ASSERT_TRUE(ring);
  EXPECT_EQ(ring->mesh.triangles.size(), 10u);
  EXPECT_NEAR(areaOfSoup(ring->mesh), 6.0 * std::sin(6.283185307179586 / 12), 1e-12);
  PolygonSoup arrow;  // concave: an arrow's head
  arrow.vertices = {{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}};
  arrow.corners = {0, 1, 2, 3};
  arrow.closePolygon();
  arrow.labels = {0};
  arrow.face_colors = {{0.1f, 0.2f, 0.3f}};
  const auto cut = triangulate(arrow, diagnostics);
  ASSERT_TRUE(cut);
  ASSERT_EQ(cut->mesh.triangles.size(), 2u);
  EXPECT_NEAR(areaOfSoup(cut->mesh), 1.0, 1e-12);
  for (std::uint32_t t = 0; t < 2; ++t) {
    EXPECT_GT(
        glm::cross(cut->mesh.corner(t, 1) - cut->mesh.corner(t, 0), cut->mesh.corner(t, 2) - cut->mesh.corner(t, 0)).z,
        0.0)
        << "none lies over the notch";
  }
  EXPECT_EQ(cut->label.size(), 2u);
  EXPECT_EQ(cut->color.at(1), (Color{0.1f, 0.2f, 0.3f}));
  EXPECT_TRUE(diagnostics.warnings.empty());
}

TEST(PolygonSoup, WhatIsNoPolygonIsDroppedOrNamed) {
  Diagnostics diagnostics;
  PolygonSoup soup = ringSoup(4);
  soup.corners.insert(soup.corners.end(), {0, 1});
  soup.closePolygon();
  const auto dropped = triangulate(soup, diagnostics);
  ASSERT_TRUE(dropped);
  EXPECT_EQ(dropped->mesh.triangles.size(), 2u);
  EXPECT_EQ(diagnostics.warnings.size(), 1u);
  soup.corners.insert(soup.corners.end(), {0, 1, 99});
  soup.closePolygon();
  const auto broken = triangulate(soup, diagnostics);
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message(), HasSubstr("3"));
  EXPECT_TRUE(triangulate({}, diagnostics)->mesh.triangles.empty());
}

/// Two triangles of 0.5 and 2 m2 that share no corner, and a third that shares an edge with the second.
RawMesh threeTriangles() {
  RawMesh raw;
  raw.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {7, 0, 0}, {5, 2, 0}, {7, 2, 0}};
  raw.mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {4, 6, 5}};
  return raw;
}

TEST(MeshPieces, NamesAndColoursMakePieces) {
  RawMesh raw = threeTriangles();
  EXPECT_EQ(piecesOf(raw, {}).pieces.size(), 1u) << "nothing has a name or a colour";
  EXPECT_TRUE(piecesOf(raw, {}).piece.empty());
  raw.labels = {{1, "left", "", "red"}, {2, "right", "", "red"}};
  raw.label = {0, 1, 1};
  raw.color = {kNoColor, kNoColor, {0, 0, 1}};
  const MeshPieces pieces = piecesOf(raw, {{"red", {1, 0, 0}}});
  EXPECT_THAT(pieces.piece, ElementsAre(0u, 1u, 2u));
  EXPECT_EQ(pieces.pieces[1].color, (Color{1, 0, 0})) << "of its material";
  EXPECT_EQ(pieces.pieces[2].color, (Color{0, 0, 1})) << "its own goes over that";
  EXPECT_NEAR(pieces.pieces[0].area, 0.5, 1e-12);
  EXPECT_NEAR(pieces.pieces[1].area, 2.0, 1e-12);
  EXPECT_FALSE(pieces.many_colors);
  EXPECT_THAT(solidsOf(raw.mesh, pieces), ElementsAre(0u, 1u, 1u)) << "the last two hang together";
}

TEST(MeshPieces, TooManyColoursAreNotToldApart) {
  RawMesh raw;
  for (std::uint32_t i = 0; i < 70; ++i) {
    const auto at = static_cast<std::uint32_t>(raw.mesh.vertices.size());
    const double x = 3.0 * i;
    raw.mesh.vertices.insert(raw.mesh.vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    raw.mesh.triangles.push_back({at, at + 1, at + 2});
    raw.color.push_back({static_cast<float>(i) / 70.0f, 0.0f, 0.0f});
  }
  const MeshPieces pieces = piecesOf(raw, {});
  EXPECT_TRUE(pieces.many_colors);
  ASSERT_EQ(pieces.pieces.size(), 1u);
  EXPECT_NEAR(pieces.pieces[0].colored_area, 35.0, 1e-9);
  EXPECT_NEAR(pieces.pieces[0].color_sum[0] / 35.0, 34.5 / 70.0, 1e-6) << "the mean by area";
}

}  // namespace
}  // namespace hapticell::workcell
