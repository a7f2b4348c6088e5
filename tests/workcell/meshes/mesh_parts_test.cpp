// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "tests/workcell/meshes/mesh_text.h"
#include "tests/workcell/meshes/obj_text.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::workcell {
namespace {

using geometry::TriangleMesh;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Reader = Expected<RawMesh> (*)(std::string_view, Diagnostics&);
using Materials = std::map<std::string, Color>;

std::vector<MeshPart> partsOfText(Reader reader, const std::string& text, Diagnostics& notes,
                                  const Materials& materials = {}, bool split = true) {
  Expected<RawMesh> raw = reader(text, notes);
  EXPECT_TRUE(raw.has_value()) << (raw ? "" : raw.error().message());
  return raw ? partsOf(std::move(*raw), materials, split, notes) : std::vector<MeshPart>{};
}

std::vector<std::string> namesOf(const std::vector<MeshPart>& parts) {
  std::vector<std::string> names;
  for (const MeshPart& part : parts) names.push_back(part.name);
  return names;
}

TEST(ObjParts, EveryObjectIsASolidWithItsNameAndMaterial) {
  Diagnostics notes;
  const auto parts = partsOfText(readObj,
                                 "o left bolt\nusemtl red\n" + tetrahedron(1, 0) + "o nut\nusemtl green\n" +
                                     tetrahedron(5, 3) + "o nut\n" + tetrahedron(9, 6),
                                 notes, {{"red", {1, 0, 0}}, {"green", {0, 0.5f, 0}}});
  EXPECT_THAT(namesOf(parts), ElementsAre("left bolt", "nut", "nut"));  // Two objects of one name stay two.
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_TRUE(isNear(parts[0].color, 1, 0, 0));
  EXPECT_TRUE(isNear(parts[1].color, 0, 0.5, 0));
  EXPECT_TRUE(isNear(parts[2].color, 0, 0.5, 0));  // A material stays until another is named.
  for (const MeshPart& part : parts) {
    EXPECT_EQ(part.mesh.triangles.size(), 4u);
    EXPECT_EQ(part.mesh.vertices.size(), 4u);
    EXPECT_NEAR(geometry::massProperties(part.mesh).volume, 1.0 / 6.0, 1e-12);
    EXPECT_EQ(part.assembly_number, 0u);
  }
  EXPECT_NEAR(parts[1].mesh.bounds().min.x, 3.0, 1e-12);
  EXPECT_THAT(notes.warnings, IsEmpty());
}

TEST(ObjParts, AGroupThatIsNamedAgainIsTheSame) {
  Diagnostics notes;
  const auto parts = partsOfText(
      readObj, "g a\n" + tetrahedron(1, 0) + "g b\n" + tetrahedron(5, 3) + "g a\n" + tetrahedron(9, 6), notes);
  EXPECT_THAT(namesOf(parts), ElementsAre("a", "b"));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].mesh.triangles.size(), 8u);
}

TEST(ObjParts, PatchesOfOneSkinAreOneSolid) {
  // A box whose six sides are objects of their own, as CAD programs write them; the vertices are not shared.
  const TriangleMesh box = geometry::makeBox(dvec3(1.0, 2.0, 3.0));
  std::string text = "g Housing\n";
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    if (t % 2 == 0) text += "o side" + std::to_string(t / 2) + "\n";
    for (int k = 0; k < 3; ++k) {
      const dvec3 p = box.corner(static_cast<std::uint32_t>(t), k);
      text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    text += "f -3 -2 -1\n";
  }
  text += "o lid\n" + tetrahedron(37, 9);
  Diagnostics notes;
  const auto parts = partsOfText(readObj, text, notes);
  EXPECT_THAT(namesOf(parts), ElementsAre("Housing", "lid"));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].mesh.triangles.size(), 12u);
  EXPECT_THAT(sentences(notes), ElementsAre(HasSubstr("6 objects or groups with common open edges")));
}

TEST(ObjParts, ColourOfTheVerticesGoesOverTheMaterial) {
  for (const std::string& scale : {std::string(" 0.5 0.25 1"), std::string(" 127.5 63.75 255")}) {
    Diagnostics notes;
    const auto parts = partsOfText(readObj, "usemtl red\n" + tetrahedron(1, 0, scale), notes, {{"red", {1, 0, 0}}});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_TRUE(isNear(parts[0].color, 0.5f, 0.25f, 1.0f)) << scale;
    EXPECT_EQ(parts[0].name, "");
  }
  Diagnostics notes;
  const auto weighted = partsOfText(readObj, tetrahedron(1, 0, " 1.0"), notes);
  EXPECT_FALSE(weighted.at(0).color.has_value());  // One number is a weight.
  const auto damaged = partsOfText(readObj, tetrahedron(1, 0, " 0.5 nan 1"), notes);
  EXPECT_FALSE(damaged.at(0).color.has_value());
  EXPECT_THAT(sentences(notes), ElementsAre(HasSubstr("4 vertices have an invalid colour")));
}

// Found by the fuzz target: ten tenths, each rounded, were more than one.
TEST(ObjParts, TheMeanColourOfAPolygonIsNoBrighterThanItsCorners) {
  std::string text, face = "f";
  for (int k = 1; k <= 18; ++k) {
    const double angle = 0.3 * k;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0 1 " +
            (k % 2 ? "1" : "0") + " 0\n";
    face += " " + std::to_string(k);
    if (k < 3) continue;
    Diagnostics notes;
    const auto parts = partsOfText(readObj, text + face + "\n", notes);
    ASSERT_TRUE(parts.at(0).color.has_value()) << k;
    EXPECT_LE((*parts[0].color)[0], 1.0f) << k;
    EXPECT_TRUE(isNear(parts[0].color, 1.0f, static_cast<float>((k + 1) / 2) / static_cast<float>(k), 0.0f)) << k;
  }
}

TEST(ObjParts, AnObjectOfSeveralColoursIsAnAssemblyWhereItsPiecesStandApart) {
  const std::string text = "o Motor\nusemtl grey\n" + tetrahedron(1, 0) + "usemtl black\n" + tetrahedron(5, 3);
  const Materials materials{{"grey", {0.5, 0.5, 0.5}}, {"black", {0, 0, 0}}};
  Diagnostics notes;
  const auto parts = partsOfText(readObj, text, notes, materials);
  EXPECT_THAT(namesOf(parts), ElementsAre("grey", "black"));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].assembly, "Motor");
  EXPECT_EQ(parts[1].assembly, "Motor");
  EXPECT_EQ(parts[0].assembly_number, parts[1].assembly_number);
  const auto whole = partsOfText(readObj, text, notes, materials, false);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].mesh.triangles.size(), 8u);
  EXPECT_EQ(whole[0].name, "Motor");
}

TEST(ObjParts, ASkinOfSeveralColoursHasThatOfMostOfItsArea) {
  Diagnostics notes;
  // The slanted face, of half of the square root of 3, against three of a half.
  std::string text = tetrahedron(1, 0, "", "usemtl blue\n");
  text.insert(text.find("f 2 3 4"), "usemtl red\n");
  text.insert(text.find("f 1 4 3"), "usemtl blue\n");
  const auto parts = partsOfText(readObj, text, notes, {{"red", {1, 0, 0}}, {"blue", {0, 0, 1}}});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_TRUE(isNear(parts[0].color, 0, 0, 1));
  EXPECT_THAT(sentences(notes),
              ElementsAre(HasSubstr("several colours; it is shown in the colour with the largest area")));
}

TEST(MeshParts, AScanOfManyColoursHasTheirMean) {
  // A strip of 200 squares; red rises from 0 to 1.
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 402\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 200\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (int k = 0; k <= 200; ++k) {
    for (int side = 0; side < 2; ++side) {
      text += std::to_string(k) + " " + std::to_string(side) + " 0 " + std::to_string(k) + " 51 0\n";
    }
  }
  for (int k = 0; k < 200; ++k) {
    text += "4 " + std::to_string(2 * k) + " " + std::to_string(2 * k + 2) + " " + std::to_string(2 * k + 3) + " " +
            std::to_string(2 * k + 1) + "\n";
  }
  Diagnostics notes;
  const auto parts = partsOfText(readPly, text, notes);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_TRUE(isNear(parts[0].color, 100.0f / 255.0f, 0.2f, 0.0f));
  EXPECT_THAT(sentences(notes), ElementsAre(HasSubstr("more than 64 colours")));
}

TEST(MeshParts, TooManySolidsAreOne) {
  std::string text;
  for (int k = 0; k < 10'001; ++k) {
    text += "o part" + std::to_string(k) + "\nv 0 0 " + std::to_string(k) + "\nv 1 0 " + std::to_string(k) +
            "\nv 0 1 " + std::to_string(k) + "\nf -3 -2 -1\n";
  }
  Diagnostics notes;
  const auto parts = partsOfText(readObj, text, notes);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].mesh.triangles.size(), 10'001u);
  EXPECT_THAT(sentences(notes), ElementsAre(HasSubstr("10001 solids; they were joined to one")));
}

template <typename T>
void appendNumber(std::string& bytes, T value, bool big) {
  std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
  if (big) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

/// Two triangles with a colour each, by vertex or by face; the channels are bytes, 16 bits or floats.
template <typename Channel>
std::string coloredPly(bool big, bool by_face, const char* type, const char* first, Channel full) {
  const std::string colors =
      std::string("property ") + type + " " + first + "\nproperty " + type + " green\nproperty " + type + " blue\n";
  std::string text = std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
                     " 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n" +
                     (by_face ? "" : colors) + "element face 2\nproperty list uchar int vertex_indices\n" +
                     (by_face ? colors : "") + "end_header\n";
  const auto half = static_cast<Channel>(full / 5);
  const auto paint = [&](int triangle) {
    appendNumber(text, triangle == 0 ? full : Channel{0}, big);
    appendNumber(text, Channel{0}, big);
    appendNumber(text, triangle == 0 ? Channel{0} : half, big);
  };
  for (int k = 0; k < 6; ++k) {
    for (const float c : {static_cast<float>(k % 3 == 1), static_cast<float>(k % 3 == 2), static_cast<float>(k / 3)})
      appendNumber(text, c, big);
    if (!by_face) paint(k / 3);
  }
  for (int t = 0; t < 2; ++t) {
    appendNumber(text, std::uint8_t{3}, big);
    for (int k = 0; k < 3; ++k) appendNumber(text, std::int32_t{3 * t + k}, big);
    if (by_face) paint(t);
  }
  return text;
}

void expectRedAndDarkBlue(const std::string& text) {
  Diagnostics notes;
  const auto parts = partsOfText(readPly, text, notes);
  EXPECT_THAT(namesOf(parts), ElementsAre("#ff0000", "#000033")) << text.substr(0, 60);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(isNear(parts[0].color, 1, 0, 0));
  EXPECT_TRUE(isNear(parts[1].color, 0, 0, 0.2f));
  EXPECT_THAT(notes.warnings, IsEmpty());
}

TEST(PlyParts, ReadsColoursOfVerticesAndFacesInEveryEncoding) {
  for (const bool big : {false, true}) {
    for (const bool by_face : {false, true}) {
      expectRedAndDarkBlue(coloredPly(big, by_face, "uchar", "red", std::uint8_t{255}));
      expectRedAndDarkBlue(coloredPly(big, by_face, "ushort", "diffuse_red", std::uint16_t{65535}));
      expectRedAndDarkBlue(coloredPly(big, by_face, "float", "r", 1.0f));
      expectRedAndDarkBlue(coloredPly(big, by_face, "double", "red", 255.0));
    }
  }
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property uchar alpha\nelement face 2\nproperty list uchar int vertex_index\nend_header\n";
  const std::string tail = "3 0 1 2\n3 3 4 5\n";
  expectRedAndDarkBlue(head +
                       "0 0 0 255 0 0 9\n1 0 0 255 0 0 9\n0 1 0 255 0 0 9\n"
                       "0 0 1 0 0 51 9\n1 0 1 0 0 51 9\n0 1 1 0 0 51 9\n" +
                       tail);
}

TEST(OffParts, ReadsColoursOfVerticesAndFaces) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n";
  for (const std::string& text :
       {"OFF\n6 2 0\n" + points + "3 0 1 2 255 0 0\n3 3 4 5 0 0 51 255\n",
        "OFF\n6 2 0\n" + points + "3 0 1 2 1.0 0 0 # red\n3 3 4 5 0 0 0.2 1\n",
        std::string("COFF\n6 2 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n0 0 1 0 0 51 255\n"
                    "1 0 1 0 0 51 255\n0 1 1 0 0 51 255\n3 0 1 2\n3 3 4 5\n"),
        std::string("CNOFF\n6 2 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 1 0 0 1\n0 1 0 0 0 1 1 0 0 1\n"
                    "0 0 1 0 0 1 0 0 0.2 1\n1 0 1 0 0 1 0 0 0.2 1\n0 1 1 0 0 1 0 0 0.2 1\n3 0 1 2\n3 3 4 5\n")}) {
    Diagnostics notes;
    const auto parts = partsOfText(readOff, text, notes);
    ASSERT_EQ(parts.size(), 2u) << text;
    EXPECT_TRUE(isNear(parts[0].color, 1, 0, 0)) << text;
    EXPECT_TRUE(isNear(parts[1].color, 0, 0, 0.2f)) << text;
    EXPECT_THAT(notes.warnings, IsEmpty());
  }
  Diagnostics notes;
  const auto mapped = partsOfText(readOff, "OFF\n6 2 0\n" + points + "3 0 1 2 7\n3 3 4 5 7\n", notes);
  ASSERT_EQ(mapped.size(), 1u);
  EXPECT_THAT(sentences(notes), ElementsAre(HasSubstr("2 faces have a colour by index in a colour map")));
}

TEST(MeshParts, TheSharedGearsAndPegsAreOneSolidEach) {
  for (const auto& [name, called] :
       {std::pair("industreal_gear_medium", "_GEABP1_0_40_10_B_10_b"), std::pair("industreal_gear_base", "Base"),
        std::pair("factory_round_peg_8mm_tight", "Round Peg")}) {
    HAPTICELL_SHARED_DATA_OR_SKIP(path, std::string("cad/obj/") + name + ".obj");
    Diagnostics notes;
    const auto file = readMeshParts(path, {}, true, notes);
    ASSERT_TRUE(file.has_value()) << file.error().message();
    ASSERT_EQ(file->parts.size(), 1u) << name;
    EXPECT_EQ(file->parts[0].name, called);
    EXPECT_TRUE(geometry::isClosed(file->parts[0].mesh)) << name;
  }
}

RC_GTEST_PROP(MeshParts, LoseNoTriangleWhateverTheNames, ()) {
  const int objects = *rc::gen::inRange(1, 12);
  std::string text;
  std::size_t triangles = 0;
  for (int k = 0; k < objects; ++k) {
    text += *rc::gen::element(std::string("o a\n"), std::string("g b c\n"), std::string("usemtl m\n"),
                              std::string("usemtl n\n"), std::string("\n"), std::string("g\n"), std::string("o b\n"));
    // Some share a place, so that what is the same is there twice.
    text += tetrahedron(4 * k + 1, 2.0 * *rc::gen::inRange(0, 4));
    triangles += 4;
  }
  const bool split = *rc::gen::arbitrary<bool>();
  Diagnostics notes;
  const auto parts = partsOfText(readObj, text, notes, {{"m", {1, 0, 0}}, {"n", {0, 1, 0}}}, split);
  std::size_t sum = 0;
  for (const MeshPart& part : parts) {
    RC_ASSERT(!part.mesh.triangles.empty());
    sum += part.mesh.triangles.size();
    for (const auto& t : part.mesh.triangles) {
      for (const std::uint32_t index : t) RC_ASSERT(index < part.mesh.vertices.size());
    }
  }
  RC_ASSERT(sum == triangles);
  RC_ASSERT(split || parts.size() == 1u);
}

}  // namespace
}  // namespace hapticell::workcell
