// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <clocale>
#include <cstring>
#include <limits>
#include <utility>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "tests/workcell/meshes/mesh_text.h"
#include "workcell/meshes/length_unit.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/mesh_writer.h"

namespace hapticell::workcell {
namespace {

using geometry::TriangleMesh;
using ::testing::HasSubstr;

Expected<MeshFile> parse(const std::string& content, const char* name, Diagnostics& notes,
                         MeshReadOptions options = {}) {
  return parseMeshFile(content, name, options, notes);
}

TriangleMesh parsed(const std::string& content, const char* name, MeshReadOptions options = {}) {
  Diagnostics notes;
  const Expected<MeshFile> file = parse(content, name, notes, options);
  EXPECT_TRUE(file.has_value()) << name << ": " << (file ? "" : file.error().message());
  return file ? file->mesh : TriangleMesh{};
}

std::string refusedFile(const std::string& content, const char* name) {
  Diagnostics notes;
  const Expected<MeshFile> file = parse(content, name, notes);
  EXPECT_FALSE(file.has_value()) << name;
  return file ? "" : file.error().message();
}

/// All six encodings of one mesh.
std::vector<std::pair<const char*, std::string>> encodings(const TriangleMesh& mesh) {
  return {{"a.stl", test::stlAscii(mesh)},       {"b.stl", test::stlBinary(mesh)},
          {"c.obj", test::objText(mesh)},        {"d.off", test::offText(mesh)},
          {"e.ply", test::plyAscii(mesh)},       {"f.ply", test::plyBinary(mesh, false)},
          {"g.ply", test::plyBinary(mesh, true)}};
}

TEST(MeshReader, ReadsTheSameSolidFromEveryFormat) {
  const TriangleMesh torus = geometry::makeTorus(0.4, 0.1, 20, 12);
  const double volume = geometry::massProperties(torus).volume;
  for (const auto& [name, content] : encodings(torus)) {
    const TriangleMesh mesh = parsed(content, name);
    EXPECT_EQ(mesh.triangles.size(), torus.triangles.size()) << name;
    EXPECT_EQ(mesh.vertices.size(), torus.vertices.size()) << name;
    EXPECT_TRUE(geometry::isClosed(mesh)) << name;
    EXPECT_NEAR(geometry::massProperties(mesh).volume, volume, 1e-8) << name;
  }
}

TEST(MeshReader, TellsFormatsByContentNotByName) {
  const TriangleMesh box = geometry::makeBox(dvec3(1.0));
  EXPECT_EQ(probeMeshFormat(test::stlBinary(box, "solid but binary"), ".stl"), MeshFormat::kStlBinary);
  EXPECT_EQ(probeMeshFormat(test::stlAscii(box), ".obj"), MeshFormat::kStlAscii);
  EXPECT_EQ(probeMeshFormat(test::objText(box), ".stl"), MeshFormat::kObj);
  EXPECT_EQ(probeMeshFormat(test::plyBinary(box, true), ".bin"), MeshFormat::kPly);
  EXPECT_EQ(probeMeshFormat(test::offText(box), ""), MeshFormat::kOff);
  EXPECT_EQ(probeMeshFormat("hello world\n", ".txt"), MeshFormat::kUnknown);
}

TEST(MeshReader, ScalesAndGuessesTheUnit) {
  const TriangleMesh big = geometry::makeBox(dvec3(100.0));
  Diagnostics notes;
  const auto plain = parse(test::stlBinary(big), "part.stl", notes);
  ASSERT_TRUE(plain.has_value());
  EXPECT_NEAR(plain->mesh.bounds().size().x, 100.0, 1e-9);
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_THAT(english(notes.warnings[0]), HasSubstr("the file has no unit"));

  Diagnostics quiet;
  const auto scaled = parse(test::stlBinary(big), "part.stl", quiet, {.scale = 0.001});
  ASSERT_TRUE(scaled.has_value());
  EXPECT_NEAR(scaled->mesh.bounds().size().x, 0.1, 1e-12);
  EXPECT_TRUE(quiet.warnings.empty());
  EXPECT_EQ(guessUnit(big.bounds()), LengthUnit::kMillimetre);
  EXPECT_EQ(guessUnit(geometry::makeBox(dvec3(2.9)).bounds()), LengthUnit::kMetre);
}

TEST(MeshReader, CountsWhatWeldingDropped) {
  TriangleMesh mesh = geometry::makeBox(dvec3(1.0));
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back(mesh.triangles[3]);
  Diagnostics notes;
  const auto file = parse(test::stlAscii(mesh), "part.stl", notes);
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->triangles_in_file, 14u);
  EXPECT_EQ(file->mesh.triangles.size(), 12u);
  EXPECT_EQ(file->weld.degenerate_triangles, 1u);
  EXPECT_EQ(file->weld.duplicate_triangles, 1u);
  EXPECT_EQ(notes.warnings.size(), 2u);
}

/// Whatever is written inside out is said, body by body, and left as it is.
TEST(MeshReader, TellsOfBodiesThatFaceInward) {
  const auto inward = [](TriangleMesh mesh) {
    for (geometry::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
  };
  const TriangleMesh box = geometry::makeBox(dvec3(0.3));
  for (const auto& [name, content] : encodings(inward(box))) {
    Diagnostics notes;
    const auto file = parse(content, name, notes);
    ASSERT_TRUE(file.has_value()) << name;
    EXPECT_LT(geometry::massProperties(file->mesh).volume, 0.0) << name;
    ASSERT_EQ(notes.warnings.size(), 1u) << name;
    EXPECT_THAT(english(notes.warnings[0]), HasSubstr("face inward")) << name;
  }
  TriangleMesh several = geometry::makeBox(dvec3(0.5));
  geometry::append(several, inward(geometry::makeSphere(0.1)), Pose::translation({1.0, 0.0, 0.0}));
  geometry::append(several, inward(box), Pose::translation({-1.0, 0.0, 0.0}));
  geometry::append(several, inward(geometry::makeBox(dvec3(0.1))), {});  // A cavity: as it should be.
  Diagnostics notes;
  ASSERT_TRUE(parse(test::stlBinary(several), "several.stl", notes, {.scale = 1.0}).has_value());
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_THAT(english(notes.warnings[0]), HasSubstr("of 2 bodies face inward"));
}

TEST(MeshReader, IsIndependentOfTheLocale) {
  const char* comma = std::setlocale(LC_ALL, "de_DE.UTF-8");
  if (!comma) comma = std::setlocale(LC_ALL, "de_DE");
  const TriangleMesh mesh = parsed("v 0.5 0 0\nv 1.5 0 0\nv 0 2.25 0\nf 1 2 3\n", "a.obj");
  std::setlocale(LC_ALL, "C");
  EXPECT_NEAR(mesh.bounds().max.y, 2.25, 0.0);
  EXPECT_THAT(refusedFile("v 0,5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj"), HasSubstr("line 1: a vertex with '0,5'"));
}

TEST(StlReader, RefusesTruncatedBinary) {
  std::string bytes = test::stlBinary(geometry::makeBox(dvec3(1.0)));
  bytes.resize(bytes.size() - 30);
  const std::string message = refusedFile(bytes, "cut.stl");
  EXPECT_THAT(message, HasSubstr("cut.stl, triangle 12 of 12: the file ends after 654 bytes; expected 684 bytes"));
  EXPECT_THAT(message, HasSubstr("truncated"));
}

TEST(StlReader, RefusesACountThatDoesNotMatch) {
  std::string bytes = test::stlBinary(geometry::makeBox(dvec3(1.0)));
  bytes[80] = 3;
  EXPECT_THAT(refusedFile(bytes, "a.stl"), HasSubstr("a count of 3 triangles; expected 12"));
  bytes[80] = '\xff';
  bytes[81] = bytes[82] = bytes[83] = '\xff';
  EXPECT_THAT(refusedFile(bytes, "a.stl"), HasSubstr("of 4294967295"));
}

TEST(StlReader, NamesTheTriangleWithABadVertex) {
  TriangleMesh mesh = geometry::makeBox(dvec3(1.0));
  mesh.vertices.push_back({0.0, std::nan(""), 0.0});
  mesh.triangles[4][1] = 8;
  EXPECT_THAT(refusedFile(test::stlBinary(mesh), "nan.stl"),
              HasSubstr("nan.stl, triangle 5 of 12: a vertex with the coordinate nan"));
  EXPECT_THAT(refusedFile(test::stlAscii(mesh), "nan.stl"), HasSubstr("line 33: a vertex with the coordinate nan"));
  mesh.vertices.back() = {0.0, 0.0, -std::numeric_limits<double>::infinity()};
  EXPECT_THAT(refusedFile(test::stlBinary(mesh), "inf.stl"), HasSubstr("coordinate -inf"));
  mesh.vertices.back() = {1e30, 0.0, 0.0};
  EXPECT_THAT(refusedFile(test::stlBinary(mesh), "far.stl"), HasSubstr("e+30; expected finite"));
}

TEST(StlReader, RefusesTruncatedText) {
  const std::string text = test::stlAscii(geometry::makeBox(dvec3(1.0)));
  EXPECT_THAT(refusedFile(text.substr(0, text.rfind("endsolid")), "a.stl"), HasSubstr("the file ends"));
  EXPECT_THAT(refusedFile(text.substr(0, text.rfind("endloop")), "a.stl"), HasSubstr("the file ends too early; expected 'endloop'"));
  EXPECT_THAT(refusedFile("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2\n", "a.stl"),
              HasSubstr("the file ends inside a vertex"));
  EXPECT_THAT(refusedFile("solid\nendsolid\n", "a.stl"), HasSubstr("no triangles"));
}

TEST(StlReader, ReadsOddButValidText) {
  const std::string facet =
      "FACET NORMAL nan nan nan\r\n OUTER LOOP\r\n VERTEX +0 0 0\r\n VERTEX 1E0 0 0\r\n VERTEX 0 1 0\r\n "
      "ENDLOOP\r\nENDFACET\r\n";
  const TriangleMesh mesh = parsed(
      "solid a b c\r\n" + facet + "endsolid a b c\r\nsolid\r\n" +
          "facet normal 0 0 1\nouter loop\nvertex 5 0 0\nvertex 6 0 0\nvertex 5 1 0\nendloop\nendfacet\nendsolid",
      "a.stl");
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(ObjReader, ReadsPolygonsNegativeIndicesColoursAndContinuation) {
  const TriangleMesh mesh = parsed(
      "\xEF\xBB\xBFmtllib none.mtl\no first\n"
      "v 0 0 0 0.5 0.5 0.5\nv 3 0 0 1 1 1\nv 3 1 0 1 1 1\nv 1 1 0 1 1 1\nv 1 2 0 1 1 1\nv 0 2 0 1 1 1\n"
      "f 1/1/1 2//2 3 \\\n 4 5/5 6\n"
      "o second\nusemtl red\nv 0 0 1\nv 1 0 1 \\\n\nv 0 1 1\nf -3 -2 -1 # a comment\n",
      "a.obj");
  EXPECT_EQ(mesh.triangles.size(), 5u);
  // The L is concave: ears keep its area of 4, a fan would not.
  EXPECT_NEAR(geometry::massProperties(mesh).area, 4.5, 1e-12);
}

// Found by the fuzz target: the comment was read to beyond the text's end, or took the next line with it.
TEST(ObjReader, ACommentDoesNotGoOnBehindABackslash) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* comment : {"#\\", "#---\\", "# from C:\\"}) {
    EXPECT_EQ(parsed(std::string(comment) + "\n" + three, "a.obj").vertices.size(), 3u) << comment;
    EXPECT_EQ(parsed(three + comment, "a.obj").vertices.size(), 3u) << comment;
    Diagnostics notes;
    EXPECT_THAT(readObj(comment, notes)->mesh.vertices, testing::IsEmpty()) << comment;
  }
}

TEST(ObjReader, AcceptsAVertexAfterItsFace) {
  EXPECT_EQ(parsed("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj").triangles.size(), 1u);
}

TEST(ObjReader, RefusesWhatDoesNotFit) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_THAT(refusedFile(three + "f 1 2 4\n", "a.obj"), HasSubstr("line 4: vertex number '4'"));
  EXPECT_THAT(refusedFile(three + "f 0 1 2\n", "a.obj"), HasSubstr("line 4: face corner '0'"));
  EXPECT_THAT(refusedFile(three + "f -4 1 2\n", "a.obj"), HasSubstr("line 4: vertex number '-4'"));
  EXPECT_THAT(refusedFile(three + "f 1 2 99999999999999999999\n", "a.obj"), HasSubstr("line 4"));
  EXPECT_THAT(refusedFile("v 0 0\n" + three + "f 1 2 3\n", "a.obj"), HasSubstr("line 1: a vertex with fewer than three"));
  EXPECT_THAT(refusedFile("v 0 inf 0\n" + three + "f 1 2 3\n", "a.obj"),
              HasSubstr("line 1: a vertex with the coordinate inf"));
  EXPECT_THAT(refusedFile(std::string("\xFF\xFEv\0 \0", 6), "a.obj"), HasSubstr("UTF-16"));
  EXPECT_THAT(refusedFile("", "a.obj"), HasSubstr("empty"));
}

TEST(PlyReader, RefusesWhatDoesNotFit) {
  const TriangleMesh box = geometry::makeBox(dvec3(1.0));
  std::string text = test::plyAscii(box);
  EXPECT_THAT(refusedFile(text.substr(0, text.size() - 20), "a.ply"), HasSubstr("the file ends"));
  const std::string binary = test::plyBinary(box, false);
  EXPECT_THAT(refusedFile(binary.substr(0, binary.size() - 3), "a.ply"), HasSubstr("face 12 of 12: the file ends"));
  text.replace(text.find("vertex 8"), 8, "vertex 4000000000");
  EXPECT_THAT(refusedFile(text, "a.ply"), HasSubstr("line 4: 4000000000 elements 'vertex'"));
  EXPECT_THAT(refusedFile("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                      "end_header\n0 0 0\n",
                      "cloud.ply"),
              HasSubstr("points without faces"));
  EXPECT_THAT(
      refusedFile("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n",
              "a.ply"),
      HasSubstr("vertex 3 of 3: a vertex with the coordinate nan"));
}

TEST(PlyReader, ReadsTriangleStripsAndQuads) {
  const std::string head =
      "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n";
  const std::string points = "0 0 0\r\n1 0 0\r\n0 1 0\r\n1 1 0\r\n";
  const TriangleMesh strip = parsed(
      head + "element tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n" + points + "4 0 1 2 3\r\n",
      "a.ply");
  ASSERT_EQ(strip.triangles.size(), 2u);
  const TriangleMesh quad = parsed(
      head + "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n" + points + "4 0 1 3 2\r\n",
      "a.ply");
  ASSERT_EQ(quad.triangles.size(), 2u);
  for (const TriangleMesh& mesh : {strip, quad}) {
    for (std::uint32_t t = 0; t < 2; ++t) {
      EXPECT_GT(glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0)).z, 0.0);
    }
  }
}

TEST(OffReader, ReadsColoursAndComments) {
  const TriangleMesh mesh = parsed(
      "COFF # a comment\n# another\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n\n1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n"
      "4 0 1 2 3 0.5 0.5 0.5\n",
      "a.off");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_THAT(refusedFile("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off"), HasSubstr("line 6: face corner '3'"));
  EXPECT_THAT(refusedFile("OFF\n3 1 0\n0.000 0 0\n1.000 0 0\n", "a.off"), HasSubstr("vertex 3 of 3: the file ends"));
  EXPECT_THAT(refusedFile("OFF\n300000000 1 0\n0 0 0\n", "a.off"), HasSubstr("line 2: 300000000 vertices"));
}

TEST(MeshReader, RefusesWhatIsNoFile) {
  const test::TemporaryFolder folder;
  Diagnostics notes;
  const auto missing = readMesh(folder.path() / "none.stl", {}, notes);
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message(), HasSubstr("none.stl: the file does not exist"));
  const auto directory = readMesh(folder.path(), {}, notes);
  ASSERT_FALSE(directory.has_value());
  EXPECT_THAT(directory.error().message(), HasSubstr("a folder"));
}

TEST(MeshReader, CannotBeMadeToHangByAPolygonOfManyCorners) {
  std::string text;
  std::string face = "f";
  for (int k = 0; k < 30000; ++k) {
    text.append("v ")
        .append(std::to_string(k))
        .append(" ")
        .append(std::to_string(k % 2 == 0 ? 0 : 100000 - k))
        .append(" 0\n");
    face.append(" ").append(std::to_string(k + 1));
  }
  Diagnostics notes;
  const auto file = parse(text + face + "\n", "comb.obj", notes);
  ASSERT_TRUE(file.has_value());
  EXPECT_LE(file->mesh.triangles.size(), 29998u);
}

struct Sample {
  const char* file;
  std::uint64_t triangles;
  bool closed;
};

TEST(MeshReader, ReadsTheSharedCadFilesWithTheirCounts) {
  const Sample samples[] = {{"cad/stl/odri_transmission_pulley_at3_t30_output.stl", 19054, true},
                            {"cad/stl/odri_hip_aa_module_shell_base.stl", 77286, true},
                            {"cad/obj/industreal_gear_base.obj", 4992, true},
                            {"cad/obj/industreal_gear_small.obj", 20532, true},
                            {"cad/obj/industreal_gear_medium.obj", 35212, true}};
  for (const Sample& sample : samples) {
    HAPTICELL_SHARED_DATA_OR_SKIP(path, sample.file);
    Diagnostics notes;
    const auto file = readMeshFile(path, {}, notes);
    ASSERT_TRUE(file.has_value()) << file.error().message();
    EXPECT_EQ(file->triangles_in_file, sample.triangles) << sample.file;
    EXPECT_EQ(geometry::isClosed(file->mesh), sample.closed) << sample.file;
    for (const Text& note : notes.warnings) std::cout << sample.file << ": " << english(note) << '\n';
  }
}

TEST(MeshReader, ReadsEverySharedMesh) {
  HAPTICELL_SHARED_DATA_OR_SKIP(root, "cad");
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root.parent_path())) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".stl" && extension != ".STL" && extension != ".ply" && extension != ".obj") continue;
    Diagnostics notes;
    const auto file = readMeshFile(entry.path(), {}, notes);
    EXPECT_TRUE(file.has_value()) << file.error().message();
    if (!file) continue;
    ++read;
    // The length of a binary STL says its count; nothing of it may be lost in silence.
    if (file->format == MeshFormat::kStlBinary) {
      EXPECT_EQ(84 + 50 * file->triangles_in_file, entry.file_size());
    }
    EXPECT_EQ(file->triangles_in_file,
              file->mesh.triangles.size() + file->weld.degenerate_triangles + file->weld.duplicate_triangles);
  }
  EXPECT_GT(read, 50u);
}

/// What any bytes must give: an error in words, or a mesh whose indices and coordinates are good.
void checkOutcome(const std::string& content, const char* name) {
  Diagnostics notes;
  const auto file = parse(content, name, notes);
  if (!file) {
    RC_ASSERT(!file.error().message().empty());
    return;
  }
  RC_ASSERT(!file->mesh.triangles.empty());
  for (const auto& t : file->mesh.triangles) {
    for (std::uint32_t index : t) RC_ASSERT(index < file->mesh.vertices.size());
  }
  for (const dvec3& p : file->mesh.vertices) RC_ASSERT(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

RC_GTEST_PROP(MeshReader, SurvivesDamagedFiles, ()) {
  const TriangleMesh mesh = geometry::makePipe(0.3, 0.2, 0.5, 5);
  const auto files = encodings(mesh);
  auto [name, content] = files[*rc::gen::inRange<std::size_t>(0, files.size())];
  const auto flips = *rc::gen::inRange(0, 6);
  for (int k = 0; k < flips; ++k) {
    content[*rc::gen::inRange<std::size_t>(0, content.size())] = *rc::gen::arbitrary<char>();
  }
  if (*rc::gen::inRange(0, 3) == 0) content.resize(*rc::gen::inRange<std::size_t>(0, content.size()));
  if (*rc::gen::inRange(0, 4) == 0) {
    content.insert(*rc::gen::inRange<std::size_t>(0, content.size() + 1), *rc::gen::string<std::string>());
  }
  checkOutcome(content, name);
}

/// A soup, each corner by itself, as an STL file has it.
geometry::TriangleMesh soupOf(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh soup;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const dvec3& p : mesh.corners(t)) soup.vertices.push_back(dvec3(glm::vec3(p)));
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

TEST(StlReader, CornersAtOnePlaceAreOneVertexAndCountAsMerged) {
  // Enough triangles for several threads, and a few.
  for (const int segments : {16, 500}) {
    geometry::TriangleMesh wanted = soupOf(geometry::makeSphere(1.0, segments));
    const std::size_t corners = wanted.vertices.size();
    const std::string bytes = stlBytes(std::vector<NamedMesh>{{"a", wanted}}, 1.0);
    Diagnostics notes;
    MeshReadOptions options;
    options.warn_about_unit = false;
    const auto welded = parseMeshFile(bytes, "a.stl", options, notes);
    options.weld = false;
    const auto raw = parseMeshFile(bytes, "a.stl", options, notes);
    ASSERT_TRUE(welded && raw);
    for (std::uint32_t t = 0; t < wanted.triangles.size(); ++t) ASSERT_EQ(raw->mesh.corners(t), wanted.corners(t));
    EXPECT_LT(raw->mesh.vertices.size(), corners / 5);
    const geometry::WeldReport report = geometry::weld(wanted, geometry::weldTolerance(wanted));
    EXPECT_EQ(welded->weld.merged_vertices, report.merged_vertices);
    EXPECT_EQ(welded->weld.degenerate_triangles, report.degenerate_triangles);
    EXPECT_EQ(welded->mesh.vertices, wanted.vertices);
    EXPECT_EQ(welded->mesh.triangles, wanted.triangles);
  }
}

TEST(StlReader, TheFirstUnusableCoordinateIsNamedWhateverThreadReadsIt) {
  const geometry::TriangleMesh sphere = geometry::makeSphere(1.0, 500);
  std::string bytes = stlBytes(std::vector<NamedMesh>{{"a", sphere}}, 1.0);
  const float broken = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t triangle : {sphere.triangles.size() - 5, sphere.triangles.size() / 3}) {
    std::memcpy(&bytes[84 + 50 * triangle + 12 + 16], &broken, sizeof broken);
    Diagnostics notes;
    const auto read = parseMeshFile(bytes, "a.stl", {}, notes);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message(), HasSubstr("triangle " + std::to_string(triangle + 1) + " of"));
  }
}

}  // namespace
}  // namespace hapticell::workcell
