// SPDX-License-Identifier: Apache-2.0
// URDF as simulators, exporters and makers write it: what moves nothing refuses nothing, what is lost is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/shapes/mass_properties.h"
#include "tests/support/test_data.h"
#include "tests/workcell/robots/urdf_text.h"
#include "workcell/robots/robot_reader.h"

namespace hapticell::workcell {
namespace {

using kinematics::JointType;
using test::jointText;
using test::linkText;
using test::meshText;
using test::robotText;
using ::testing::HasSubstr;

struct Read {
  std::optional<kinematics::RobotModel> model;
  std::string said;  ///< Warnings and the error, a line each.
};

Read readFrom(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  auto robot = readRobot(file, diagnostics);
  Read result;
  for (const Text& warning : diagnostics.warnings) result.said += english(warning) + "\n";
  if (robot)
    result.model = std::move(robot->model);
  else
    result.said += robot.error().message();
  return result;
}

Read readBody(const std::string& body) {
  const hapticell::test::TemporaryFolder folder;
  return readFrom(folder.write("robot.urdf", robotText(body)));
}

const std::string kPair = linkText("a") + linkText("b");
std::string limited(const std::string& limit, const std::string& type = "revolute", const std::string& more = {}) {
  return kPair + jointText("j", "a", "b", type, "<axis xyz=\"0 0 1\"/>" + limit + more);
}

TEST(UrdfOfStrangers, WhatMovesNothingRefusesNothing) {
  const std::string box = "<geometry><box size=\"1 1 1\"/></geometry>";
  const std::vector<std::string> bodies = {
      limited("<limit lower=\"-1\" upper=\"1\" velocity=\"1\"/>"),
      limited("<limit lower=\"-1\" upper=\"1\" effort=\"inf\" velocity=\"1\"/>"),
      limited("<limit lower=\"-1\" upper=\"1\" effort=\"lots\" velocity=\"1\"/>"),
      limited("<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>", "revolute",
              "<safety_controller soft_lower_limit=\"-0.5\"/><calibration/><dynamics damping=\"x\"/>"),
      linkText("a", "<inertial><mass value=\"1\"/><inertia ixx=\"1\"/></inertial>"),
      linkText("a", "<inertial/>"),
      linkText("a", "<inertial><mass value=\"heavy\"/></inertial>"),
      "<material name=\"m\"><color rgba=\"1 0 0 1\"/></material><material name=\"m\"><color rgba=\"1 0 0 "
      "1\"/></material>" +
          linkText("a", "<visual>" + box + "<material name=\"m\"/></visual>"),
      "<material><color rgba=\"1 0 0 1\"/></material>" +
          linkText("a", "<visual>" + box + "<material><color rgba=\"1 0 0 1\"/></material></visual>"),
      "<transmission><joint name=\"x\"/></transmission><gazebo/><unknown/>" + linkText("a"),
  };
  for (const std::string& body : bodies) {
    const Read read = readBody(body);
    EXPECT_TRUE(read.model) << body << read.said;
    EXPECT_EQ(read.said, "") << body;
  }
}

TEST(UrdfOfStrangers, LimitsThatAreNoneAreToldAndHoldNothing) {
  for (const char* limit :
       {"<limit lower=\"0\" upper=\"-1\" velocity=\"1\"/>", "", "<limit lower=\"-inf\" upper=\"inf\" velocity=\"1\"/>",
        "<limit lower=\"-1e16\" upper=\"1e16\" velocity=\"1\"/>"}) {
    const Read turning = readBody(limited(limit)), sliding = readBody(limited(limit, "prismatic"));
    ASSERT_TRUE(turning.model && sliding.model) << turning.said << sliding.said;
    EXPECT_EQ(turning.model->joints[0].type, JointType::kContinuous) << limit;
    EXPECT_EQ(sliding.model->joints[0].type, JointType::kPrismatic) << limit;
    for (const Read* read : {&turning, &sliding}) {
      EXPECT_TRUE(std::isinf(read->model->joints[0].lower) && std::isinf(read->model->joints[0].upper)) << limit;
      EXPECT_EQ(
          read->said.find("no limits are assumed") != std::string::npos,
          std::string(limit).find("inf") == std::string::npos && std::string(limit).find("1e16") == std::string::npos)
          << read->said;
    }
  }
  const Read one_sided = readBody(limited("<limit lower=\"-inf\" upper=\"1\" velocity=\"1\"/>"));
  ASSERT_TRUE(one_sided.model);
  EXPECT_EQ(one_sided.model->joints[0].upper, 1.0);
  EXPECT_TRUE(std::isinf(one_sided.model->joints[0].lower));
  EXPECT_THAT(readBody(limited("<limit lower=\"0\" upper=\"-1\" velocity=\"1\"/>")).said,
              HasSubstr("line 5: joint 'j'"));
  EXPECT_THAT(readBody(limited("<limit lower=\"-1\" upper=\"1\" velocity=\"inf\"/>")).said,
              HasSubstr("no finite velocity is stated for 'j"));
  const Read no_number = readBody(limited("<limit lower=\"nan\" upper=\"1\"/>"));
  EXPECT_FALSE(no_number.model);
  EXPECT_THAT(no_number.said, HasSubstr("line 5"));
}

TEST(UrdfOfStrangers, ShapesThatAreNoneAreLeftOutAndTold) {
  struct Sample {
    const char *geometry, *said;
    int lost;
  };
  const std::vector<Sample> samples = {{"<box size=\"0 0 0\"/>", "a box of size zero", 0},
                                       {"<box size=\"1 0 1\"/>", "a box of size zero", 0},
                                       {"<sphere radius=\"0\"/>", "a sphere of size zero", 0},
                                       {"<cylinder radius=\"0\" length=\"1\"/>", "a cylinder of size zero", 0},
                                       {"<sphere radius=\"-1\"/>", "not a number above 0", 1},
                                       {"<sphere/>", "not a number above 0", 1},
                                       {"<box size=\"1 1\"/>", "not three numbers", 1},
                                       {"<heightmap/>", "<heightmap>, which is not supported", 1},
                                       {"<mesh/>", "a mesh without filename", 1},
                                       {"<mesh filename=\"t.stl\" scale=\"1 0 1\"/>", "scale=\"1 0 1\"", 1},
                                       {"", "an empty <geometry>", 1}};
  for (const auto& [geometry, said, lost] : samples) {
    const Read read = readBody(linkText("a", std::string("<visual><geometry>") + geometry + "</geometry></visual>"));
    ASSERT_TRUE(read.model) << read.said;
    EXPECT_THAT(read.said, HasSubstr("line 3: "));
    EXPECT_THAT(read.said, HasSubstr(said));
    EXPECT_EQ(read.model->links[0].lost_shapes, lost) << geometry;
    EXPECT_EQ(read.model->links[0].isUnchecked(), lost > 0) << geometry;
  }
  const Read bare = readBody(linkText(
      "a",
      "<visual><origin xyz=\"0 0 0\"/></visual><collision><geometry><box size=\"1 1 1\"/></geometry></collision>"));
  ASSERT_TRUE(bare.model);
  EXPECT_EQ(bare.model->links[0].visuals.size(), 1u) << "the collision shape is shown";
  EXPECT_FALSE(bare.model->links[0].isUnchecked());
}

TEST(UrdfOfStrangers, ACapsuleIsACylinderWithTwoHalfSpheres) {
  const Read read =
      readBody(linkText("a", "<collision><geometry><capsule radius=\"0.1\" length=\"0.5\"/></geometry></collision>"));
  ASSERT_TRUE(read.model) << read.said;
  const auto& mesh = *read.model->links[0].collisions.at(0).mesh;
  const double volume = std::numbers::pi * 0.01 * 0.5 + 4.0 / 3.0 * std::numbers::pi * 0.001;
  EXPECT_NEAR(geometry::massProperties(mesh).volume, volume, 0.01 * volume);
  EXPECT_NEAR(mesh.bounds().max.z, 0.35, 1e-12);
  EXPECT_NEAR(mesh.bounds().min.z, -0.35, 1e-12);
  EXPECT_NEAR(mesh.bounds().max.x, 0.1, 1e-12);
}

TEST(UrdfOfStrangers, AMissingOrBrokenMeshLeavesItsShapeOut) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("cut.stl", test::tetrahedronStl().substr(0, 150));
  folder.write("t.stl", test::tetrahedronStl());
  const auto file = folder.write(
      "r.urdf", robotText(linkText("a", meshText("visual", "package://nowhere/a.stl")) +
                          linkText("b", meshText("visual", "cut.stl")) +
                          linkText("c", meshText("visual", "gone.dae") + meshText("collision", "t.stl")) +
                          linkText("d", meshText("visual", "t.stl") + meshText("visual", "gone.stl")) +
                          linkText("e", meshText("visual", "package://p/../../etc/passwd")) + jointText("i", "a", "b") +
                          jointText("j", "b", "c") + jointText("k", "c", "d") + jointText("l", "d", "e")));
  const Read read = readFrom(file);
  ASSERT_TRUE(read.model) << read.said;
  const auto& links = read.model->links;
  EXPECT_TRUE(links[0].isUnchecked() && links[1].isUnchecked() && links[4].isUnchecked());
  EXPECT_FALSE(links[2].isUnchecked() || links[3].isUnchecked());
  EXPECT_EQ(links[2].visuals.size(), 1u);
  EXPECT_EQ(links[3].collisions.size(), 1u) << "what is there of it is checked";
  for (const char* words : {"line 3: the mesh package://nowhere/a.stl does not exist", "ROS_PACKAGE_PATH", "cut.stl",
                            "not shown and not checked: 'a', 'b', 'e'", "the collision shape is shown for 'c'",
                            "only partly shown and checked: 'd'", "is outside the package"})
    EXPECT_THAT(read.said, HasSubstr(words));
}

TEST(UrdfOfStrangers, APictureOrNothingForAColorIsGrey) {
  const std::string box = "<geometry><box size=\"1 1 1\"/></geometry>";
  const auto grey = kinematics::LinkShape{}.color;
  for (const char* material : {"<material name=\"m\"><texture filename=\"x.png\"/></material>",
                               "<material name=\"m\"><color rgba=\"red\"/></material>"}) {
    const Read read = readBody(linkText("a", "<visual>" + box + material + "</visual>"));
    ASSERT_TRUE(read.model) << read.said;
    EXPECT_EQ(read.model->links[0].visuals.at(0).color, grey);
    EXPECT_THAT(read.said, HasSubstr("line 3: "));
  }
  const Read three =
      readBody(linkText("a", "<visual>" + box + "<material name=\"m\"><color rgba=\"1 0 0\"/></material></visual>"));
  ASSERT_TRUE(three.model);
  EXPECT_EQ(three.model->links[0].visuals.at(0).color, (std::array<float, 4>{1, 0, 0, 1}));
}

TEST(UrdfOfStrangers, AnIdleLinkIsLeftOutAndANamelessRobotTakesTheFilesName) {
  const Read idle = readBody(kPair + jointText("j", "a", "b") + linkText("idle"));
  ASSERT_TRUE(idle.model) << idle.said;
  EXPECT_EQ(idle.model->links.size(), 2u);
  EXPECT_THAT(idle.said, HasSubstr("line 6: no joint names the link 'idle'"));
  const hapticell::test::TemporaryFolder folder;
  const Read nameless = readFrom(folder.write("arm.urdf", "<robot><link name=\"a\"/></robot>"));
  ASSERT_TRUE(nameless.model) << nameless.said;
  EXPECT_EQ(nameless.model->name, "arm");
}

TEST(UrdfOfStrangers, PackagesAreFoundUnderAnyName) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("arm-main/meshes/visual/t.stl", test::tetrahedronStl());
  folder.write("parts_description-1.2/meshes/p.stl", test::tetrahedronStl());
  folder.write("other/meshes/visual/q.stl", test::tetrahedronStl());
  const auto read = [&](const std::string& uri) {
    return readFrom(folder.write("arm-main/urdf/arm.urdf", robotText(linkText("a", meshText("visual", uri)))));
  };
  const std::vector<std::pair<std::string, std::string>> found = {
      {"package://arm_description/meshes/visual/t.stl", "arm-main"},
      {"package://arm_description/arm/meshes/visual/t.stl", "arm-main"},
      {"file://package://arm_description/meshes/visual/t.stl", "arm-main"},
      {"package://Parts_Description/meshes/p.stl", "parts_description-1.2"}};
  for (const auto& [uri, taken] : found) {
    const Read one = read(uri);
    ASSERT_TRUE(one.model) << one.said;
    EXPECT_EQ(one.model->links[0].visuals.size(), 1u) << uri << one.said;
    EXPECT_THAT(one.said, HasSubstr(taken)) << "what was assumed is told";
  }
  for (const char* uri :
       {"package://arm_description/meshes/visual/q.stl", "package://x/t.stl", "package://x//etc/hostname",
        "package://x/etc/hostname", "package://x/%2e%2e/%2e%2e/etc/hostname"}) {
    const Read none = read(uri);
    ASSERT_TRUE(none.model) << none.said;
    EXPECT_TRUE(none.model->links[0].isUnchecked()) << uri;
  }
}

TEST(UrdfOfStrangers, ReferencesMayBePercentEncoded) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("pkg/package.xml", "<package><name>pkg</name></package>");
  folder.write("pkg/meshes/Wedge One.stl", test::tetrahedronStl());
  folder.write("pkg/geh\u00e4use.stl", test::tetrahedronStl());
  folder.write("pkg/100%25.stl", test::tetrahedronStl());
  folder.write("50%.stl", test::tetrahedronStl());
  for (const std::string uri :
       {"package://pkg/meshes/Wedge%20One.stl", "package://pkg/geh%C3%A4use.stl", "pkg/meshes/Wedge%20One.stl",
        "pkg/meshes/Wedge One.stl", "pkg\\meshes\\Wedge One.stl", "pkg/100%25.stl", "50%.stl",
        "file://@/pkg/meshes/Wedge%20One.stl", "file://localhost@/50%25.stl"}) {
    std::string whole = uri;
    if (const auto at = whole.find('@'); at != std::string::npos) whole.replace(at, 1, folder.path().string());
    const Read read = readFrom(folder.write("r.urdf", robotText(linkText("a", meshText("visual", whole)))));
    ASSERT_TRUE(read.model) << read.said;
    EXPECT_EQ(read.model->links[0].visuals.size(), 1u) << uri << read.said;
  }
}

TEST(UrdfOfStrangers, AFaultInAXacroNamesTheFileAndLineThatSaysIt) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("m.xacro",
               "<robot xmlns:xacro=\"x\">\n<xacro:macro name=\"arm\" params=\"t\">\n<link name=\"a\"/><link "
               "name=\"b\"/>\n<joint name=\"j\" type=\"${t}\"><parent link=\"a\"/><child "
               "link=\"b\"/></joint>\n</xacro:macro></robot>");
  const Read read = readFrom(folder.write(
      "r.xacro",
      "<robot name=\"r\" xmlns:xacro=\"x\">\n<xacro:include filename=\"m.xacro\"/>\n<xacro:arm t=\"screw\"/></robot>"));
  EXPECT_FALSE(read.model);
  EXPECT_THAT(read.said, HasSubstr("m.xacro, line 4: joint 'j' has the type 'screw'"));
}

TEST(UrdfOfStrangers, WhatIsLeftOfMacrosAndTheWorldWithoutLinkRefuseNoRobot) {
  const Read calls = readBody("<!-- <xacro:macro name='grey'/> -->" + limited("<limit lower=\"-1\" upper=\"1\"/>") +
                              "<xacro:sensors usb=\"1\"/>\n<xacro:grey/><xacro:grey/>");
  ASSERT_TRUE(calls.model) << calls.said;
  EXPECT_EQ(calls.model->dof(), 1u);
  EXPECT_THAT(calls.said, HasSubstr("<xacro:grey> is left out (2 times)"));
  EXPECT_THAT(calls.said, HasSubstr("<xacro:sensors> is left out (1 time)"));

  const Read world = readBody(linkText("a") + jointText("j", "world", "a", "prismatic",
                                                        "<axis xyz=\"1 0 0\"/><limit lower=\"0\" upper=\"1\"/>"));
  ASSERT_TRUE(world.model) << world.said;
  EXPECT_EQ(world.model->links[0].name, "world");
  EXPECT_EQ(world.model->dof(), 1u);
  EXPECT_THAT(world.said, HasSubstr("joint 'j' is attached to 'world'"));
  EXPECT_FALSE(readBody(linkText("a") + jointText("j", "body", "a", "fixed", "")).model) << "another link is missed";
}

TEST(UrdfOfStrangers, CommasBetweenNumbersAndZerosBehindTheEndAreRead) {
  const auto at = [](const std::string& xyz) {
    return readBody(kPair + jointText("j", "a", "b", "fixed", "<origin xyz=\"" + xyz + "\" rpy=\"0 0 0\"/>"));
  };
  const Read read = at("0.07, 0, -0.69");
  ASSERT_TRUE(read.model) << read.said;
  EXPECT_EQ(read.model->joints[0].X_PJ.p, dvec3(0.07, 0.0, -0.69));
  for (const char* wrong : {"0,07 0 0", "1,2 3", ", 0 0", "0 0 0,,", "0, 0"}) EXPECT_FALSE(at(wrong).model) << wrong;
  const hapticell::test::TemporaryFolder folder;
  const std::string text = robotText(linkText("a"));
  EXPECT_TRUE(readFrom(folder.write("z.urdf", text + std::string("\0\n\0", 3))).model);
  EXPECT_FALSE(readFrom(folder.write("y.urdf", text + std::string("\0<", 2))).model);
}

TEST(UrdfOfStrangers, TheKindIsToldByTheFirstElementNotByAComment) {
  const hapticell::test::TemporaryFolder folder;
  const auto kind = [&](const std::string& name, const std::string& text) {
    return robotFormatOf(folder.write(name, text));
  };
  EXPECT_EQ(kind("a.sdf", "<?xml version='1.0'?><!-- made of a <robot> --><sdf version='1.6'/>"), RobotFormat::kSdf);
  EXPECT_EQ(kind("b.urdf", "<!DOCTYPE robot><!-- <sdf> <xacro:macro> --><robot name='r'/>"), RobotFormat::kUrdf);
  EXPECT_EQ(kind("c.xml", "\xEF\xBB\xBF<robot name='r'><xacro:property name='p' value='1'/></robot>"),
            RobotFormat::kXacro);
  EXPECT_EQ(kind("d.urdf", "<robot name='r'><xacro:grey/></robot>"), RobotFormat::kUrdf) << "nothing is defined in it";
  EXPECT_EQ(kind("g.urdf", "<robot name='r'><link name='$(optenv NAME a)'/></robot>"), RobotFormat::kXacro);
  EXPECT_EQ(kind("e.xml", "<!-- <robot> never ends"), std::nullopt);
  EXPECT_EQ(kind("f.xml", "<note><robot/></note>"), std::nullopt);
}

TEST(UrdfOfStrangers, APackageFolderThatAXacroTakesUnderAnotherNameIsReported) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("gate-main/parts/m.xacro", "<robot xmlns:xacro=\"x\"><link name=\"a\"/></robot>");
  const Read read = readFrom(folder.write("gate-main/urdf/r.xacro",
                                          "<robot name=\"r\" xmlns:xacro=\"x\"><xacro:include "
                                          "filename=\"$(find gate_description)/parts/m.xacro\"/></robot>"));
  ASSERT_TRUE(read.model) << read.said;
  EXPECT_THAT(read.said,
              HasSubstr((folder.path() / "gate-main").string() + " is used, because it contains the rest of the path"));
}

}  // namespace
}  // namespace hapticell::workcell
