// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "tests/manipulation/session/test_cells.h"
#include "tests/support/test_data.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::manipulation {
namespace {

using test::handThrough;
using test::sessionOf;

geometry::TriangleMesh read(const std::filesystem::path& path, double scale) {
  Diagnostics diagnostics;
  workcell::MeshReadOptions options;
  options.scale = scale;
  auto mesh = workcell::readMesh(path, options, diagnostics);
  EXPECT_TRUE(mesh) << path;
  return mesh ? std::move(*mesh) : geometry::TriangleMesh{};
}

struct Rate {
  double hz;
  double latency_s;
};

class RealParts : public testing::TestWithParam<Rate> {};
INSTANTIATE_TEST_SUITE_P(Rates, RealParts, testing::Values(Rate{10.0, 0.050}, Rate{1000.0, 0.001}),
                         [](const auto& which) { return which.param.hz < 100.0 ? "Slow" : "Fast"; });

void expectSafe(const SessionReport& report) {
  EXPECT_GE(report.forces.energy_min_j, -1e-3);
  EXPECT_LE(report.forces.penetration_max_m, 1e-4);
  EXPECT_LE(report.forces.force_max_n, 6.4);
  EXPECT_LE(report.forces.force_max_step_n_per_ms, 1.0 + 1e-6);
  EXPECT_GT(report.forces.force_max_n, 0.5);
  ASSERT_FALSE(report.contacts.empty());
  EXPECT_TRUE(report.end.held);
}

/// Beside the hole's middle onto its face, pressed, over the hole's rim, tilted, and away.
TEST_P(RealParts, PegPressedOnTheRimOfItsHole) {
  HAPTICELL_SHARED_DATA_OR_SKIP(peg, "cad/obj/factory_round_peg_8mm_tight.obj");
  HAPTICELL_SHARED_DATA_OR_SKIP(hole, "cad/obj/factory_round_hole_8mm_subdiv_3x.obj");
  const auto hand = handThrough({{0.0, {0, 0, 0.02}},
                                 {0.8, {0, 0, 0.02}},
                                 {2.0, {0.001, 0, -0.003}},
                                 {4.0, {0, 0, -0.003}},
                                 {5.5, {0, 0.0003, -0.012}},
                                 {6.5, {0, 0, -0.012}, {0.05, 0, 0}},
                                 {7.5, {0.001, 0, -0.012}},
                                 {9.0, {0, 0, 0.03}}},
                                0.3);
  const auto report = runSession(sessionOf(
      {test::solid(1, "hole", read(hole, 1.0)), test::solid(2, "peg", read(peg, 1.0), Pose::translation({0, 0, 0.02}))},
      "peg", hand, GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  expectSafe(*report);
  EXPECT_NEAR(report->end.X_WM.p.z, 0.03, 1e-3);
}

/// Searched for in a shrinking spiral under a light push, in by 18 mm, shifted in there, and out. The safety distance
/// must be less than the 0.1 mm of play: with 1 mm the peg rests on the rim, as it should.
haptic::HandPath handIntoTheHole() {
  const auto smooth = [](double t, double from, double to) {
    const double u = std::clamp((t - from) / (to - from), 0.0, 1.0);
    return u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
  };
  std::vector<haptic::HandSample> samples;
  for (int i = 0; i <= 950; ++i) {
    const double t = 0.01 * i;
    const double z = 0.02 - 0.0104 * smooth(t, 0.8, 2.0) - 0.0076 * smooth(t, 4.5, 6.5) + 0.028 * smooth(t, 8.0, 9.4);
    const double radius = 0.0006 * std::min(std::max(0.0, t - 2.0) / 0.3, 1.0 - smooth(t, 2.3, 4.3));
    const double angle = 4.0 * std::numbers::pi * std::max(0.0, t - 2.0);
    const double shift = t > 6.5 && t < 8.0 ? 0.004 * std::sin(2.0 * std::numbers::pi * (t - 6.5) / 1.5) : 0.0;
    samples.push_back({t, Pose::translation({radius * std::cos(angle) + shift, radius * std::sin(angle), z}),
                       t >= 0.3 && t < 0.4 ? 1U : 0U});
  }
  return haptic::HandPath(std::move(samples));
}

TEST_P(RealParts, PegGoesIntoItsHoleAndComesOut) {
  HAPTICELL_SHARED_DATA_OR_SKIP(peg, "cad/obj/factory_round_peg_8mm_tight.obj");
  HAPTICELL_SHARED_DATA_OR_SKIP(hole, "cad/obj/factory_round_hole_8mm_subdiv_3x.obj");
  SessionOptions options = sessionOf(
      {test::solid(1, "hole", read(hole, 1.0)), test::solid(2, "peg", read(peg, 1.0), Pose::translation({0, 0, 0.02}))},
      "peg", handIntoTheHole(), GetParam().hz, GetParam().latency_s);
  options.configuration.manipulation.safety_distance = 0.0;
  double lowest = 1.0, side_force = 0.0;
  const auto report = runSession(options, [&](const TraceRow& row) {
    lowest = std::min(lowest, row.X_WM.p.z);
    if (row.t > 6.6 && row.t < 7.9) side_force = std::max(side_force, std::abs(row.force_D.x));
  });
  ASSERT_TRUE(report) << report.error().message();
  expectSafe(*report);
  EXPECT_LT(lowest, 0.003) << "the hand goes down to 2 mm above the hole's bottom";
  EXPECT_GT(side_force, 0.5) << "the wall is felt where the hand leans by 4 mm";
  EXPECT_NEAR(report->end.X_WM.p.z, 0.03, 1e-3);
}

TEST_P(RealParts, RobotPressedOnAHousing) {
  HAPTICELL_SHARED_DATA_OR_SKIP(urdf, "robots/kuka_kr120r2500pro/robot.urdf");
  HAPTICELL_SHARED_DATA_OR_SKIP(shell, "cad/stl/odri_hip_aa_module_shell_base.stl");
  Diagnostics diagnostics;
  auto model = workcell::readUrdf(urdf, diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  workcell::Entity robot;
  robot.id = 1;
  robot.name = "kuka";
  robot.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(*model)),
                                .joints = {0.0, -1.3, 1.7, 0.0, 1.17, 0.0},
                                .tip_link = "tool0"}};
  const auto hand = handThrough({{0.0, {0, 0, 0.03}},
                                 {0.8, {0, 0, 0.03}},
                                 {3.0, {0, 0, -0.04}},
                                 {4.0, {0, 0, -0.04}},
                                 {6.0, {0.05, 0, -0.04}},
                                 {8.0, {0.05, 0.03, -0.04}, {0.2, 0, 0}},
                                 {9.5, {0, 0, 0.04}}},
                                0.3);
  const auto report =
      runSession(sessionOf({robot, test::solid(2, "housing", read(shell, 0.001), Pose::translation({1.62, 0, 1.08}))},
                           "kuka", hand, GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  expectSafe(*report);
}

}  // namespace
}  // namespace hapticell::manipulation
