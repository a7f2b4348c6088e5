// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/obj_materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "tests/workcell/meshes/obj_text.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_reader.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ObjMaterials, ReadsKdAndSurvivesTheRest) {
  Diagnostics notes;
  const auto colors = parseObjMaterials(
      "# x\nnewmtl a b\nKa 1 1 1\nKd 0.1 0.2 0.3\nnewmtl grey\n\tKd 0.5\nnewmtl broken\nKd nan 1 1\n"
      "newmtl curve\nKd spectral x.rfl 1\nnewmtl none\nmap_Kd x.png\nnewmtl bright\nKd 7 0 0\nKd 0 0 0\n",
      notes);
  ASSERT_EQ(colors.size(), 3u);
  EXPECT_EQ(colors.at("a b"), (Color{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(colors.at("grey"), (Color{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(colors.at("bright"), (Color{1.0f, 0.0f, 0.0f}));
  EXPECT_THAT(sentences(notes), ElementsAre(HasSubstr("1 materials have a texture"), HasSubstr("2 materials")));
}

class ObjFolder : public testing::Test {
 protected:
  ObjFolder() { std::filesystem::create_directories(folder_.path() / "in/deep"); }

  std::optional<Color> colorOf(const std::string& library, std::vector<std::string>* said = nullptr) {
    folder_.write("in/part.obj", "mtllib " + library + "\nusemtl red\n" + tetrahedron(1, 0));
    Diagnostics notes;
    const auto file = readMeshParts(folder_.path() / "in/part.obj", {}, true, notes);
    EXPECT_TRUE(file.has_value());
    if (said) *said = sentences(notes);
    return file ? file->parts.at(0).color : std::nullopt;
  }

  test::TemporaryFolder folder_;
};

constexpr const char* kRed = "newmtl red\nKd 1 0 0\n";

TEST_F(ObjFolder, AMissingLibraryIsAWarning) {
  std::vector<std::string> said;
  EXPECT_FALSE(colorOf("gone.mtl", &said).has_value());
  EXPECT_THAT(said, ElementsAre(HasSubstr("the material file 'gone.mtl' is not in the same folder")));
}

TEST_F(ObjFolder, LibrariesAreFoundBesideAndBelow) {
  folder_.write("in/my colours.mtl", kRed);
  folder_.write("in/deep/b.mtl", kRed);
  folder_.write("in/none.mtl", "newmtl other\n");
  for (const char* name : {"my colours.mtl", "deep/b.mtl", "deep\\b.mtl", "none.mtl deep/b.mtl",
                           "C:\\away\\my colours.mtl", "/etc/my colours.mtl", "../my colours.mtl"}) {
    EXPECT_TRUE(isNear(colorOf(name), 1, 0, 0)) << name;
  }
}

TEST_F(ObjFolder, NothingAboveOrElsewhereIsRead) {
  folder_.write("secret.mtl", kRed);
  std::filesystem::create_directories(folder_.path() / "in/folder.mtl");
  std::filesystem::create_symlink(folder_.path() / "secret.mtl", folder_.path() / "in/link.mtl");
  std::filesystem::create_symlink("loop.mtl", folder_.path() / "in/loop.mtl");
  for (const std::string& name :
       {std::string("../secret.mtl"), (folder_.path() / "secret.mtl").string(), std::string("in/../../secret.mtl"),
        std::string("link.mtl"), std::string("loop.mtl"), std::string("folder.mtl"), std::string(".."),
        std::string("/dev/zero"), std::string(5000, 'a')}) {
    std::vector<std::string> said;
    EXPECT_FALSE(colorOf(name, &said).has_value()) << name;
    EXPECT_THAT(said, ElementsAre(HasSubstr("is not in the same folder"))) << name;
  }
}

TEST_F(ObjFolder, AnImportKeepsTreeNamesAndColoursAndADocumentReadsThemAgain) {
  folder_.write("red.mtl", kRed);
  const auto file = folder_.write(
      "two.obj", "# Units: mm\nmtllib red.mtl\no A\n" + tetrahedron(1, 0) + "o B\nusemtl red\n" + tetrahedron(5, 3));
  Diagnostics notes;
  EntityLoader loader(folder_.path());
  const auto tree = loader.loadTree(file.string(), {}, notes);
  ASSERT_TRUE(tree.has_value());
  ASSERT_EQ(tree->entities.size(), 2u);
  EXPECT_EQ(tree->entities[1].name, "B");
  EXPECT_EQ(tree->entities[1].color, (Color{1, 0, 0}));
  EXPECT_EQ(tree->entities[1].source.part, "B");
  EXPECT_TRUE(tree->report.unit_is_stated);
  EXPECT_NEAR(tree->entities[1].mesh()->bounds().min.x, 0.003, 1e-12);
  const auto again = loader.loadSource(tree->entities[1].source, notes);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->mesh()->triangles, tree->entities[1].mesh()->triangles);
  EXPECT_EQ(again->color, tree->entities[1].color);
  ImportOptions options;
  options.merge = true;
  const auto merged = loader.loadTree(file.string(), options, notes);
  ASSERT_TRUE(merged.has_value());
  ASSERT_EQ(merged->entities.size(), 1u);
  EXPECT_EQ(merged->entities[0].name, "two");
  EXPECT_EQ(merged->entities[0].mesh()->triangles.size(), 8u);
}

}  // namespace
}  // namespace hapticell::workcell
