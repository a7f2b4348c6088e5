// SPDX-License-Identifier: Apache-2.0
// The readers and the writer of CAD files, part by part, against OpenCASCADE and against geometry.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <fstream>
#include <gp_Ax1.hxx>
#include <gp_Sphere.hxx>
#include <gp_Trsf.hxx>
#include <numbers>

#include "geometry/shapes/shapes.h"
#include "importer/cad_document.h"
#include "importer/cad_reader.h"
#include "importer/faceted_shape.h"
#include "importer/reading.h"
#include "importer/shape_mesher.h"
#include "importer/step_text.h"
#include "importer/step_writer.h"
#include "tests/importer/enclosed_volume.h"
#include "tests/importer/parent_ends.h"
#include "tests/support/test_data.h"

namespace hapticell::importer {
namespace {

namespace fs = std::filesystem;
using geometry::TriangleMesh;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using test::enclosedVolume;
using test::ParentEnds;
using test::TemporaryFolder;

TEST(FacetedShape, AClosedMeshIsASolidOfItsVolume) {
  const TopoDS_Shape solid = facetedShape(geometry::makeBox({0.1, 0.2, 0.3}));
  ASSERT_FALSE(solid.IsNull());
  EXPECT_EQ(solid.ShapeType(), TopAbs_SOLID);
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  EXPECT_NEAR(properties.Mass(), 100.0 * 200.0 * 300.0, 1e-3) << "in millimetres, outside out";
  TriangleMesh open = geometry::makeBox({0.1, 0.2, 0.3});
  open.triangles.pop_back();
  EXPECT_EQ(facetedShape(open).ShapeType(), TopAbs_SHELL);
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_TRUE(facetedShape(flat).IsNull());
}

TEST(ShapeMesher, GivesBackTheBoxThatTheShapeWasMadeOf) {
  const TopoDS_Shape shape = facetedShape(geometry::makeBox({0.1, 0.2, 0.3}));
  const MeshedShape meshed = meshShape(shape, 1.0, {}, {});
  EXPECT_EQ(meshed.faces, 12);
  EXPECT_EQ(meshed.missing_faces, 0);
  EXPECT_FALSE(meshed.color);
  EXPECT_NEAR(enclosedVolume(meshed.mesh), 0.1 * 0.2 * 0.3, 1e-12);
  EXPECT_NEAR(enclosedVolume(meshShape(shape, 2.0, {}, {}).mesh), 8.0 * 0.1 * 0.2 * 0.3, 1e-12);
}

TEST(ShapeMesher, TakesTheColourOfTheLargestArea) {
  const TopoDS_Shape shape = facetedShape(geometry::makeBox({0.1, 0.2, 0.3}));
  FaceColors colors;
  // 2 * 0.06 m2 to the left and right, 2 * 0.02 + 2 * 0.03 m2 on the other sides.
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    GProp_GProps surface;
    BRepGProp::SurfaceProperties(faces.Current(), surface);
    const bool is_side = std::abs(surface.CentreOfMass().X()) > 49.0;
    colors.Bind(faces.Current(), is_side ? Quantity_Color(0.25, 0.5, 0.75, Quantity_TOC_sRGB)
                                         : Quantity_Color(1.0, 0.0, 0.0, Quantity_TOC_sRGB));
  }
  const MeshedShape meshed = meshShape(shape, 1.0, {}, colors);
  EXPECT_TRUE(meshed.several_colors);
  ASSERT_TRUE(meshed.color);
  EXPECT_NEAR((*meshed.color)[0], 0.25f, 1e-5f);
  EXPECT_NEAR((*meshed.color)[1], 0.5f, 1e-5f);
  EXPECT_NEAR((*meshed.color)[2], 0.75f, 1e-5f);
}

TEST(ShapeMesher, KeepsTheChordOnASphere) {
  const TopoDS_Shape sphere = BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 100.0), 0.0, 2.0 * std::numbers::pi,
                                                      -0.5 * std::numbers::pi, 0.5 * std::numbers::pi)
                                  .Shape();
  std::size_t before = 0;
  for (const double chord : {4e-3, 1e-3}) {
    const MeshedShape meshed = meshShape(sphere, 1.0, {.chord = chord, .angle = 3.0}, {});
    double farthest = 0.0;
    for (const auto& t : meshed.mesh.triangles) {
      const dvec3 &a = meshed.mesh.vertices[t[0]], &b = meshed.mesh.vertices[t[1]], &c = meshed.mesh.vertices[t[2]];
      for (const dvec3& corner : {a, b, c}) EXPECT_NEAR(glm::length(corner), 0.1, 1e-9);
      farthest = std::max(farthest, 0.1 - glm::length((a + b + c) / 3.0));
    }
    EXPECT_LE(farthest, chord);
    EXPECT_GT(farthest, 0.1 * chord) << "no finer than asked for";
    EXPECT_GT(meshed.mesh.triangles.size(), before);
    before = meshed.mesh.triangles.size();
  }
}

TEST(CadDocument, APlacementHasItsPoseInMetres) {
  gp_Trsf placement;
  placement.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.5 * std::numbers::pi);
  placement.SetTranslationPart(gp_Vec(10, 20, 30));
  const Pose X = poseOf(TopLoc_Location(placement), 1.0);
  EXPECT_LT(glm::distance(X.p, dvec3(0.01, 0.02, 0.03)), 1e-15);
  EXPECT_LT(glm::distance(X.q * dvec3(1, 0, 0), dvec3(0, 1, 0)), 1e-12);
  EXPECT_NEAR(glm::length(X.q), 1.0, 1e-15);
  EXPECT_LT(glm::distance(poseOf(TopLoc_Location(placement), 25.4).p, 25.4 * X.p), 1e-14);
}

TEST(CadDocument, CountsATreeBeforeItIsUnfolded) {
  const CadDocument cad = newCadDocument();
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(cad.document->Main());
  TDF_Label below = shapes->AddShape(facetedShape(geometry::makeBox({0.1, 0.2, 0.3})), false);
  const auto twiceInOneMore = [&] {
    const TDF_Label around = shapes->NewShape();
    for (int k = 0; k < 2; ++k) shapes->AddComponent(around, below, TopLoc_Location());
    below = around;
  };
  for (int level = 0; level < 5; ++level) twiceInOneMore();
  ASSERT_TRUE(checkTree(cad));
  const std::vector<CadNode> tree = treeOf(cad, "doubled");
  EXPECT_EQ(tree.size(), 63u) << "1 + 2 + 4 + 8 + 16 assemblies and 32 parts";
  EXPECT_EQ(std::count_if(tree.begin(), tree.end(), [](const CadNode& node) { return node.assembly; }), 31);
  EXPECT_EQ(tree[0].name, "doubled");
  for (std::size_t k = 1; k < tree.size(); ++k) EXPECT_LT(tree[k].parent, static_cast<int>(k));
  for (int level = 5; level < 40; ++level) twiceInOneMore();
  EXPECT_FALSE(checkTree(cad)) << "2 to the 40 parts";
}

/// Two uses of one box below an assembly, one of them named otherwise.
workcell::ImportedScene twoBoxes() {
  workcell::ImportedScene scene;
  scene.meshes.push_back(geometry::makeBox({0.1, 0.2, 0.3}));
  scene.nodes.resize(3);
  scene.nodes[0].name = "frame";
  scene.nodes[1].name = "left";
  scene.nodes[2].name = "right";
  for (const std::size_t k : {1u, 2u}) {
    scene.nodes[k].parent = 0;
    scene.nodes[k].mesh = 0;
    scene.nodes[k].color = std::array<float, 3>{1.0f, 0.5f, 0.0f};
  }
  scene.nodes[2].X_PN = {{1.0, 2.0, 3.0}, quaternionFromRotationVector({0.0, 0.0, 0.5 * std::numbers::pi})};
  return scene;
}

TEST(StepWriter, WhatItWritesIsReadBackWithNamesPlacesAndColours) {
  const TemporaryFolder folder;
  ParentEnds ends;
  ParentLink parent;
  const fs::path file = folder.path() / "two.step";
  ASSERT_TRUE(writeStep(twoBoxes(), file, parent));

  const auto cad = openCad(file, [](double, const Text&) {});
  ASSERT_TRUE(cad) << cad.error().message();
  EXPECT_EQ(cad->format, "step");
  EXPECT_DOUBLE_EQ(cad->metres_per_unit, 1e-3);
  EXPECT_TRUE(cad->unit_is_stated);
  ASSERT_TRUE(checkTree(*cad));
  const std::vector<CadNode> tree = treeOf(*cad, "two");
  ASSERT_EQ(tree.size(), 3u);
  EXPECT_EQ(tree[0].name, "frame");
  EXPECT_TRUE(tree[0].assembly);
  EXPECT_EQ(tree[1].parent, 0);
  EXPECT_TRUE(tree[1].definition.IsEqual(tree[2].definition)) << "the shape is written once";
  EXPECT_THAT(nameOf(tree[1].definition), StartsWith(kSharedPart));

  Reading reading;
  reading.file = file;
  const auto scene = readCad(reading, parent);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->nodes.size(), 3u);
  ASSERT_EQ(scene->meshes.size(), 1u);
  EXPECT_NEAR(enclosedVolume(scene->meshes[0]), 0.006, 1e-9);
  EXPECT_EQ(scene->nodes[1].name, "left");
  EXPECT_EQ(scene->nodes[2].name, "right");
  EXPECT_LT(glm::distance(scene->nodes[2].X_PN.p, dvec3(1, 2, 3)), 1e-9);
  EXPECT_LT(glm::distance(scene->nodes[2].X_PN.q * dvec3(1, 0, 0), dvec3(0, 1, 0)), 1e-9);
  ASSERT_TRUE(scene->nodes[1].color);
  EXPECT_NEAR((*scene->nodes[1].color)[1], 0.5f, 0.01f);
  EXPECT_THAT(ends.lines(), HasSubstr("progress "));
  reading.skipped = {1};
  EXPECT_FALSE(readCad(reading, parent)) << "nothing is left without its only shape";
  reading.skipped.clear();
  reading.metres_per_unit = 2e-3;  // Twice the file's millimetre.
  const auto doubled = readCad(reading, parent);
  ASSERT_TRUE(doubled) << doubled.error().message();
  EXPECT_NEAR(enclosedVolume(doubled->meshes.at(0)), 8.0 * 0.006, 1e-9);
  EXPECT_LT(glm::distance(doubled->nodes[2].X_PN.p, dvec3(2, 4, 6)), 1e-9);
  reading.file = folder.write("no.step", "ISO-10303-21;\nrubbish");
  EXPECT_FALSE(readCad(reading, parent));
}

TEST(StepText, IsRecognisedByItsBeginning) {
  EXPECT_TRUE(beginsAsStep("ISO-10303-21;"));
  EXPECT_TRUE(beginsAsStep("\xEF\xBB\xBF /* made by hand */\nISO-10303-21;"));
  EXPECT_FALSE(beginsAsStep("solid ISO-10303-21;"));
  EXPECT_FALSE(beginsAsStep(""));
}

TEST(StepText, NamesComeInUtf8WhateverTheyWereWrittenIn) {
  EXPECT_EQ(guessEncoding({"caf\xE9", "gar\xE7on"}), "ISO-8859-1");
  EXPECT_EQ(guessEncoding({"caf\xC3\xA9"}), "UTF-8");
  EXPECT_EQ(guessEncoding({"\x95\x94\x95\x69"}), "SHIFT_JIS") << "buhin, parts: JIS X 0208";
  EXPECT_EQ(guessEncoding({"\xC1\xE3\xBC\xFE"}), "GB18030") << "lingjian, parts: GB 2312";
  const std::string text = "ISO-10303-21;\nDATA;\n#1=PRODUCT('caf\xE9','','',(#2));\nENDSEC;\nEND-ISO-10303-21;\n";
  const StepOutline outline = outlineOfStep(text);
  EXPECT_EQ(outline.exact_faces, 0u);
  ASSERT_EQ(outline.raw.size(), 1u);
  EXPECT_THAT(text.substr(outline.raw[0].first, outline.raw[0].second), HasSubstr("\xE9"));
  const TemporaryFolder folder;
  const auto opened = StepText::open(folder.write("a.step", text));
  ASSERT_TRUE(opened) << opened.error().message();
  std::ifstream in(opened->name());
  const std::string read{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(read, HasSubstr("'caf\xC3\xA9'"));
  EXPECT_FALSE(opened->warnings().empty()) << "it is said what they were taken for";
  EXPECT_FALSE(StepText::open(folder.path() / "none.step"));
}

TEST(StepText, CountsWhatIsExactAndWhatIsTessellated) {
  const std::string both =
      "ISO-10303-21;\nDATA;\n#1=ADVANCED_FACE('ADVANCED_FACE',(#2),#3,.T.);\n/* ADVANCED_FACE */\n"
      "#4=TESSELLATED_SOLID('',(#5),#1);\n#6=TESSELLATED_SHELL('',(#7),$);\n#8=KINEMATIC_JOINT();\n";
  const StepOutline outline = outlineOfStep(both);
  EXPECT_EQ(outline.exact_faces, 1u) << "not in a text, not in a comment";
  EXPECT_EQ(outline.tessellated, 1u) << "one of the two has an exact shape behind it";
  EXPECT_EQ(outline.joints, 1u);
  const TemporaryFolder folder;
  const auto refused = StepText::open(folder.write("t.step", "ISO-10303-21;\n#6=TESSELLATED_SHELL('',(#7),$);\n"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("only tessellated shapes"));
}

}  // namespace
}  // namespace hapticell::importer
