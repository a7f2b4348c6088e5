// SPDX-License-Identifier: Apache-2.0
// Every robot of the shared data, dragged by its tool centre point past what it can reach.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "tests/manipulation/session/test_cells.h"
#include "tests/support/test_data.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

struct Case {
  const char* name;
  const char* file;
  std::vector<double> start;  ///< Empty: its rest.
};

class SharedRobot : public testing::TestWithParam<Case> {};

/// The Delta's tree has no loops: the example of the project closes it.
std::string closedByExample(const std::filesystem::path& urdf, const hapticell::test::TemporaryFolder& folder) {
  std::ifstream file(hapticell::test::sourceFile("examples/robots/omnid_delta_tree.toml"));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string beside = "\"robot.urdf\"";
  text.replace(text.find(beside), beside.size(), '"' + urdf.string() + '"');
  return folder.write("robot.toml", text).string();
}

TEST_P(SharedRobot, IsDraggedAtItsJointsSpeedAndTellsWhyItStops) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, std::string("robots/") + GetParam().file);
  const hapticell::test::TemporaryFolder folder;
  const bool tree = std::string(GetParam().name) == "Delta";
  Diagnostics notes;
  auto robot = workcell::EntityLoader(".").load(tree ? closedByExample(file, folder) : file.string(), 1.0, notes);
  ASSERT_TRUE(robot) << robot.error().message();
  robot->id = 1;
  robot->name = "robot";
  robot->setJoints(GetParam().start.empty() ? kinematics::restPositions(*robot->robot()) : GetParam().start);
  // A circle, a turn, then straight out until it can go no further, and back.
  std::vector<test::Waypoint> way{{0.0, {0, 0, 0}}, {0.2, {0, 0, 0}}};
  for (int k = 0; k <= 8; ++k) {
    const double angle = std::numbers::pi / 4.0 * k;
    way.push_back(
        {0.3 + 0.08 * k, 0.03 * dvec3(std::cos(angle) - 1.0, std::sin(angle), 0.0), {0, 0, 0.1 * std::sin(angle)}});
  }
  way.push_back({1.7, {0.07, 0, 0}});
  way.push_back({2.1, {0.07, 0, 0}});
  way.push_back({2.9, {0, 0, 0}});
  way.push_back({3.4, {0, 0, 0}});
  SessionOptions options = test::sessionOf({*robot}, "robot", test::handThrough(way), 100.0, 0.0);
  options.axes.mode = AxesMode::kCell;
  options.scale = {ScaleLevel::kNumber, 20.0};
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_TRUE(report->end.held);
  EXPECT_LE(report->forces.penetration_max_m, 1e-6);
  EXPECT_LT(report->forces.force_max_step_n_per_ms, 1.0 + 1e-6);
  for (const JointUse& use : report->joints) {
    const kinematics::Joint& joint = robot->robot()->joints[static_cast<std::size_t>(use.joint)];
    EXPECT_LE(use.max_speed, use.greatest_speed * (1.0 + 1e-6)) << joint.name;
    EXPECT_GE(use.lowest, joint.lower - 1e-9) << joint.name;
    EXPECT_LE(use.highest, joint.upper + 1e-9) << joint.name;
  }
  EXPECT_FALSE(report->limits.empty()) << "1.4 m out of where it stood something must have held it";
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedRobot,
    testing::Values(Case{"KukaKr120", "kuka_kr120r2500pro/robot.urdf", {0.1, -1.4, 1.6, 0.2, 0.8, 0.1}},
                    Case{"AbbIrb4600", "abb_irb4600_60_205/robot.urdf", {0.1, 0.2, 0.2, 0.2, 0.8, 0.1}},
                    Case{"FanucLrMate", "fanuc_lrmate200id/robot.urdf", {0.1, 0.2, 0.2, 0.2, -0.8, 0.1}},
                    Case{"Ur5e", "ur5e/robot.urdf", {0.3, -1.2, 1.5, -1.8, -1.4, 0.2}},
                    Case{"FrankaFer", "franka_fer/robot.urdf", {}},
                    Case{"DensoScara", "denso_hsr065_scara/robot.urdf", {}},
                    Case{"Delta", "omnid_delta_tree/robot.urdf", {}},
                    Case{"Stewart", "stewart_6ups_sdf/robot.sdf", {0.3, 0.3, 0.3, 0.3, 0.3, 0.3}}),
    [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace hapticell::manipulation
