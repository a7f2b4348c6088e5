// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_cell_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/test_data.h"
#include "workcell/scenes/sdf_shapes.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTable =
    "<sdf version='1.6'><model name='table'><pose>0 0 1 0 0 0</pose><link name='l'><pose>1 0 0 0 0 1.5707963267948966"
    "</pose><visual name='top'><pose>0 2 0 0 0 0</pose><geometry><box><size>1 2 3</size></box></geometry><material>"
    "<diffuse>1 0.5 0 1</diffuse></material></visual></link></model></sdf>";

TEST(SdfCell, PlacesModelsLinksAndShapes) {
  test::TemporaryFolder folder;
  folder.write("models/table/model.sdf", kTable);
  const auto file = folder.write("worlds/w.world",
                                 "<sdf version='1.6'><world name='w'><include><name>mine</name><uri>model://table</uri>"
                                 "<pose>10 0 0 0 0 0</pose></include><include><uri>model://table</uri></include>"
                                 "<include><uri>model://gone</uri></include><model name='ball'><link name='l'>"
                                 "<collision name='c'><geometry><sphere><radius>0.5</radius></sphere></geometry>"
                                 "</collision></link></model></world></sdf>");
  ASSERT_TRUE(isSdfCell(file));
  const auto scene = readScene(file, {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->nodes.size(), 6u);
  const std::vector<Pose> X_W = nodePoses(*scene);
  EXPECT_EQ(scene->nodes[0].name, "mine");
  EXPECT_EQ(scene->nodes[1].name, "top");
  EXPECT_NEAR(glm::distance(X_W[1].p, dvec3(10 + 1 - 2, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(X_W[3].p, dvec3(-1, 0, 1)), 0.0, 1e-12);  // The model's own pose, where none is given.
  EXPECT_EQ(scene->nodes[1].color, (std::array<float, 3>{1.0f, 0.5f, 0.0f}));
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_THAT(english(scene->warnings[0]), HasSubstr("model://gone"));
}

TEST(SdfCell, TellsARobotFromACell) {
  test::TemporaryFolder folder;
  const std::string joint = "<joint name='j' type='revolute'/>", fixed = "<joint name='j' type='fixed'/>";
  EXPECT_FALSE(isSdfCell(folder.write("a.sdf", "<sdf><model name='m'>" + joint + "</model></sdf>")));
  EXPECT_TRUE(isSdfCell(folder.write("b.sdf", "<sdf><model name='m'>" + fixed + "</model></sdf>")));
  EXPECT_FALSE(isSdfCell(folder.write("c.sdf", "rubbish")));
  EXPECT_FALSE(isSdfCell(folder.path() / "none.sdf"));
}

TEST(SdfCell, AModelOfModelsIsACellThoughAJointLiesBetweenThem) {
  test::TemporaryFolder folder;
  const std::string box =
      "<link name='l'><visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link>";
  const auto file = folder.write(
      "belt.sdf", "<sdf version='1.6'><model name='belt'><model name='fixed'>" + box +
                      "</model><model name='moving'><pose>0 0 2 0 0 0</pose>" + box +
                      "</model><joint name='j' type='prismatic'><parent>fixed::l</parent><child>moving::l</child>"
                      "</joint></model></sdf>");
  ASSERT_TRUE(isSdfCell(file));
  const auto scene = readScene(file, {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->nodes.size(), 5u);  // The belt, two models, a shape in each.
  EXPECT_EQ(nodePoses(*scene).back().p, dvec3(0, 0, 2));
  ASSERT_FALSE(scene->warnings.empty());
  EXPECT_THAT(english(scene->warnings[0]), HasSubstr("'belt' has moving joints"));
  EXPECT_TRUE(holdsScene(file));
}

TEST(SdfCell, LivesWithWhatIsWrong) {
  test::TemporaryFolder folder;
  const auto read = [&](const std::string& inside) {
    return readSdfCell(folder.write("w.world", "<sdf><world name='w'>" + inside + "</world></sdf>"), nullptr);
  };
  const auto shortPose = read("<model name='m'><pose>1 2</pose></model>");
  ASSERT_TRUE(shortPose);
  EXPECT_EQ(shortPose->nodes[0].X_PN.p, dvec3(1, 2, 0));
  EXPECT_THAT(english(shortPose->warnings.at(0)), HasSubstr("2 numbers instead of 6"));
  folder.write("loop/model.sdf", "<sdf><model name='loop'><include><uri>model://loop</uri></include></model></sdf>");
  const auto loop = read("<include><uri>model://loop</uri></include>");
  ASSERT_TRUE(loop);
  EXPECT_LT(loop->nodes.size(), 100u);
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += "<model>";
  EXPECT_FALSE(read(deep));
  EXPECT_FALSE(readSdfCell(folder.write("x.world", "<sdf><world"), nullptr));
}

TEST(SdfCell, TheAriacWorldStands) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/workcell_ariac/worlds/ariac.world");
  const auto scene = readScene(file, {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  const auto named = [&](const std::string& name) {
    return std::any_of(scene->nodes.begin(), scene->nodes.end(), [&](const SceneNode& n) { return n.name == name; });
  };
  for (const char* name : {"part_disposal_bin", "bin1", "bin8"}) EXPECT_TRUE(named(name)) << name;
  EXPECT_GT(scene->meshes.size(), 5u);
  EXPECT_THAT(english(scene->warnings), HasSubstr("model://warehouse"));
}

TEST(SdfShapes, AMeshIsReadInGazebosAxesAndAMirroredOneKeepsItsOutside) {
  test::TemporaryFolder folder;
  folder.write(
      "w.stl",
      "solid w\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 2 0\nvertex 1 0 0\nendloop\nendfacet\n"
      "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 3\nendloop\nendfacet\n"
      "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 3\nvertex 0 2 0\nendloop\nendfacet\n"
      "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 2 0\nvertex 0 0 3\nendloop\nendfacet\nendsolid w\n");
  const auto file = folder.write(
      "m.sdf",
      "<sdf version='1.6'><model name='m'><link name='l'><visual name='a'><geometry><mesh><uri>w.stl</uri><scale>1 1 -1"
      "</scale></mesh></geometry></visual><visual name='b'><geometry><cylinder><radius>0.5</radius><length>2</length>"
      "</cylinder></geometry></visual></link></model></sdf>");
  EXPECT_EQ(asGazeboDoes().up_axis, UpAxis::kZ) << "Collada's own axis is not heeded";
  const auto source = SdfSource::load(file, nullptr);
  ASSERT_TRUE(source) << source.error().message();
  ASSERT_EQ(source->models().size(), 1u);
  ASSERT_EQ(source->meshFiles().size(), 1u);
  EXPECT_EQ(source->meshFiles()[0].uri, "w.stl");
  const auto& visuals = source->models()[0].links.at(0).visuals;
  ASSERT_EQ(visuals.size(), 2u);
  SdfShapes shapes(*source, asGazeboDoes(), nullptr);
  const auto volumeOf = [](const geometry::TriangleMesh& mesh) {
    double volume = 0.0;
    for (const auto& t : mesh.triangles)
      volume += glm::dot(mesh.vertices[t[0]], glm::cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
    return volume;
  };
  const auto wedge = shapes.meshOf(visuals[0], "m");
  ASSERT_TRUE(wedge);
  EXPECT_NEAR(volumeOf(*wedge), 1.0, 1e-6) << "1 x 2 x 3 / 6, outside out though mirrored";
  EXPECT_NEAR(wedge->bounds().min.z, -3.0, 1e-6);
  EXPECT_EQ(shapes.meshOf(visuals[0], "again"), wedge) << "read once";
  const auto cylinder = shapes.meshOf(visuals[1], "m");
  ASSERT_TRUE(cylinder);
  EXPECT_NEAR(cylinder->bounds().max.z - cylinder->bounds().min.z, 2.0, 1e-9);
  EXPECT_FALSE(shapes.isCancelled());
}

}  // namespace
}  // namespace hapticell::workcell
