// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/urdf_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/kinematics/model/test_robots.h"
#include "tests/support/test_data.h"
#include "tests/workcell/robots/urdf_text.h"
#include "workcell/text/package_path.h"

namespace hapticell::workcell {
namespace {

using kinematics::JointType;
using kinematics::RobotModel;
using test::jointText;
using test::linkText;
using test::meshText;
using test::robotText;
using ::testing::HasSubstr;

std::optional<std::filesystem::path> pathOf(const std::string& uri, const std::filesystem::path& folder) {
  const auto found = findReference(uri, folder);
  return found ? std::optional(found->path) : std::nullopt;
}

Expected<RobotModel> readText(const hapticell::test::TemporaryFolder& folder, const std::string& text,
                              Diagnostics& diagnostics) {
  return readUrdf(folder.write("robot.urdf", text), diagnostics);
}

TEST(UrdfReader, OrdersJointsFromBaseToTipWhateverTheFile) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto model =
      readText(folder,
               robotText(jointText("z", "b", "c") + linkText("c") + linkText("b") + linkText("a") +
                         jointText("y", "a", "b", "continuous", "<axis xyz=\"0 2 0\"/>") +
                         jointText("x", "c", "d", "fixed", "<origin xyz=\"1 2 3\" rpy=\"0 0 1.5707963267948966\"/>") +
                         linkText("d")),
               diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->links[0].name, "a");
  ASSERT_EQ(model->joints.size(), 3u);
  EXPECT_EQ(model->joints[0].name, "y");
  EXPECT_EQ(model->joints[1].name, "z");
  EXPECT_EQ(model->dof(), 2u);
  EXPECT_EQ(model->joints[0].type, JointType::kContinuous);
  EXPECT_TRUE(std::isinf(model->joints[0].upper));
  EXPECT_NEAR(glm::length(model->joints[0].axis_J - dvec3(0, 1, 0)), 0.0, 1e-15);
  EXPECT_EQ(model->joints[1].velocity, 2.0);
  EXPECT_NEAR(glm::length(model->joints[2].X_PJ * dvec3(1, 0, 0) - dvec3(1, 3, 3)), 0.0, 1e-12);
  EXPECT_EQ(model->defaultTip(), model->findLink("d"));
  EXPECT_TRUE(diagnostics.warnings.empty());
}

TEST(UrdfReader, OnlyDirectChildrenOfRobotAreJoints) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto model = readText(folder,
                              robotText(linkText("a") + linkText("b") + jointText("j", "a", "b") +
                                        "<ros2_control name=\"c\" type=\"system\"><joint name=\"j\"/></ros2_control>\n"
                                        "<transmission name=\"t\"><joint name=\"j\"/></transmission>\n"),
                              diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->joints.size(), 1u);
}

TEST(UrdfReader, MimicChainsEndAtTheJointThatMoves) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string axis = "<axis xyz=\"0 0 1\"/>";
  const auto model = readText(folder,
                              robotText(linkText("a") + linkText("b") + linkText("c") + linkText("d") +
                                        jointText("last", "c", "d", "continuous",
                                                  axis + "<mimic joint=\"middle\" multiplier=\"2\" offset=\"0.5\"/>") +
                                        jointText("middle", "b", "c", "continuous",
                                                  axis + "<mimic joint=\"first\" multiplier=\"-3\" offset=\"0.1\"/>") +
                                        jointText("first", "a", "b", "continuous", axis)),
                              diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(model->dof(), 1u);
  const auto& last = model->joints[static_cast<std::size_t>(model->findJoint("last"))];
  EXPECT_EQ(model->joints[static_cast<std::size_t>(last.mimic->joint)].name, "first");
  // last = 2 (-3 q + 0.1) + 0.5
  EXPECT_NEAR(kinematics::jointPosition(*model, {0.7}, last), 2 * (-3 * 0.7 + 0.1) + 0.5, 1e-12);
}

TEST(UrdfReader, ShapesHaveSizeColourAndPlace) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("t.stl", test::tetrahedronStl());
  Diagnostics diagnostics;
  const auto model = readText(
      folder,
      robotText("<material name=\"red\"><color rgba=\"1 0 0 0.5\"/></material>\n" +
                linkText("a",
                         "<visual><origin xyz=\"0 0 1\"/><geometry><cylinder radius=\"0.5\" length=\"2\"/></geometry>"
                         "<material name=\"red\"/></visual>" +
                             meshText("collision", "t.stl", "scale=\"0.001 0.002 -0.003\"") +
                             "<collision><geometry><box size=\"1 2 3\"/></geometry></collision>")),
      diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  const auto& link = model->links[0];
  ASSERT_EQ(link.visuals.size(), 1u);
  EXPECT_EQ(link.visuals[0].color, (std::array<float, 4>{1, 0, 0, 0.5f}));
  EXPECT_EQ(link.visuals[0].source, "cylinder");
  EXPECT_EQ(link.visuals[0].X_LS.p, dvec3(0, 0, 1));
  EXPECT_NEAR(link.visuals[0].mesh->bounds().max.z, 1.0, 1e-12);
  ASSERT_EQ(link.collisions.size(), 2u);
  const auto& mesh = *link.collisions[0].mesh;
  EXPECT_NEAR(mesh.bounds().max.x, 0.001, 1e-15);
  EXPECT_NEAR(mesh.bounds().max.y, 0.002, 1e-15);
  EXPECT_NEAR(mesh.bounds().min.z, -0.003, 1e-15);
  double volume = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    volume += glm::dot(mesh.corner(t, 0), glm::cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6.0;
  }
  EXPECT_NEAR(volume, 0.001 * 0.002 * 0.003 / 6.0, 1e-18) << "a mirrored mesh keeps its outside outside";
}

/// A mesh that is written inside out is named, mirrored or not.
TEST(UrdfReader, AMeshThatFacesInwardIsTold) {
  for (const char* scale : {"", "scale=\"1 1 -1\""}) {
    const hapticell::test::TemporaryFolder folder;
    folder.write("good.stl", test::tetrahedronStl());
    folder.write("inward.stl", test::tetrahedronStl(true));
    Diagnostics diagnostics;
    const auto model = readText(
        folder,
        robotText(linkText("a", meshText("visual", "good.stl", scale) + meshText("collision", "inward.stl", scale))),
        diagnostics);
    ASSERT_TRUE(model) << model.error().message();
    std::string told;
    for (const Text& warning : diagnostics.warnings) {
      if (english(warning).find("face inward") != std::string::npos) told += english(warning);
    }
    EXPECT_EQ(told.find("inward.stl: the triangles face inward"), 0u) << told;
  }
}

TEST(UrdfReader, OneFileIsReadOnceAndUnreadableVisualsAreToldAndReplaced) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("t.stl", test::tetrahedronStl());
  folder.write("t.dae", "<COLLADA/>");
  Diagnostics diagnostics;
  const std::string both = meshText("visual", "t.dae") + meshText("collision", "t.stl");
  const auto model =
      readText(folder,
               robotText(linkText("a", both) + linkText("b", both) + linkText("c", meshText("visual", "t.dae")) +
                         linkText("d", meshText("visual", "t.stl")) + jointText("j", "a", "b") +
                         jointText("k", "b", "c") + jointText("l", "c", "d")),
               diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->links[0].visuals.at(0).mesh, model->links[1].collisions.at(0).mesh);
  EXPECT_EQ(model->links[3].collisions.size(), 1u) << "without a collision shape the visual one is checked";
  EXPECT_TRUE(model->links[2].visuals.empty());
  std::string all;
  for (const Text& warning : diagnostics.warnings) all += english(warning) + "\n";
  EXPECT_THAT(all, HasSubstr("the collision shape is shown for 'a', 'b'"));
  EXPECT_THAT(all, HasSubstr("not checked: 'c'"));
  EXPECT_THAT(all, HasSubstr("line 3: the shape is left out: "));
  EXPECT_THAT(all, HasSubstr("t.dae"));
  EXPECT_THAT(all, Not(HasSubstr("convert"))) << "the file is at fault, not its format";
}

TEST(UrdfReader, AMaterialDefinedNowhereIsGreyAndTold) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string visual = "<visual><geometry><sphere radius=\"1\"/></geometry><material name=\"m\"/></visual>";
  const auto model = readText(folder, robotText(linkText("a", visual)), diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->links[0].visuals.at(0).color, kinematics::LinkShape{}.color);
  ASSERT_EQ(diagnostics.warnings.size(), 1u);
  EXPECT_THAT(english(diagnostics.warnings[0]), HasSubstr("line 3: the material 'm'"));
}

TEST(PackagePath, FindsPackagesByFolderByManifestAndByEnvironment) {
  const hapticell::test::TemporaryFolder folder, elsewhere;
  folder.write("by_folder/meshes/a.stl", "x");
  folder.write("other_name/package.xml", "<package><name>by_manifest</name></package>");
  folder.write("other_name/meshes/a.stl", "x");
  folder.write("other_name/urdf/r.urdf", "x");
  folder.write("with space/a.stl", "x");
  elsewhere.write("by_environment/a.stl", "x");
  const auto urdf_folder = folder.path() / "other_name" / "urdf";
  EXPECT_EQ(pathOf("package://by_folder/meshes/a.stl", urdf_folder), folder.path() / "by_folder/meshes/a.stl");
  EXPECT_EQ(pathOf("package://by_manifest/meshes/a.stl", urdf_folder), folder.path() / "other_name/meshes/a.stl");
  EXPECT_EQ(pathOf("package://by_manifest/meshes/a.stl", folder.path()), folder.path() / "other_name/meshes/a.stl");
  EXPECT_EQ(pathOf("../meshes/a.stl", urdf_folder), folder.path() / "other_name/meshes/a.stl");
  const auto absolute = folder.path() / "with space/a.stl";
  EXPECT_EQ(pathOf("file://" + absolute.string(), urdf_folder), absolute);
  EXPECT_EQ(pathOf(absolute.string(), urdf_folder), absolute);
  EXPECT_FALSE(pathOf("package://by_environment/a.stl", urdf_folder));
  ::setenv("ROS_PACKAGE_PATH", ("/nowhere:" + elsewhere.path().string()).c_str(), 1);
  EXPECT_EQ(pathOf("package://by_environment/a.stl", urdf_folder), elsewhere.path() / "by_environment/a.stl");
  ::unsetenv("ROS_PACKAGE_PATH");
  EXPECT_FALSE(pathOf("package://", urdf_folder));
  EXPECT_FALSE(pathOf("", urdf_folder));
}

TEST(PackagePath, StaysInThePackage) {
  const hapticell::test::TemporaryFolder folder;
  folder.write("pack/meshes/a.stl", "x");
  folder.write("secret.stl", "x");
  const auto here = folder.path() / "pack";
  EXPECT_TRUE(pathOf("package://pack/meshes/../meshes/a.stl", here));
  for (const char* uri : {"package://pack/../secret.stl", "package://../secret.stl", "package://./secret.stl",
                          "model://pack/meshes/../../secret.stl", "package://pack/../../../../../../etc/passwd"}) {
    EXPECT_TRUE(leavesPackage(uri)) << uri;
    EXPECT_FALSE(pathOf(uri, here)) << uri;
  }
  EXPECT_FALSE(leavesPackage("../meshes/a.stl")) << "a plain path is the user's own";
}

TEST(PackagePath, FollowsTheLinksOfAWorkspaceAndNoBorrowedName) {
  const hapticell::test::TemporaryFolder folder;
  const auto source = folder.write("source/pack/meshes/a.stl", "x");
  const auto secret = folder.write("id_rsa", "x");
  folder.write("install/pack/meshes/b.stl", "x");
  const auto meshes = folder.path() / "install/pack/meshes";
  std::filesystem::create_symlink(source, meshes / "a.stl");
  std::filesystem::create_symlink("b.stl", meshes / "c.stl");
  std::filesystem::create_symlink(secret, meshes / "d.stl");
  std::filesystem::create_symlink("e.stl", meshes / "e.stl");
  std::filesystem::create_symlink("/dev/zero", meshes / "f.stl");
  const auto here = folder.path() / "install/pack";
  EXPECT_TRUE(pathOf("package://pack/meshes/a.stl", here)) << "as build tools of ROS 2 make them";
  EXPECT_TRUE(pathOf("package://pack/meshes/b.stl", here));
  EXPECT_TRUE(pathOf("package://pack/meshes/c.stl", here)) << "within the package";
  EXPECT_FALSE(pathOf("package://pack/meshes/d.stl", here)) << "another file under a borrowed name";
  EXPECT_FALSE(pathOf("package://pack/meshes/e.stl", here)) << "a ring";
  EXPECT_FALSE(pathOf("package://pack/meshes/f.stl", here)) << "a device without end";
}

struct RealRobot {
  std::string folder;
  std::size_t dof;
  std::string tip;
};

class RealUrdf : public ::testing::TestWithParam<RealRobot> {};

TEST_P(RealUrdf, IsReadWithAllItsMeshes) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "robots/" + GetParam().folder + "/robot.urdf");
  Diagnostics diagnostics;
  const auto model = readUrdf(file, diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->dof(), GetParam().dof);
  EXPECT_EQ(model->links[static_cast<std::size_t>(model->defaultTip())].name, GetParam().tip);
  for (const auto& link : model->links) {
    for (const auto& shape : link.collisions) EXPECT_FALSE(shape.mesh->triangles.empty()) << link.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, RealUrdf,
                         ::testing::Values(RealRobot{"kuka_kr120r2500pro", 6, "tool0"},
                                           RealRobot{"abb_irb4600_60_205", 6, "tool0"},
                                           RealRobot{"fanuc_lrmate200id", 6, "tool0"}, RealRobot{"ur5e", 6, "tool0"},
                                           RealRobot{"franka_fer", 8, "fer_hand_tcp"},
                                           RealRobot{"denso_hsr065_scara", 4, "J4"}),
                         [](const auto& case_info) { return case_info.param.folder; });

// The maker's URDF and the arm built here from its published table agree, whatever their authors' choice of frames.
TEST(RealUrdf, Ur5eAndKr120AgreeWithTheirTables) {
  HAPTICELL_SHARED_DATA_OR_SKIP(ur_file, "robots/ur5e/robot.urdf");
  HAPTICELL_SHARED_DATA_OR_SKIP(kuka_file, "robots/kuka_kr120r2500pro/robot.urdf");
  Diagnostics diagnostics;
  const auto ur = readUrdf(ur_file, diagnostics), kuka = readUrdf(kuka_file, diagnostics);
  ASSERT_TRUE(ur && kuka);
  const RobotModel ur_table = kinematics::test::ur5e(), kuka_table = kinematics::test::kr120();
  std::mt19937_64 random(5);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> q = kinematics::test::randomJoints(kuka_table, random);
    const Pose X_kuka = kinematics::test::tipPose(*kuka, q, kuka->findLink("tool0"));
    const Twist kuka_apart =
        difference(X_kuka, kinematics::test::tipPose(kuka_table, q, kuka_table.findLink("flange")));
    EXPECT_LT(glm::length(kuka_apart.linear) + glm::length(kuka_apart.angular), 1e-9);
    // The UR's base_link looks the other way than its controller's base: half a turn about z.
    const Pose X_ur = kinematics::test::tipPose(*ur, q, ur->findLink("tool0"));
    const Pose X_turned = Pose::rotation(glm::angleAxis(std::numbers::pi, dvec3(0, 0, 1))) * X_ur;
    const Twist ur_apart = difference(X_turned, kinematics::test::tipPose(ur_table, q, ur_table.findLink("flange")));
    EXPECT_LT(glm::length(ur_apart.linear) + glm::length(ur_apart.angular),
              1e-6);  // the URDF's angles carry nine digits
  }
}

}  // namespace
}  // namespace hapticell::workcell
