// SPDX-License-Identifier: Apache-2.0
// Makers' xacro files give the robots that the program xacro made of them (robot.urdf beside them).
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "workcell/robots/robot_reader.h"

namespace hapticell::xacro {
namespace {

struct RealXacro {
  const char *robot, *file;
  Arguments arguments;
};

void PrintTo(const RealXacro& one, std::ostream* out) {
  *out << one.robot;
}

class RealXacros : public ::testing::TestWithParam<RealXacro> {};

TEST_P(RealXacros, GiveTheRobotThatXacroMadeOfThem) {
  const std::string folder = std::string("robots/") + GetParam().robot + "/";
  HAPTICELL_SHARED_DATA_OR_SKIP(file, folder + GetParam().file);
  HAPTICELL_SHARED_DATA_OR_SKIP(plain, folder + "robot.urdf");
  Diagnostics diagnostics;
  const auto ours = workcell::readRobot(file, diagnostics, nullptr, workcell::RobotContent::kAll, GetParam().arguments);
  const auto theirs = workcell::readRobot(plain, diagnostics);
  ASSERT_TRUE(ours) << ours.error().message();
  ASSERT_TRUE(theirs) << theirs.error().message();
  ASSERT_EQ(ours->model.joints.size(), theirs->model.joints.size());
  for (std::size_t i = 0; i < ours->model.joints.size(); ++i) {
    const auto &a = ours->model.joints[i], &b = theirs->model.joints[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.type, b.type) << a.name;
    EXPECT_NEAR(glm::length(a.X_PJ.p - b.X_PJ.p), 0.0, 1e-12) << a.name;
    EXPECT_NEAR(std::abs(glm::dot(a.X_PJ.q, b.X_PJ.q)), 1.0, 1e-12) << a.name;
    EXPECT_NEAR(glm::length(a.axis_J - b.axis_J), 0.0, 1e-12) << a.name;
    if (std::isfinite(b.lower)) {
      EXPECT_NEAR(a.lower, b.lower, 1e-12) << a.name;
    }
    if (std::isfinite(b.upper)) {
      EXPECT_NEAR(a.upper, b.upper, 1e-12) << a.name;
    }
    EXPECT_NEAR(a.velocity, b.velocity, 1e-12) << a.name;
  }
  ASSERT_EQ(ours->model.links.size(), theirs->model.links.size());
  for (std::size_t i = 0; i < ours->model.links.size(); ++i) {
    const auto &a = ours->model.links[i], &b = theirs->model.links[i];
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.visuals.size(), b.visuals.size()) << a.name;
    ASSERT_EQ(a.collisions.size(), b.collisions.size()) << a.name;
    for (std::size_t k = 0; k < a.visuals.size(); ++k) EXPECT_EQ(a.visuals[k].source, b.visuals[k].source);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shared, RealXacros,
    ::testing::Values(RealXacro{"abb_irb4600_60_205", "abb_irb4600_support/urdf/irb4600_60_205.xacro", {}},
                      RealXacro{"fanuc_lrmate200id", "fanuc_lrmate200id_support/urdf/lrmate200id.xacro", {}},
                      RealXacro{"kuka_kr120r2500pro", "kuka_kr120_support/urdf/kr120r2500pro.xacro", {}},
                      RealXacro{"ur5e", "ur_description/urdf/ur.urdf.xacro", {{"ur_type", "ur5e"}, {"name", "ur5e"}}},
                      RealXacro{"denso_hsr065_scara",
                                "denso_robot_descriptions/urdf/denso_robot.urdf.xacro",
                                {{"model", "hsr065a1_n32"}}},
                      RealXacro{"franka_fer", "franka_description/robots/fer/fer.urdf.xacro", {}}),
    [](const auto& case_info) { return std::string(case_info.param.robot); });

}  // namespace
}  // namespace hapticell::xacro
