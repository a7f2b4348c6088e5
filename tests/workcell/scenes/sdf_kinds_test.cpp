// SPDX-License-Identifier: Apache-2.0
// What strangers' SDF files hold beside boxes: places by hand or plain arithmetic.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/shapes/mass_properties.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_writer.h"
#include "workcell/robots/robot_reader.h"
#include "workcell/scenes/sdf_cell_reader.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;

constexpr const char* kBox = "<geometry><box><size>1 1 0.1</size></box></geometry>";

std::string shape(const std::string& geometry) {
  return "<visual name='v'><geometry>" + geometry + "</geometry></visual>";
}

std::string link(const std::string& name) {
  return "<link name='" + name + "'><collision name='c'>" + kBox + "</collision></link>";
}

std::string joint(const std::string& type, const std::string& axes, const std::string& parent = "base") {
  return "<joint name='j' type='" + type + "'><parent>" + parent + "</parent><child>arm</child>" + axes + "</joint>";
}

std::string axis(const std::string& xyz, const std::string& limit, const char* name = "axis") {
  return "<" + std::string(name) + "><xyz>" + xyz + "</xyz><limit>" + limit + "</limit></" + name + ">";
}

/// Two boxes as Collada: "Base" 1 x 1 x 0.1 m at the origin, "Post" 0.2 x 0.2 x 1.9 m on it.
std::string colladaOfTwo() {
  const auto geometry = [](const std::string& name, const std::string& points) {
    return "<geometry id='" + name + "' name='" + name + "'><mesh><source id='" + name + "-p'><float_array id='" +
           name + "-a' count='24'>" + points + "</float_array><technique_common><accessor source='#" + name +
           "-a' count='8' stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' "
           "type='float'/></accessor></technique_common></source><vertices id='" +
           name + "-v'><input semantic='POSITION' source='#" + name +
           "-p'/></vertices><triangles count='12'><input "
           "semantic='VERTEX' source='#" +
           name +
           "-v' offset='0'/><p>0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 "
           "3 7 2 7 6 3 0 4 3 4 7</p></triangles></mesh></geometry>";
  };
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
         "<unit name='meter' meter='1'/><up_axis>Z_UP</up_axis></asset><library_geometries>" +
         geometry("Base", "0 0 0 1 0 0 1 1 0 0 1 0 0 0 0.1 1 0 0.1 1 1 0.1 0 1 0.1") +
         geometry("Post", "0.4 0.4 0.1 0.6 0.4 0.1 0.6 0.6 0.1 0.4 0.6 0.1 0.4 0.4 2 0.6 0.4 2 0.6 0.6 2 0.4 0.6 2") +
         "</library_geometries><library_visual_scenes><visual_scene id='S'><node id='nb' "
         "name='Base'><instance_geometry "
         "url='#Base'/></node><node id='np' name='Post'><instance_geometry url='#Post'/></node></visual_scene>"
         "</library_visual_scenes><scene><instance_visual_scene url='#S'/></scene></COLLADA>";
}

constexpr const char* kWedge =
    "solid wedge\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 2 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 3\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 3\nvertex 0 2 0\nendloop\nendfacet\n"
    "facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 2 0\nvertex 0 0 3\nendloop\nendfacet\nendsolid wedge\n";

class SdfKinds : public ::testing::Test {
 protected:
  ImportedScene cell(const std::string& inside, const std::string& version = "1.9") {
    const auto scene =
        readScene(folder_.write("cell.sdf", "<sdf version='" + version + "'>" + inside + "</sdf>"), {}, nullptr);
    EXPECT_TRUE(scene) << scene.error().message();
    return scene ? *scene : ImportedScene{};
  }
  kinematics::RobotModel robot(const std::string& inside, const std::string& version = "1.9") {
    notes_ = {};
    const auto file = folder_.write("robot.sdf", "<sdf version='" + version + "'>" + inside + "</sdf>");
    EXPECT_FALSE(isSdfCell(file));
    const auto read = readRobot(file, notes_);
    EXPECT_TRUE(read) << read.error().message();
    return read ? read->model : kinematics::RobotModel{};
  }
  /// Of the shapes at or below the node, in the file's frame.
  static geometry::Bounds boundsOf(const ImportedScene& scene, const std::string& name) {
    const std::vector<Pose> X_F = nodePoses(scene);
    std::vector<bool> chosen(scene.nodes.size());
    geometry::Bounds bounds;
    for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
      const SceneNode& node = scene.nodes[k];
      chosen[k] = node.name == name || (node.parent >= 0 && chosen[static_cast<std::size_t>(node.parent)]);
      if (!chosen[k] || node.mesh < 0) continue;
      for (const dvec3& v : scene.meshes[static_cast<std::size_t>(node.mesh)].vertices) bounds.add(X_F[k] * v);
    }
    return bounds;
  }
  static void expectBounds(const geometry::Bounds& bounds, const dvec3& least, const dvec3& greatest) {
    EXPECT_LT(glm::distance(bounds.min, least), 1e-6) << bounds.min.x << " " << bounds.min.y << " " << bounds.min.z;
    EXPECT_LT(glm::distance(bounds.max, greatest), 1e-6) << bounds.max.x << " " << bounds.max.y << " " << bounds.max.z;
  }

  test::TemporaryFolder folder_;
  Diagnostics notes_;
};

TEST_F(SdfKinds, RelativeToAndQuaternions) {
  const auto scene = cell(
      "<world name='w'><frame name='bench_top'><pose>0 0 1 0 0 0</pose></frame><model name='bench'><pose "
      "relative_to='bench_top'>2 0 0 0 0 1.5707963267948966</pose><link name='a'><pose>1 0 0 0 0 0</pose><visual "
      "name='v'><geometry><box><size>0.1 0.1 0.1</size></box></geometry></visual></link><link name='b'><pose "
      "relative_to='a'>0 0.5 0 0 0 0</pose><visual name='v'><geometry><box><size>0.1 0.1 0.1</size></box></geometry>"
      "</visual></link></model></world>");
  expectBounds(boundsOf(scene, "a"), {1.95, 0.95, 0.95}, {2.05, 1.05, 1.05});
  expectBounds(boundsOf(scene, "b"), {1.45, 0.95, 0.95}, {1.55, 1.05, 1.05});
  const auto turned = cell(
      "<model name='m'><pose rotation_format='quat_xyzw'>1 2 3 0 0 0.7071067811865476 "
      "0.7071067811865476</pose><link name='l'>" +
      shape("<box><size>0.4 0.2 0.1</size></box>") + "</link></model>");
  expectBounds(boundsOf(turned, "m"), {0.9, 1.8, 2.95}, {1.1, 2.2, 3.05});
  EXPECT_TRUE(turned.warnings.empty());
}

TEST_F(SdfKinds, AModelsOwnFileAndPlacementFrame) {
  const std::string crate = "<sdf version='1.7'><model name='crate'><link name='l'>" +
                            shape("<box><size>0.6 0.4 0.3</size></box>") + "</link></model></sdf>";
  folder_.write("models/crate/model.config",
                "<model><sdf version='1.4'>old.sdf</sdf><sdf version='1.7'>crate.sdf</sdf>"
                "<sdf version='1.12'>newest.sdf</sdf></model>");
  folder_.write("models/crate/crate.sdf", crate);
  const auto placed = cell(
      "<world name='w'><include><uri>model://crate</uri><pose>1 0 0 0 0 0</pose></include>"
      "<include><uri>model://crate</uri></include></world>");
  expectBounds(boundsOf(placed, "crate"), {0.7, -0.2, -0.15}, {1.3, 0.2, 0.15});
  expectBounds(boundsOf(placed, "crate_2"), {-0.3, -0.2, -0.15}, {0.3, 0.2, 0.15});
  folder_.write("models/pallet/model.sdf",
                "<sdf version='1.9'><model name='pallet'><frame name='corner'><pose>0.6 0.4 "
                "0 0 0 0</pose></frame><link name='l'>" +
                    shape("<box><size>1.2 0.8 0.1</size></box>") + "</link></model></sdf>");
  const auto pallet = cell(
      "<world name='w'><include><uri>model://pallet</uri><placement_frame>corner</placement_frame>"
      "<pose>0 0 0 0 0 0</pose></include></world>");
  expectBounds(boundsOf(pallet, "pallet"), {-1.2, -0.8, -0.05}, {0, 0, 0.05});
}

/// Gazebo's Population::CreatePosesBoxGrid: centred on the pose, columns along x.
TEST_F(SdfKinds, APopulationBecomesItsModels) {
  const std::string can = "<model name='can'><link name='l'>" +
                          shape("<cylinder><radius>0.05</radius><length>0.1</length></cylinder>") + "</link></model>";
  const auto scene = cell("<world name='w'><population name='cans'>" + can +
                              "<pose>1 0 0 0 0 0</pose><box><size>2 2 0.01</size></box><model_count>6</model_count>"
                              "<distribution><type>grid</type><rows>3</rows><cols>2</cols><step>0.5 0.5 0</step>"
                              "</distribution></population></world>",
                          "1.6");
  for (int k = 0; k < 6; ++k) {
    const dvec3 middle(1.0 - 0.25 + 0.5 * (k % 2), -0.5 + 0.5 * (k / 2), 0.0);
    const auto bounds = boundsOf(scene, "can_clone_" + std::to_string(k));
    EXPECT_LT(glm::distance(bounds.center(), middle), 1e-6) << k;
  }
  EXPECT_TRUE(scene.warnings.empty());
  const auto random = cell("<world name='w'><population name='cans'>" + can +
                               "<pose>0 0 1 0 0 0</pose><box><size>2 2 1</size></box><model_count>9</model_count>"
                               "<distribution><type>random</type></distribution></population></world>",
                           "1.6");
  EXPECT_EQ(std::count_if(random.nodes.begin(), random.nodes.end(), [](const SceneNode& n) { return n.mesh >= 0; }), 9);
  EXPECT_THAT(english(random.warnings), HasSubstr("spread evenly"));
}

TEST_F(SdfKinds, ASubmeshIsOnePartOfTheFile) {
  folder_.write("two.dae", colladaOfTwo());
  const auto scene =
      cell("<model name='post'><link name='l'>" +
           shape("<mesh><uri>two.dae</uri><submesh><name>Post</name><center>true</center></submesh></mesh>") +
           "</link></model>");
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_NEAR(geometry::massProperties(scene.meshes[0]).volume, 0.076, 1e-6);
  expectBounds(boundsOf(scene, "post"), {-0.1, -0.1, -0.95}, {0.1, 0.1, 0.95});
  const auto none =
      cell("<model name='post'><link name='l'>" +
           shape("<mesh><uri>two.dae</uri><submesh><name>Lid</name></submesh></mesh>") + "</link></model>");
  EXPECT_TRUE(none.meshes.empty());
  EXPECT_THAT(english(none.warnings), HasSubstr("no part 'Lid'"));
}

TEST_F(SdfKinds, AMirroredMeshKeepsItsOutside) {
  folder_.write("wedge.stl", kWedge);
  const auto scene = cell("<model name='left'><link name='l'>" +
                          shape("<mesh><uri>wedge.stl</uri><scale>1 -1 1</scale></mesh>") + "</link></model>");
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_NEAR(geometry::massProperties(scene.meshes[0]).volume, 1.0, 1e-9);
  expectBounds(boundsOf(scene, "left"), {0, -2, 0}, {1, 0, 3});
  const auto model = robot("<model name='left'>" + link("base") + "<link name='arm'>" +
                           shape("<mesh><uri>wedge.stl</uri><scale>-1 -1 -1</scale></mesh>") + "</link>" +
                           joint("revolute", axis("0 0 1", "<lower>-1</lower><upper>1</upper>")) + "</model>");
  ASSERT_FALSE(model.links.back().visuals.empty());
  EXPECT_NEAR(geometry::massProperties(*model.links.back().visuals[0].mesh).volume, 1.0, 1e-9);
}

TEST_F(SdfKinds, ARobotMayHaveMeshesOfEveryKindAndNamesWithBlanks) {
  folder_.write("meshes/two parts.dae", colladaOfTwo());
  const auto model = robot("<model name='gate'><link name='base'>" +
                               shape("<mesh><uri>meshes/two%20parts.dae</uri></mesh>") + "</link>" + link("arm") +
                               joint("revolute", axis("0 0 1", "<lower>-1</lower><upper>1</upper>")) + "</model>",
                           "1.6");
  ASSERT_EQ(model.dof(), 1u);
  ASSERT_EQ(model.links[0].visuals.size(), 1u);
  EXPECT_EQ(model.links[0].visuals[0].mesh->triangles.size(), 24u);
  EXPECT_NEAR(geometry::massProperties(*model.links[0].visuals[0].mesh).volume, 0.1 + 0.2 * 0.2 * 1.9, 1e-6);
  const auto without = robot("<model name='gate'><link name='base'>" + shape("<mesh><uri>gone.dae</uri></mesh>") +
                             "</link>" + link("arm") + joint("revolute", axis("0 0 1", "")) + "</model>");
  EXPECT_EQ(without.dof(), 1u);
  EXPECT_THAT(english(notes_.warnings), HasSubstr("gone.dae"));
}

TEST_F(SdfKinds, APackageUnderAnotherNameIsTakenAndReported) {
  folder_.write("gate-main/meshes/wedge.stl", kWedge);
  for (const std::string scheme : {"package://", "model://"}) {
    const std::string uri = scheme + "gate_description/meshes/wedge.stl";
    const auto inside = "<model name='gate'><link name='base'>" + shape("<mesh><uri>" + uri + "</uri></mesh>") +
                        "</link>" + link("arm") + joint("revolute", axis("0 0 1", "")) + "</model>";
    notes_ = {};
    const auto read =
        readRobot(folder_.write("gate-main/sdf/robot.sdf", "<sdf version='1.9'>" + inside + "</sdf>"), notes_);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->model.links[0].visuals.size(), 1u) << uri;
    EXPECT_THAT(english(notes_.warnings), HasSubstr("gate-main is used, because it contains the rest of the path"))
        << uri;
  }
}

TEST_F(SdfKinds, LimitsOfEachSideAndEachAxis) {
  const auto one = robot("<model name='m'>" + link("base") + link("arm") +
                         joint("revolute", axis("0 1 0", "<lower>0</lower>")) + "</model>");
  EXPECT_EQ(one.joints[0].type, kinematics::JointType::kRevolute);
  EXPECT_EQ(one.joints[0].lower, 0.0);
  EXPECT_TRUE(std::isinf(one.joints[0].upper));
  const auto rail = robot("<model name='m'>" + link("base") + link("arm") +
                          joint("prismatic", axis("0 1 0", "<lower>-inf</lower><upper>0.5</upper>")) + "</model>");
  EXPECT_TRUE(std::isinf(rail.joints[0].lower));
  EXPECT_EQ(rail.joints[0].upper, 0.5);
  const auto two = robot("<model name='m'>" + link("base") + link("arm") +
                         joint("universal", axis("1 0 0", "<lower>-0.5</lower><upper>0.5</upper>") +
                                                axis("0 1 0", "<lower>-0.2</lower><upper>0.9</upper>", "axis2")) +
                         "</model>");
  ASSERT_EQ(two.dof(), 2u);
  EXPECT_EQ(two.joints[0].upper, 0.5);
  EXPECT_EQ(two.joints[1].lower, -0.2);
  EXPECT_EQ(two.joints[1].upper, 0.9);
}

TEST_F(SdfKinds, WhatPlaysNoPartRefusesNoRobot) {
  const std::string turns = joint("revolute", axis("0 0 1", "<lower>-1</lower><upper>1</upper><effort>-7</effort>"));
  for (const std::string& extra :
       {std::string("<visual name='s'>") + kBox +
            "<material><script><name>PR2/wheel</name></script></material></visual>",
        std::string("<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>"),
        std::string("<sensor/>"),
        std::string("<visual name='c'>") + kBox + "<cast_shadows>maybe</cast_shadows></visual>",
        std::string("<inertial><mass>heavy</mass></inertial>")}) {
    const auto model =
        robot("<model name='m'><plugin/><link name='base'>" + extra + "</link>" + link("arm") + turns + "</model>");
    EXPECT_EQ(model.dof(), 1u) << extra;
    EXPECT_TRUE(notes_.warnings.empty()) << english(notes_.warnings);
  }
}

TEST_F(SdfKinds, ARobotInAWorldOrJoinedToItOrWithALoad) {
  const std::string slide = joint("prismatic", axis("0 1 0", "<lower>0</lower><upper>0.1</upper>"));
  const auto gripper =
      robot("<world name='w'><model name='ground'><static>true</static><link name='l'>" +
                shape("<plane><normal>0 0 1</normal></plane>") + "</link></model><model name='gripper'>" +
                link("base") + link("arm") + slide + "</model></world>",
            "1.6");
  ASSERT_EQ(gripper.dof(), 1u);
  EXPECT_EQ(gripper.name, "gripper");
  EXPECT_EQ(gripper.joints[0].upper, 0.1);

  const auto table = robot(
      "<model name='table'><pose>0 0 2 0 0 0</pose><link name='arm'><pose>0 0 0.5 0 0 0</pose>"
      "<collision name='c'>" +
      std::string(kBox) + "</collision></link>" +
      joint("revolute", axis("0 0 1", "<lower>-1</lower><upper>1</upper>"), "world") + "</model>");
  ASSERT_EQ(table.dof(), 1u);
  EXPECT_EQ(table.links[0].name, "world");
  EXPECT_NEAR(table.joints[0].X_PJ.p.z, 2.5, 1e-12);

  folder_.write("models/crate/model.sdf", "<sdf version='1.7'><model name='crate'><link name='l'>" +
                                              shape("<box><size>0.6 0.4 0.3</size></box>") + "</link></model></sdf>");
  const auto loaded =
      robot("<model name='arm'>" + link("base") + link("arm") +
            joint("revolute", axis("0 1 0", "<lower>-1</lower><upper>1</upper>")) +
            "<include><uri>model://crate</uri><name>load</name><pose>0 0 1 0 0 0</pose></include><joint "
            "name='grip' type='fixed'><parent>arm</parent><child>load::l</child></joint></model>");
  EXPECT_EQ(loaded.dof(), 1u);
  const int load = loaded.findLink("load::l");
  ASSERT_GE(load, 0);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(loaded, {0.0}, X_BL);
  EXPECT_NEAR(X_BL[static_cast<std::size_t>(load)].p.z, 1.0, 1e-12);
}

TEST_F(SdfKinds, RobotsStandBesideFurnitureInOneWorld) {
  const auto arm = [](const std::string& name, const std::string& pose) {
    return "<model name='" + name + "'><pose>" + pose +
           "</pose><link name='base'><pose>0 0 0.25 0 0 0</pose><collision "
           "name='c'>" +
           kBox + "</collision></link><link name='arm'><pose>0 0 1 0 0 0</pose><collision name='c'>" + kBox +
           "</collision></link>" + joint("revolute", axis("0 0 1", "<lower>-1</lower><upper>1</upper>")) + "</model>";
  };
  const auto file = folder_.write(
      "cell.world", "<sdf version='1.9'><world name='w'><model name='table'><pose>5 0 0 0 0 0</pose>" + link("top") +
                        "</model>" + arm("left", "1 2 0 0 0 1.5707963267948966") + arm("right", "0 -2 3 0 0 0") +
                        "<model name='lost'>" + link("base") + joint("revolute", "") + "</model></world></sdf>");
  ImportOptions options;
  auto tree = EntityLoader(folder_.path()).loadTree(file.string(), options, notes_);
  ASSERT_TRUE(tree) << tree.error().message();
  const auto named = [&](const std::string& name) {
    const auto found = std::find_if(tree->entities.begin(), tree->entities.end(),
                                    [&](const Entity& entity) { return entity.name == name; });
    return found == tree->entities.end() ? Entity() : *found;
  };
  EXPECT_EQ(named("left").kind(), EntityKind::kRobot);
  ASSERT_TRUE(named("left").robot() && named("right").robot());
  EXPECT_EQ(named("left").robot()->dof(), 1u);
  EXPECT_LT(glm::distance(named("left").X_WE.p, dvec3(1, 2, 0.25)), 1e-12) << "its root stands where the file says";
  EXPECT_NEAR(named("left").X_WE.rotate({1, 0, 0}).y, 1.0, 1e-9);
  EXPECT_LT(glm::distance(named("right").X_WE.p, dvec3(0, -2, 3.25)), 1e-12);
  EXPECT_EQ(named("table").kind(), EntityKind::kAssembly);
  EXPECT_FALSE(named("lost").robot());
  EXPECT_THAT(english(notes_.warnings), HasSubstr("'lost' has moving joints; it is read as a rigid body: "));

  Document document;
  ASSERT_TRUE(addImported(document, tree->entities, Pose()));
  const auto cell = folder_.path() / "kept.hcell";
  ASSERT_TRUE(saveDocument(document, cell));
  const auto again = loadDocument(cell, notes_);
  ASSERT_TRUE(again) << again.error().message();
  const Entity* right = again->state().findByName("right");
  ASSERT_TRUE(right && right->robot());
  EXPECT_EQ(right->robot()->name, "right");
  EXPECT_LT(glm::distance(right->X_WE.p, dvec3(0, -2, 3.25)), 1e-12);

  options.merge = true;
  const auto merged = EntityLoader(folder_.path()).loadTree(file.string(), options, notes_);
  ASSERT_TRUE(merged) << merged.error().message();
  ASSERT_EQ(merged->entities.size(), 1u);
  EXPECT_NEAR(merged->entities[0].mesh()->bounds().max.z, 4.05, 1e-9) << "robots are part of the whole";
}

TEST_F(SdfKinds, ARobotAloneStandsWhereItsModelDoes) {
  const auto file =
      folder_.write("r.sdf", "<sdf version='1.9'><model name='m'><pose>1 0 2 0 0 0</pose>" + link("base") +
                                 link("arm") + joint("revolute", axis("0 0 1", "")) + "</model></sdf>");
  const auto tree = EntityLoader(folder_.path()).loadTree(file.string(), {}, notes_);
  ASSERT_TRUE(tree) << tree.error().message();
  EXPECT_LT(glm::distance(tree->entities.at(0).X_WE.p, dvec3(1, 0, 2)), 1e-12);
}

TEST_F(SdfKinds, FollowersAndFreeBodiesAreToldOrKept) {
  const auto model = robot(
      "<model name='m'>" + link("base") + link("arm") + link("finger") + link("loose") +
          joint("revolute", axis("0 0 1", "<lower>-1</lower><upper>1</upper>")) +
          "<joint name='f' type='revolute'><parent>arm</parent><child>finger</child><axis><xyz>0 0 1</xyz><mimic "
          "joint='j' "
          "axis='axis'><multiplier>-2</multiplier><offset>0.5</offset><reference>0.1</reference></mimic></axis></joint>"
          "</model>",
      "1.11");
  ASSERT_EQ(model.dof(), 1u);
  const kinematics::Joint& follower = model.joints[static_cast<std::size_t>(model.findJoint("f"))];
  ASSERT_TRUE(follower.mimic);
  EXPECT_NEAR(kinematics::jointPosition(model, {0.3}, follower), -2.0 * (0.3 - 0.1) + 0.5, 1e-12);
  EXPECT_GE(model.findLink("loose"), 0);
  EXPECT_THAT(english(notes_.warnings), HasSubstr("'loose'"));
}

TEST_F(SdfKinds, CapsulesAndEllipsoidsAreShapes) {
  const auto scene =
      cell("<model name='m'><link name='l'>" + shape("<capsule><radius>0.2</radius><length>1</length></capsule>") +
           "<visual name='e'><pose>5 0 0 0 0 0</pose><geometry><ellipsoid><radii>0.1 0.2 0.3</radii>"
           "</ellipsoid></geometry></visual></link></model>");
  expectBounds(boundsOf(scene, "v"), {-0.2, -0.2, -0.7}, {0.2, 0.2, 0.7});
  expectBounds(boundsOf(scene, "e"), {4.9, -0.2, -0.3}, {5.1, 0.2, 0.3});
  for (const auto& mesh : scene.meshes) {
    EXPECT_TRUE(geometry::isClosed(mesh));
    EXPECT_GT(geometry::massProperties(mesh).volume, 0.0);
  }
}

TEST_F(SdfKinds, NamesThatAreThereTwiceAndFramesThatAreNot) {
  const std::string box = "<link name='l'>" + shape("<box><size>1 1 1</size></box>") + "</link>";
  const auto twice = cell("<world name='w'><model name='m'>" + box +
                          "</model><model name='m'><pose>3 0 0 0 0 0</pose>" + box + "</model></world>");
  expectBounds(boundsOf(twice, "m_2"), {2.5, -0.5, -0.5}, {3.5, 0.5, 0.5});
  EXPECT_THAT(english(twice.warnings), HasSubstr("'m_2'"));
  const auto lost =
      cell("<world name='w'><model name='m'><pose relative_to='nowhere'>1 0 0 0 0 0</pose>" + box + "</model></world>");
  EXPECT_THAT(english(lost.warnings), HasSubstr("frame of its pose does not exist"));
  EXPECT_THAT(english(lost.warnings), HasSubstr("nowhere"));
}

}  // namespace
}  // namespace hapticell::workcell
