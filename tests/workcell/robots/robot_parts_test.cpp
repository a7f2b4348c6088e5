// SPDX-License-Identifier: Apache-2.0
// The parts that read robot.toml, URDF and xacro files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml.h>

#include <cmath>
#include <numbers>

#include "kinematics/closures/delta_robot.h"
#include "tests/support/test_data.h"
#include "tests/workcell/robots/urdf_text.h"
#include "workcell/robots/parallel_kind_reader.h"
#include "workcell/robots/robot_body.h"
#include "workcell/robots/robot_library.h"
#include "workcell/robots/robot_toml.h"
#include "workcell/robots/robot_toml_common.h"
#include "workcell/robots/robot_toml_reader.h"
#include "workcell/robots/serial_kind_reader.h"
#include "workcell/robots/urdf_elements.h"
#include "workcell/robots/urdf_lines.h"
#include "workcell/robots/urdf_shapes.h"
#include "workcell/robots/urdf_structure.h"
#include "workcell/robots/xacro_file.h"

namespace hapticell::workcell {
namespace {

using hapticell::test::TemporaryFolder;
using test::jointText;
using test::linkText;
using test::meshText;
using test::robotText;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
namespace fs = std::filesystem;

TEST(UrdfLines, SayWhereALineComesFrom) {
  const UrdfLines plain("arm.urdf");
  EXPECT_EQ(english(plain.words(12)), "line 12");
  EXPECT_EQ(english(plain.words(0)), "");
  const std::vector<xacro::Expanded::Place> places = {{"arm.xacro", 5}, {"/macros/hand.xacro", 7}};
  const UrdfLines expanded("arm.xacro", &places);
  EXPECT_EQ(english(expanded.words(1)), "line 5");
  EXPECT_EQ(english(expanded.words(2)), "hand.xacro, line 7");
  EXPECT_EQ(english(expanded.words(3)), "line 3") << "beyond the places: as it is";
  const auto refused = Expected<void>(expanded.refuse(2, "a", "b"));
  EXPECT_EQ(refused.error().file, "/macros/hand.xacro");
  EXPECT_EQ(english(refused.error().place), "line 7");
}

class UrdfParts : public ::testing::Test {
 protected:
  const TiXmlElement& parse(const std::string& text) {
    document_.Clear();
    document_.Parse(text.c_str());
    return *document_.RootElement();
  }
  const UrdfLines lines{"arm.urdf"};
  Diagnostics notes;

 private:
  TiXmlDocument document_;
};

TEST_F(UrdfParts, ALinkHasItsShapes) {
  const auto link =
      readUrdfLink(parse("<link name='l'><visual><origin xyz='1 2 3'/><geometry><box size='1 2 3'/></geometry>"
                         "<material name='red'><color rgba='1 0 0 1'/></material></visual>"
                         "<collision><geometry><cylinder radius='0.5' length='2'/></geometry></collision>"
                         "<collision><geometry><mesh filename='a.stl' scale='1 -1 2'/></geometry></collision></link>"),
                   lines, notes);
  ASSERT_TRUE(link.has_value()) << link.error().message();
  EXPECT_EQ(link->name, "l");
  ASSERT_THAT(link->visuals, SizeIs(1));
  EXPECT_EQ(link->visuals[0].kind, UrdfShape::Kind::kBox);
  EXPECT_EQ(link->visuals[0].size, dvec3(1, 2, 3));
  EXPECT_EQ(link->visuals[0].X_LS.p, dvec3(1, 2, 3));
  EXPECT_EQ(link->visuals[0].material, "red");
  ASSERT_THAT(link->collisions, SizeIs(2));
  EXPECT_EQ(link->collisions[0].length, 2.0);
  EXPECT_EQ(link->collisions[1].mesh, "a.stl");
  EXPECT_EQ(link->collisions[1].size, dvec3(1, -1, 2));
  EXPECT_FALSE(readUrdfLink(parse("<link name='l'><visual><origin xyz='1 two 3'/><geometry><box size='1 2 3'/>"
                                  "</geometry></visual></link>"),
                            lines, notes)
                   .has_value());
}

TEST_F(UrdfParts, AJointHasAxisLimitsAndMimic) {
  const auto joint =
      readUrdfJoint(parse("<joint name='j' type='prismatic'><parent link='a'/><child link='b'/><axis xyz='0 0 2'/>"
                          "<limit lower='-1' upper='2' velocity='3' effort='1'/><mimic joint='k' multiplier='2' "
                          "offset='0.5'/></joint>"),
                    lines, notes);
  ASSERT_TRUE(joint.has_value()) << joint.error().message();
  EXPECT_EQ(joint->type, "prismatic");
  EXPECT_EQ(joint->parent, "a");
  EXPECT_EQ(joint->child, "b");
  EXPECT_EQ(joint->joint.lower, -1.0);
  EXPECT_EQ(joint->joint.upper, 2.0);
  EXPECT_EQ(joint->mimicked, "k");
  EXPECT_EQ(joint->multiplier, 2.0);
  EXPECT_EQ(joint->offset, 0.5);
  for (const char* bad :
       {"<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 0'/></joint>",
        "<joint name='j' type='bendy'><parent link='a'/><child link='b'/></joint>",
        "<joint name='j' type='fixed'><parent link='a'/></joint>",
        "<joint type='fixed'><parent link='a'/><child link='b'/></joint>",
        "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><limit lower='x' upper='1'/></joint>"}) {
    const auto refused = readUrdfJoint(parse(bad), lines, notes);
    ASSERT_FALSE(refused.has_value()) << bad;
    EXPECT_THAT(refused.error().message(), HasSubstr("arm.urdf")) << bad;
  }
}

TEST_F(UrdfParts, CrossedLimitsMeanNoneAndAreTold) {
  const auto joint = readUrdfJoint(parse("<joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
                                         "<limit lower='1' upper='-1' velocity='1' effort='1'/></joint>"),
                                   lines, notes);
  ASSERT_TRUE(joint.has_value()) << joint.error().message();
  EXPECT_THAT(notes.warnings, Not(IsEmpty()));
}

TEST_F(UrdfParts, AMaterialHasItsColorOrATexture) {
  const UrdfMaterial red =
      readUrdfMaterial(parse("<material name='red'><color rgba='1 0 0 0.5'/></material>"), lines, notes);
  ASSERT_TRUE(red.color.has_value());
  EXPECT_EQ((*red.color)[0], 1.0f);
  EXPECT_EQ((*red.color)[3], 0.5f);
  EXPECT_TRUE(
      readUrdfMaterial(parse("<material name='w'><texture filename='w.png'/></material>"), lines, notes).textured);
}

TEST_F(UrdfParts, TheStructureIsATreeFromItsRoot) {
  const std::string text =
      robotText(linkText("c") + linkText("a") + linkText("b") + jointText("bc", "b", "c") + jointText("ab", "a", "b"));
  const auto structure = readUrdfStructure(text, lines, notes);
  ASSERT_TRUE(structure.has_value()) << structure.error().message();
  EXPECT_EQ(structure->robot_name, "r");
  EXPECT_EQ(structure->root_link, "a");
  ASSERT_THAT(structure->joints, SizeIs(2));
  EXPECT_EQ(structure->joints[0].joint.name, "ab") << "from the root";
  EXPECT_EQ(structure->links.at(0).name, "c") << "in the order of the file";
  EXPECT_EQ(structure->link("b").name, "b");
}

TEST_F(UrdfParts, WhatIsNoTreeIsRefusedWithItsLine) {
  const std::string ab = linkText("a") + linkText("b");
  for (const std::string& bad :
       {ab + linkText("a"), ab + jointText("j", "a", "none"), ab + jointText("j", "a", "b") + jointText("k", "b", "a"),
        ab + linkText("c") + jointText("j", "a", "c") + jointText("k", "b", "c"),
        ab + jointText("j", "a", "b") + jointText("j", "a", "b")}) {
    const auto refused = readUrdfStructure(robotText(bad), lines, notes);
    ASSERT_FALSE(refused.has_value()) << bad;
    EXPECT_THAT(refused.error().message(), HasSubstr("line")) << bad;
  }
  EXPECT_FALSE(readUrdfStructure("<sdf/>", lines, notes).has_value());
}

TEST_F(UrdfParts, AShapeThatCannotBeReadIsCounted) {
  const TemporaryFolder folder;
  folder.write("good.stl", test::tetrahedronStl());
  const UrdfLines file((folder.path() / "arm.urdf").string());
  const auto link = readUrdfLink(
      parse(linkText("l", meshText("visual", "good.stl", "scale=\"1 1 2\"") + meshText("visual", "none.stl"))), file,
      notes);
  ASSERT_TRUE(link.has_value()) << link.error().message();
  UrdfShapes shapes(file, notes);
  kinematics::Link filled;
  ASSERT_TRUE(shapes.fill(*link, filled).has_value());
  EXPECT_EQ(filled.lost_shapes, 1);
  ASSERT_THAT(filled.visuals, SizeIs(1));
  EXPECT_NEAR(filled.visuals[0].mesh->bounds().max.z, 2.0, 1e-6) << "scaled";
  EXPECT_THAT(english(notes.warnings), HasSubstr("none.stl"));
}

TEST(XacroFile, IsExpandedWithTheFilesBesideIt) {
  const TemporaryFolder folder;
  folder.write("part.xacro", "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\"><link name=\"$(arg tip)\"/></robot>");
  const fs::path file = folder.write("arm.xacro",
                                     "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n"
                                     "<xacro:arg name=\"tip\" default=\"hand\"/>\n"
                                     "<xacro:include filename=\"part.xacro\"/>\n</robot>\n");
  std::vector<xacro::DeclaredArgument> declared;
  Diagnostics notes;
  const auto expanded = expandXacroFile(file, {{"colour", "red"}}, declared, notes);
  ASSERT_TRUE(expanded.has_value()) << expanded.error().message();
  EXPECT_THAT(expanded->text, HasSubstr("\"hand\""));
  EXPECT_THAT(expanded->files, SizeIs(2));
  ASSERT_THAT(declared, SizeIs(1));
  EXPECT_EQ(declared[0].name, "tip");
  EXPECT_THAT(english(notes.warnings), HasSubstr("colour")) << "an argument that the file does not declare";
  declared.clear();
  EXPECT_FALSE(expandXacroFile(folder.path() / "none.xacro", {}, declared, notes).has_value());
  EXPECT_FALSE(expandXacroFile(folder.path(), {}, declared, notes).has_value()) << "a folder";
}

TEST(RobotLibrary, ListsWhatItCanFind) {
  Diagnostics notes;
  const std::vector<LibraryRobot> robots = listLibraryRobots(notes);
  EXPECT_THAT(notes.warnings, IsEmpty());
  ASSERT_GT(robots.size(), 10u);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    EXPECT_EQ(findLibraryRobot(robots[i].name).value(), robots[i].file);
    if (i == 0) continue;
    EXPECT_LT(robots[i - 1].name, robots[i].name);
  }
  for (const char* bad : {"", "none", "../robots/ur5", "ur5.toml"})
    EXPECT_FALSE(findLibraryRobot(bad).has_value()) << bad;
}

TEST(RobotLibrary, KnowsThePayloadsOfTheMakers) {
  EXPECT_EQ(ratedPayload("library:ur5").value(), 5.0);  // The maker's data sheet.
  EXPECT_EQ(ratedPayload("library:kuka_kr16_2").value(), 16.0);
  EXPECT_EQ(ratedPayload("/robots/any.urdf").value(), 0.0) << "URDF states none";
  EXPECT_FALSE(ratedPayload("library:none").has_value());
  EXPECT_FALSE(ratedPayload("/none/robot.toml").has_value());
}

/// The classic Denavit-Hartenberg transform: Rz(theta) Tz(d) Tx(a) Rx(alpha).
Pose dh(double theta, double d, double a, double alpha) {
  const Pose z{{0, 0, d}, quaternionFromRotationVector({0, 0, theta})},
      x{{a, 0, 0}, quaternionFromRotationVector({alpha, 0, 0})};
  return z * x;
}

TEST(RobotToml, ADenavitHartenbergTableGivesItsChain) {
  const TemporaryFolder folder;
  const std::string text =
      "format = \"hapticell-robot\"\nversion = 1\nname = \"two\"\nmaker = \"m\"\nkind = \"2-axis\"\npayload = 3\n"
      "source = \"here\"\nunit = \"mm\"\n[dh]\nconvention = \"standard\"\ntheta = [0, 0]\nd = [300, 50]\n"
      "a = [100, 400]\nalpha = [90, 30]\n[joints]\nlower = [-90, -90]\nupper = [90, 90]\nvelocity = [90, 90]\n";
  Diagnostics notes;
  const auto robot = readRobotToml(folder.write("two.toml", text), notes);
  ASSERT_TRUE(robot.has_value()) << robot.error().message();
  EXPECT_EQ(robot->sheet.payload, 3.0);
  ASSERT_EQ(robot->model.dof(), 2u);
  EXPECT_NEAR(robot->model.joints[static_cast<std::size_t>(robot->model.moving[0])].upper, 0.5 * std::numbers::pi,
              1e-12);
  const Pose expected = dh(0, 0.3, 0.1, 0.5 * std::numbers::pi) * dh(0, 0.05, 0.4, std::numbers::pi / 6);
  Pose X;  // All joints at 0: the joints' own placements.
  for (const kinematics::Joint& joint : robot->model.joints) X = X * joint.X_PJ;
  EXPECT_NEAR(glm::distance(X.p, expected.p), 0.0, 1e-9);
  const auto sheet = readRobotSheet(folder.path() / "two.toml");
  ASSERT_TRUE(sheet.has_value());
  EXPECT_EQ(sheet->name, "two");

  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string bad = text;
    bad.replace(bad.find(from), from.size(), to);
    const auto read = readRobotToml(folder.write("bad.toml", bad), notes);
    return read ? std::string() : read.error().message();
  };
  EXPECT_THAT(refused("d = [300, 50]", "d = [300]"), HasSubstr("bad.toml"));
  EXPECT_THAT(refused("lower = [-90, -90]", "lower = [-90, 91]"), HasSubstr("line"));
  EXPECT_THAT(refused("payload = 3", "paylod = 3"), HasSubstr("paylod"));
  EXPECT_THAT(refused("theta = [0, 0]", "theta = [0, \"x\"]"), Not(IsEmpty()));
  EXPECT_THAT(refused("name = \"two\"", "name = "), Not(IsEmpty()));
}

const std::string kHead = "format = \"hapticell-robot\"\nversion = 1\nname = \"two\"\nunit = \"mm\"\n";
const std::string kTwoRows =
    "[dh]\nconvention = \"standard\"\nd = [300, 50]\na = [100, 400]\nalpha = [90, 30]\n"
    "types = [\"revolute\", \"prismatic\"]\n";
const std::string kTwoJoints =
    "[joints]\nlower = [-90, -20]\nupper = [90, 30]\nvelocity = [180, 500]\nhome = [10, 20]\n";

TEST(RobotTomlCommon, JointsTurnInDegreesAndSlideInTheUnitOfLength) {
  const toml::table root = toml::parse(kHead + kTwoJoints);
  RobotTomlCommon common(root, "/robots/two.toml");
  common.readHead();
  common.readLook();
  common.readJoints();
  EXPECT_EQ(common.sheet().name, "two");
  EXPECT_DOUBLE_EQ(common.unit(), 1e-3);
  EXPECT_EQ(common.style(), BodyStyle::kOfTheKind);
  EXPECT_EQ(common.jointCount(), 2u);
  const auto joints = common.jointData({false, true});
  ASSERT_FALSE(common.error());
  ASSERT_THAT(joints, SizeIs(2));
  EXPECT_NEAR(joints[0].upper, 0.5 * std::numbers::pi, 1e-15);
  EXPECT_NEAR(joints[0].velocity, std::numbers::pi, 1e-15);
  EXPECT_NEAR(joints[1].lower, -0.02, 1e-15);
  EXPECT_NEAR(joints[1].velocity, 0.5, 1e-15);
  EXPECT_NE(joints[0].name, joints[1].name);
  ASSERT_THAT(common.rest(), SizeIs(2));
  EXPECT_NEAR(common.rest()[1], 0.02, 1e-15);
}

TEST(RobotTomlCommon, KeepsTheFirstProblemWithItsFile) {
  const toml::table root = toml::parse(kHead + kTwoJoints);
  RobotTomlCommon common(root, "/robots/two.toml");
  common.readHead();
  common.readJoints();
  common.jointData({false, false, false});
  ASSERT_TRUE(common.error());
  common.failWith({.found = "a later one"}, nullptr);
  EXPECT_THAT(common.failure().message(), HasSubstr("/robots/two.toml"));
  EXPECT_THAT(common.failure().message(), HasSubstr("one per joint"));
  EXPECT_THAT(common.failure().message(), Not(HasSubstr("later")));
}

TEST(SerialKindReader, MakesTheChainWithItsBody) {
  const toml::table root = toml::parse(kHead + kTwoRows + kTwoJoints);
  RobotTomlCommon common(root, "two.toml");
  common.readHead();
  common.readJoints();
  kinematics::RobotModel model;
  SerialKindReader(common, model).readDh();
  ASSERT_FALSE(common.error()) << common.failure().message();
  EXPECT_EQ(model.dof(), 2u);
  const kinematics::Joint& second = model.joints[static_cast<std::size_t>(model.moving[1])];
  EXPECT_EQ(second.type, kinematics::JointType::kPrismatic);
  EXPECT_NEAR(second.upper, 0.03, 1e-15);
  std::size_t shapes = 0;
  for (const kinematics::Link& link : model.links) shapes += link.visuals.size();
  EXPECT_GT(shapes, 2u);
  const toml::table broken = toml::parse(kHead + "[dh]\nconvention = \"standard\"\nd = [1]\na = [1, 2]\nalpha = [0]\n");
  RobotTomlCommon other(broken, "broken.toml");
  SerialKindReader(other, model).readDh();
  ASSERT_TRUE(other.error());
  EXPECT_THAT(other.failure().message(), HasSubstr("unequal length"));
}

TEST(ParallelKindReader, MakesADeltaWhoseLoopsAreClosed) {
  const toml::table root = toml::parse(
      kHead +
      "[delta]\nbase_radius = 140\nupper_arm = 565\nlower_arm = 1260\nplatform_radius = 75\nrod_spacing = 160\n"
      "[joints]\nlower = [-40, -40, -40]\nupper = [80, 80, 80]\n");
  RobotTomlCommon common(root, "delta.toml");
  common.readHead();
  common.readJoints();
  kinematics::RobotModel model;
  Diagnostics notes;
  ParallelKindReader(common, model, notes).readDelta();
  ASSERT_FALSE(common.error()) << common.failure().message();
  EXPECT_TRUE(model.closure);
  EXPECT_EQ(model.dof(), 3u);
  const toml::table none = toml::parse(kHead + "[delta]\nbase_radius = 140\n");
  RobotTomlCommon other(none, "none.toml");
  ParallelKindReader(other, model, notes).readDelta();
  ASSERT_TRUE(other.error());
  EXPECT_THAT(other.failure().message(), HasSubstr("upper_arm"));
}

TEST(RobotTomlReader, ReadsOneKindAndItsTools) {
  const std::string tool = "[[tool]]\nname = \"pen\"\nposition = [0, 0, 120]\n";
  const auto read = [](const std::string& text) {
    const toml::table root = toml::parse(text);
    Diagnostics notes;
    return RobotTomlReader(root, "r.toml", notes).read();
  };
  const auto robot = read(kHead + kTwoRows + kTwoJoints + tool);
  ASSERT_TRUE(robot) << robot.error().message();
  EXPECT_EQ(robot->model.name, "two");
  ASSERT_THAT(robot->tools, SizeIs(1));
  EXPECT_EQ(robot->tools[0].tip_link, robot->model.links[static_cast<std::size_t>(robot->model.defaultTip())].name);
  EXPECT_NEAR(robot->tools[0].X_LT.p.z, 0.12, 1e-15);
  const auto two = read(kHead + kTwoRows + "[opw]\nc1 = 1\n" + kTwoJoints);
  ASSERT_FALSE(two);
  EXPECT_THAT(two.error().message(), HasSubstr("both [opw] and [dh]"));
  const auto none = read(kHead);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message(), HasSubstr("no table defines how the robot moves"));
  const toml::table root = toml::parse(kHead);
  Diagnostics notes;
  EXPECT_EQ(RobotTomlReader(root, "r.toml", notes).readSheet()->name, "two") << "a sheet needs no kind";
}

std::vector<kinematics::JointData> jointsOf(std::size_t count) {
  std::vector<kinematics::JointData> joints;
  for (std::size_t k = 0; k < count; ++k) joints.push_back({"j" + std::to_string(k), -1.0, 1.0, 1.0});
  return joints;
}

/// Triangles of what is seen, and of what collides; both have to be there.
std::pair<std::size_t, std::size_t> trianglesOf(const kinematics::RobotModel& model) {
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (const kinematics::Link& link : model.links) {
    for (const auto& shape : link.visuals) count.first += shape.mesh->triangles.size();
    for (const auto& shape : link.collisions) count.second += shape.mesh->triangles.size();
  }
  return count;
}

TEST(RobotBody, EachKindHasShapesAndCoarserOnesThatCollide) {
  kinematics::OpwParameters opw;
  opw.a1 = 0.15;
  opw.c1 = 0.45;
  opw.c2 = 0.6;
  opw.c3 = 0.64;
  opw.c4 = 0.1;
  kinematics::RobotModel arm = kinematics::buildOpw("arm", opw, jointsOf(6)), slim = arm, cobot = arm;
  addArmBody(arm, opw, {});
  RobotLook thin;
  thin.bulk = 0.5;
  addArmBody(slim, opw, thin);
  addCobotBody(cobot, {});
  const auto scaraRows = [] {
    return std::vector<kinematics::DhRow>{{0, 0.3, 0.25, 0}, {0, 0, 0.25, std::numbers::pi}, {0, 0, 0, 0, true}, {}};
  };
  kinematics::RobotModel scara =
      kinematics::buildDh("scara", kinematics::DhConvention::kStandard, scaraRows(), jointsOf(4), {});
  addScaraBody(scara, {});
  std::vector<kinematics::ChainJoint> axes(3);
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k].data = jointsOf(3)[k];
    axes[k].type = kinematics::JointType::kPrismatic;
    axes[k].axis_J = {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
  }
  kinematics::RobotModel gantry = kinematics::buildChain("gantry", axes, {});
  addGantryBody(gantry, {});
  for (const kinematics::RobotModel* model : {&arm, &slim, &cobot, &scara, &gantry}) {
    const auto [seen, colliding] = trianglesOf(*model);
    EXPECT_GT(colliding, 0u) << model->name;
    EXPECT_LE(colliding, seen) << model->name;
  }
  const auto widthOf = [](const kinematics::RobotModel& model) {
    const auto bounds = model.links[2].visuals.at(0).mesh->bounds();
    return (bounds.max - bounds.min).y;
  };
  EXPECT_LT(widthOf(slim), widthOf(arm)) << "the upper arm";
}

}  // namespace
}  // namespace hapticell::workcell
