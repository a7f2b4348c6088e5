// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>

#include "geometry/shapes/mass_properties.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/chain_report.h"
#include "tests/support/test_data.h"
#include "tests/workcell/robots/urdf_text.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_library.h"
#include "workcell/robots/robot_reader.h"

namespace hapticell::workcell {
namespace {

const std::string kHead = "format = \"hapticell-robot\"\nversion = 1\nname = \"arm\"\nunit = \"mm\"\n";
const std::string kSix = "[joints]\nlower = [-90, -90, -90, -90, -90, -90]\nupper = [90, 90, 90, 90, 90, 90]\n";
const std::string kOpw = "[opw]\na1 = 50\nc1 = 330\nc2 = 330\nc3 = 335\nc4 = 80\n";

std::string refused(const std::string& name, const std::string& text) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics notes;
  const auto robot = readRobot(folder.write(name, text), notes);
  return robot ? "" : robot.error().message();
}

TEST(RobotToml, ReadsLengthsInItsUnitAndAnglesInDegrees) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics notes;
  const std::string tool = "[[tool]]\nname = \"gun\"\nposition = [0, 0, 200]\nrpy = [180, 0, 0]\n";
  const auto robot = readRobot(folder.write("robot.toml", kHead + kOpw + kSix + tool), notes);
  ASSERT_TRUE(robot) << robot.error().message();
  EXPECT_NEAR(robot->model.joints[0].upper, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(robot->model.joints[1].X_PJ.p.z, 0.330, 1e-12);
  ASSERT_EQ(robot->tools.size(), 1u);
  EXPECT_NEAR(robot->tools[0].X_LT.p.z, 0.2, 1e-12);
  EXPECT_NEAR(robot->tools[0].X_LT.rotate({0, 0, 1}).z, -1.0, 1e-12);
  EXPECT_FALSE(robot->model.links[2].visuals.empty()) << "a body is made";
}

/// Two boxes of twelve triangles each; what is only for collision checks is not counted.
TEST(RobotFiles, AnImportReportsTheTrianglesThatAreShown) {
  const hapticell::test::TemporaryFolder folder;
  const std::string box = "<geometry><box size='0.1 0.1 0.4'/></geometry>";
  const std::string shown = "<visual>" + box + "</visual>";
  const std::filesystem::path file =
      folder.write("arm.urdf", "<robot name='arm'><link name='foot'>" + shown + "<collision>" + box + "</collision></link><link name='boom'>" + shown +
                                   "</link><joint name='j' type='revolute'><parent link='foot'/><child link='boom'/><axis xyz='0 0 1'/>"
                                   "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>");
  Diagnostics notes;
  const auto read = EntityLoader(folder.path()).loadTree(file.string(), {}, notes);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->report.parts, 1u);
  EXPECT_EQ(read->report.triangles, 24u);
}

TEST(RobotToml, FaultsAreToldInOneSentenceWithFileAndLine) {
  struct Fault {
    std::string text;
    const char* said;
  };
  const std::string six_short = "[joints]\nlower = [-90, -90]\nupper = [90, 90]\n";
  const std::string reversed = "[joints]\nlower = [-90, 95, -90, -90, -90, -90]\nupper = [90, 90, 90, 90, 90, 90]\n";
  const std::string one = "[joints]\nlower = [-9]\nupper = [9]\n";
  const Fault faults[] = {
      {"name = \"x\"\n", "format is missing"},
      {kHead + "[opw\n", "not TOML"},
      {kHead, "no table defines how the robot moves"},
      {kHead + kOpw + "[dh]\nconvention = \"standard\"\n" + kSix, "both [opw] and [dh]"},
      {kHead + "[opw]\nc1 = 1\n" + kSix, "c2 is missing"},
      {kHead + "[opw]\na1 = \"far\"\nc1 = 1\nc2 = 1\nc3 = 1\nc4 = 1\n" + kSix, "a1 is a text"},
      {kHead + kOpw + "c9 = 4\n" + kSix, "the unknown key 'c9'"},
      {kHead + kOpw + six_short, "2 numbers in lower"},
      {kHead + kOpw + reversed, "'joint_2' has a lower limit above its upper limit"},
      {kHead + kOpw + "signs = [1, 1, 1, 1, 1, 2]\n" + kSix, "invalid signs"},
      {kHead + "[[chain]]\naxis = [0, 0, 0]\n" + one, "an axis of length zero"},
      {kHead + "[[chain]]\ntype = \"helical\"\n" + one, "type = \"helical\""},
      {kHead + "[dh]\nconvention = \"mine\"\nd = [1]\na = [1]\nalpha = [1]\n" + one, "one of standard, modified"},
      {kHead + "[dh]\nconvention = \"standard\"\nd = [1]\na = [1, 2]\nalpha = [1]\n" + one, "unequal length"},
      {kHead + "[delta]\nbase_radius = 100\nupper_arm = 1\nlower_arm = 5\nplatform_radius = 50\n[joints]\nlower = "
               "[0,0,0]\nupper = [9,9,9]\n",
       "do not reach the platform"},
      {kHead + "[hexapod]\nbase = [[0,0,0]]\nplatform = [[0,0,0]]\nhome = {}\n" + kSix, "1 and 1 joints"},
      {kHead + "[urdf]\nfile = \"nowhere.urdf\"\n", "nowhere.urdf"},
      {kHead + kOpw + kSix + "[[tool]]\nname = \"gun\"\nposition = [1e200, 0, 0]\n", "a position that is too far away"},
  };
  for (const Fault& fault : faults) {
    const std::string said = refused("robot.toml", fault.text);
    EXPECT_NE(said.find(fault.said), std::string::npos) << fault.said << " / " << said;
    EXPECT_NE(said.find("robot.toml"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  EXPECT_NE(refused("robot.toml", kHead + kOpw + reversed).find("line 12"), std::string::npos)
      << refused("robot.toml", kHead + kOpw + reversed);
}

TEST(RobotLibrary, EveryRobotLoadsIsSolvedAndNamesItsSource) {
  Diagnostics notes;
  const auto robots = listLibraryRobots(notes);
  EXPECT_TRUE(notes.warnings.empty());
  EXPECT_GE(robots.size(), 20u);
  EntityLoader loader(".");
  for (const LibraryRobot& robot : robots) {
    EXPECT_FALSE(robot.sheet.source.empty()) << robot.name;
    const auto entity = loader.load("library:" + robot.name, 1.0, notes);
    ASSERT_TRUE(entity) << entity.error().message();
    const auto& model = *entity->robot();
    const int tip = model.defaultTip();
    const auto inverse = kinematics::createInverse(model, tip);
    ASSERT_TRUE(inverse) << robot.name;
    const std::vector<double> rest = kinematics::restPositions(model);
    if (const kinematics::Chain* chain = (*inverse)->chain(); chain && robot.file.extension() == ".toml") {
      kinematics::ChainPositions x{};
      for (std::size_t k = 0; k < chain->size(); ++k) x[k] = rest[static_cast<std::size_t>(chain->variables()[k])];
      EXPECT_FALSE(kinematics::chainIsSingular(*chain, x)) << robot.name << " starts where it can hardly be dragged";
    }
    std::vector<double> q = rest;
    for (std::size_t k = 0; k < q.size(); ++k) {
      const auto& joint = model.joints[static_cast<std::size_t>(model.moving[k])];
      const double step = joint.type == kinematics::JointType::kPrismatic ? 0.02 : 0.1;
      q[k] = std::clamp(rest[k] + (k % 2 ? step : -step), joint.lower, joint.upper);
    }
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(model, q, X_BL);
    const auto solution = (*inverse)->solve(X_BL[static_cast<std::size_t>(tip)], rest);
    EXPECT_EQ(solution.status, kinematics::InverseStatus::kSolved) << robot.name;
    EXPECT_LT(solution.position_error, 1e-8) << robot.name;
    std::size_t triangles = 0;
    for (const auto& link : model.links) {
      for (const auto& shape : link.collisions) triangles += shape.mesh->triangles.size();
    }
    EXPECT_GT(triangles, 100u) << robot.name;
    EXPECT_LT(triangles, 20000u) << robot.name;
  }
  const auto none = loader.load("library:none", 1.0, notes);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message().find("no robot of this name"), std::string::npos);
}

TEST(Sdf, AHexapodWithItsLoopsIsReadAndFollowsPoses) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "robots/stewart_6ups_sdf/robot.sdf");
  Diagnostics notes;
  const auto robot = readRobot(file, notes);
  ASSERT_TRUE(robot) << robot.error().message();
  const auto& model = robot->model;
  EXPECT_EQ(model.dof(), 6u);
  EXPECT_EQ(model.links[static_cast<std::size_t>(model.defaultTip())].name, "platform_link");
  const auto inverse = kinematics::createInverse(model, model.defaultTip()).value();
  const std::vector<double> rest = kinematics::restPositions(model);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(model, rest, X_BL);
  Pose X = X_BL[static_cast<std::size_t>(model.defaultTip())];
  X.p += dvec3(0.05, -0.04, 0.2);
  X.q = glm::angleAxis(0.1, glm::normalize(dvec3(1, 1, 1))) * X.q;
  const auto solution = inverse->solve(X, rest);
  ASSERT_EQ(solution.status, kinematics::InverseStatus::kSolved);
  kinematics::forwardKinematics(model, solution.q, X_BL);
  const Twist left = difference(X_BL[static_cast<std::size_t>(model.defaultTip())], X);
  EXPECT_LT(glm::length(left.linear) + glm::length(left.angular), 1e-8);
}

std::string sdf(const std::string& joint) {
  return "<sdf version=\"1.7\"><model name=\"m\"><link name=\"base\"/><link name=\"arm\"><pose>0 0 1 0 0 "
         "0</pose></link>" +
         joint + "</model></sdf>";
}

TEST(Sdf, FaultsAreToldInOneSentence) {
  const auto joint = [](const std::string& type, const std::string& inside) {
    return sdf("<joint name=\"j\" type=\"" + type + "\"><parent>base</parent><child>arm</child>" + inside + "</joint>");
  };
  struct Fault {
    std::string text;
    const char* said;
  };
  const Fault faults[] = {
      {"<sdf version=\"1.7\"><model", "robot.sdf"},
      {"<sdf version=\"1.7\"></sdf>", "no model"},
      {sdf(""), "no joint connects it"},
      {joint("helical", "<axis><xyz>0 0 1</xyz></axis>"), "robot.sdf"},
      {joint("revolute", "<axis><xyz>0 0 0</xyz></axis>"), "robot.sdf"},
      {joint("revolute", "<axis><xyz>0 0 1</xyz><limit><lower>2</lower><upper>1</upper></limit></axis>"),
       "above its upper limit"},
      {sdf("<joint name=\"j\" type=\"fixed\"><parent>base</parent><child>leg</child></joint>"), "robot.sdf"},
  };
  for (const Fault& fault : faults) {
    const std::string said = refused("robot.sdf", fault.text);
    EXPECT_FALSE(said.empty()) << fault.said;
    EXPECT_NE(said.find(fault.said), std::string::npos) << fault.said << " / " << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

/// Mirrored by its scale a mesh keeps its outside outside; written inside out it is named.
TEST(Sdf, AMeshFacesOutwardOrIsTold) {
  for (const bool inward : {false, true}) {
    const hapticell::test::TemporaryFolder folder;
    folder.write("part.stl", test::tetrahedronStl(inward));
    Diagnostics notes;
    const auto robot = readRobot(
        folder.write("robot.sdf",
                     "<sdf version=\"1.7\"><model name=\"m\"><link name=\"base\"><collision name=\"c\"><geometry><mesh>"
                     "<uri>part.stl</uri><scale>0.1 0.1 -0.2</scale></mesh></geometry></collision></link>"
                     "<link name=\"arm\"/><joint name=\"j\" type=\"revolute\"><parent>base</parent><child>arm</child>"
                     "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis></joint>"
                     "</model></sdf>"),
        notes);
    ASSERT_TRUE(robot) << robot.error().message();
    const auto& shapes = robot->model.links[0].collisions;
    ASSERT_EQ(shapes.size(), 1u);
    EXPECT_NEAR(geometry::massProperties(*shapes[0].mesh).volume, (inward ? -1.0 : 1.0) * 0.1 * 0.1 * 0.2 / 6.0, 1e-12);
    const bool told = english(notes.warnings).find("part.stl: the triangles face inward") != std::string::npos;
    EXPECT_EQ(told, inward);
  }
}

TEST(Kinematics, AreReadOfAUrdfWithoutItsMeshes) {
  const hapticell::test::TemporaryFolder folder;
  const auto file = folder.write(
      "arm.urdf",
      "<robot name='arm'><link name='a'><visual><geometry><mesh filename='gone.stl'/></geometry></visual></link>"
      "<link name='b'><collision><geometry><box size='1 1 1'/></geometry></collision></link><joint name='j' "
      "type='revolute'><parent link='a'/><child link='b'/><origin xyz='0 0 2'/><axis xyz='0 1 0'/><limit lower='-1' "
      "upper='2' velocity='3' effort='0'/></joint></robot>");
  Diagnostics notes;
  const auto robot = readRobot(file, notes, nullptr, RobotContent::kKinematics);
  ASSERT_TRUE(robot) << robot.error().message();
  ASSERT_EQ(robot->model.dof(), 1u);
  EXPECT_EQ(robot->model.joints[0].X_PJ.p, dvec3(0, 0, 2));
  EXPECT_EQ(robot->model.joints[0].upper, 2.0);
  for (const kinematics::Link& link : robot->model.links) {
    EXPECT_TRUE(link.visuals.empty() && link.collisions.empty()) << link.name;
  }
}

TEST(UrdfWithLoops, AnOpenDeltaIsSaidToBeOne) {
  const std::string head = "<robot name=\"d\"><link name=\"base\"/>";
  const auto leg = [](int n, int joints) {
    std::string text, below = "base";
    for (int j = 0; j < joints; ++j) {
      const std::string link = "l" + std::to_string(n) + std::to_string(j);
      text += R"(<link name=")" + link + R"("/><joint name="j)" + link;
      text += R"(" type="continuous"><parent link=")" + below;
      text += R"("/><child link=")" + link + R"("/><axis xyz="0 1 0"/></joint>)";
      below = link;
    }
    return text;
  };
  const auto hints = [&](const std::string& legs) {
    const hapticell::test::TemporaryFolder folder;
    Diagnostics notes;
    EXPECT_TRUE(readRobot(folder.write("d.urdf", head + legs + "</robot>"), notes));
    return std::count_if(notes.warnings.begin(), notes.warnings.end(),
                         [](const Text& note) { return english(note).find("have free ends") != std::string::npos; });
  };
  EXPECT_EQ(hints(leg(0, 3) + leg(1, 3) + leg(2, 3)), 1);
  EXPECT_EQ(hints(leg(0, 3) + leg(1, 3)), 0) << "two arms";
  EXPECT_EQ(hints(leg(0, 3) + leg(1, 3) + leg(2, 4)), 0);
  EXPECT_EQ(hints(leg(0, 6)), 0);
}

TEST(UrdfWithLoops, ADeltaTreeIsClosedByARobotToml) {
  HAPTICELL_SHARED_DATA_OR_SKIP(urdf, "robots/omnid_delta_tree/robot.urdf");
  const hapticell::test::TemporaryFolder folder;
  std::ifstream file(hapticell::test::sourceFile("examples/robots/omnid_delta_tree.toml"));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string beside = "file = \"robot.urdf\"";
  ASSERT_NE(text.find(beside), std::string::npos);
  text.replace(text.find(beside), beside.size(), "file = \"" + urdf.string() + "\"");
  Diagnostics notes;
  const auto robot = readRobot(folder.write("robot.toml", text), notes);
  ASSERT_TRUE(robot) << robot.error().message();
  ASSERT_EQ(robot->model.dof(), 3u);
  const auto inverse = kinematics::createInverse(robot->model, robot->model.defaultTip()).value();
  const std::vector<double> rest = kinematics::restPositions(robot->model);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(robot->model, rest, X_BL);
  Pose X = X_BL[static_cast<std::size_t>(robot->model.defaultTip())];
  EXPECT_GT(X.p.z, 0.1);
  X.p += dvec3(0.03, 0.02, 0.02);
  const auto solution = inverse->solve(X, rest);
  ASSERT_EQ(solution.status, kinematics::InverseStatus::kSolved);
  // The same Delta in closed form (library:omnid_delta) must agree.
  const auto closed = readRobot(findLibraryRobot("omnid_delta").value(), notes);
  const auto closed_inverse = kinematics::createInverse(closed->model, closed->model.findLink("platform")).value();
  const auto same = closed_inverse->solve({X.p, {1, 0, 0, 0}}, kinematics::restPositions(closed->model));
  ASSERT_EQ(same.status, kinematics::InverseStatus::kSolved);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(same.q[k]), std::abs(solution.q[k]), 1e-7);
}

const char* const kArm = R"(<robot name="arm"><link name="base"/><link name="upper"/><link name="tip"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
<joint name="end" type="fixed"><parent link="upper"/><child link="tip"/></joint></robot>)";

TEST(Srdf, GroupsPosesAndDisabledPairsComeFromTheFileBeside) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("arm.srdf", R"(<robot name="arm"><group name="all"><chain base_link="base" tip_link="tip"/></group>
<group_state name="home" group="all"><joint name="shoulder" value="0.5"/></group_state>
<disable_collisions link1="base" link2="upper" reason="Adjacent"/>
<disable_collisions link1="base" link2="ghost" reason="Never"/></robot>)");
  Diagnostics notes;
  const auto robot = readRobot(folder.write("robot.urdf", kArm), notes);
  ASSERT_TRUE(robot) << robot.error().message();
  ASSERT_EQ(robot->model.groups.size(), 1u);
  EXPECT_EQ(robot->model.groups[0].joints, (std::vector<int>{0, 1}));
  ASSERT_EQ(robot->model.disabled_pairs.size(), 1u);
  EXPECT_EQ(robot->model.disabled_pairs[0].reason, "Adjacent");
  EXPECT_EQ(kinematics::restPositions(robot->model), std::vector<double>{0.5});
  ASSERT_EQ(notes.warnings.size(), 1u);
  EXPECT_NE(english(notes.warnings[0]).find("ghost"), std::string::npos);
}

TEST(Srdf, AFaultNamesTheSrdf) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("arm.srdf", "<robot name=\"arm\"><group>");
  Diagnostics notes;
  const auto robot = readRobot(folder.write("robot.urdf", kArm), notes);
  ASSERT_FALSE(robot);
  EXPECT_NE(robot.error().message().find("arm.srdf"), std::string::npos) << robot.error().message();
}

}  // namespace
}  // namespace hapticell::workcell
