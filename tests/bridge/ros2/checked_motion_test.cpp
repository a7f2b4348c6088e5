// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/checked_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/bridge/ros2/slide_cell.h"

namespace hapticell::bridge {
namespace {

trajectory::Trajectory sineOf(std::size_t points, double step) {
  trajectory::Trajectory motion;
  motion.joint_names = {"a", "b"};
  motion.has_poses = false;
  for (std::size_t i = 0; i < points; ++i) {
    const double t = step * static_cast<double>(i);
    motion.addFrame({t, {}}, std::vector<double>{1.0 - std::cos(t), 0.5 * t * t});
  }
  return motion;
}

/// The polynomial of a controller in powers of time, by its four coefficients (joint_trajectory_controller documents it so).
double cubicAt(double p0, double p1, double v0, double v1, double h, double t) {
  const double c = (3.0 * (p1 - p0) / h - 2.0 * v0 - v1) / h, d = (v0 + v1 - 2.0 * (p1 - p0) / h) / (h * h);
  return p0 + v0 * t + c * t * t + d * t * t * t;
}

TEST(CheckedMotion, SamplesThePathThatAControllerTakesBetweenPoints) {
  const JointTrajectoryMessage message(sineOf(8, 0.4));
  const auto& points = message.message()->points;
  const trajectory::Trajectory path = executedPath(*message.message());
  EXPECT_GT(path.size(), 3 * points._length);
  double worst = 0.0;
  for (int n = 0; n <= 2800; ++n) {
    const double t = 0.001 * n;
    const auto i = std::min<std::uint32_t>(points._length - 2, static_cast<std::uint32_t>(t / 0.4));
    const auto &from = points._buffer[i], &to = points._buffer[i + 1];
    const std::vector<double> at = path.jointsAt(t);
    for (std::uint32_t j = 0; j < 2; ++j)
      worst = std::max(worst, std::abs(at[j] - cubicAt(from.positions._buffer[j], to.positions._buffer[j], from.velocities._buffer[j],
                                                       to.velocities._buffer[j], 0.4, t - 0.4 * i)));
  }
  EXPECT_LT(worst, 1.05e-4);
  EXPECT_GT(worst, 1e-7);  // There is something to sample.
}

TEST(CheckedMotion, FindsSpeedsBetweenThePoints) {
  const JointTrajectoryMessage message(sineOf(8, 0.4));
  const auto& points = message.message()->points;
  const std::vector<double> greatest = greatestSpeeds(*message.message());
  for (std::uint32_t j = 0; j < 2; ++j) {
    double seen = 0.0;
    for (std::uint32_t i = 0; i + 1 < points._length; ++i) {
      const auto &from = points._buffer[i], &to = points._buffer[i + 1];
      const auto at = [&](double t) {
        return cubicAt(from.positions._buffer[j], to.positions._buffer[j], from.velocities._buffer[j], to.velocities._buffer[j], 0.4, t);
      };
      for (int n = 0; n < 4000; ++n) seen = std::max(seen, std::abs(at(1e-4 * (n + 1)) - at(1e-4 * n)) / 1e-4);
    }
    EXPECT_NEAR(greatest[j], seen, 1e-3 * seen) << j;
  }
}

TEST(CheckedMotion, SlowsToTheSpeedOfTheToolAndTheShareOfTheJoint) {
  const SlideCell cell(0.37, 0.6);
  const auto slowed = checkedMotion(cell.wanted);
  ASSERT_TRUE(slowed) << slowed.error().message();
  EXPECT_EQ(slowed->robot, "slide");
  EXPECT_EQ(slowed->fastest, "x");
  EXPECT_TRUE(slowed->is_sliding.at(0));
  // 0.37 m by s²(3 - 2s) in 0.6 s reach 1.5 * 0.37 / 0.6 = 0.925 m/s.
  EXPECT_NEAR(slowed->slowed, 3.7, 0.01);
  EXPECT_LE(slowed->tool_speed, 0.25);
  EXPECT_NEAR(slowed->tool_speed, 0.25, 1e-3);
  EXPECT_NEAR(slowed->joint_share, 0.125, 1e-3);
  EXPECT_NEAR(slowed->duration, 2.22, 0.01);
  EXPECT_NEAR(slowed->least_clearance, 0.45 - 0.42, 1e-6);  // From the block's face to the wall's.
  MotionToSend by_joint = cell.wanted;
  by_joint.tool_speed = 10.0;
  by_joint.joint_share = 0.1;
  const auto shared = checkedMotion(by_joint);
  ASSERT_TRUE(shared);
  EXPECT_NEAR(shared->slowed, 0.925 / 0.2, 0.02);
  EXPECT_NE(shared->confirmation, slowed->confirmation);
  MotionToSend elsewhere = cell.wanted;
  elsewhere.action = "/b";
  EXPECT_NE(checkedMotion(elsewhere)->confirmation, slowed->confirmation);
  EXPECT_EQ(checkedMotion(cell.wanted)->confirmation, slowed->confirmation);
}

/// The fastest place lies between two points: there, too, the tool keeps its speed. The slide is the tool.
TEST(CheckedMotion, KeepsTheSpeedOfTheToolBetweenThePoints) {
  for (const double seconds : {0.3, 0.45, 0.6, 0.61, 0.83}) {
    const auto slowed = checkedMotion(SlideCell(0.37, seconds).wanted);
    ASSERT_TRUE(slowed) << slowed.error().message();
    const auto& points = slowed->message->message()->points;
    const auto timeOf = [](const auto& point) { return point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec; };
    double fastest = 0.0;
    for (std::uint32_t i = 0; i + 1 < points._length; ++i) {
      const auto &from = points._buffer[i], &to = points._buffer[i + 1];
      const double h = timeOf(to) - timeOf(from);
      const double p0 = from.positions._buffer[0], p1 = to.positions._buffer[0];
      const double v0 = from.velocities._buffer[0], v1 = to.velocities._buffer[0];
      const double c = (3.0 * (p1 - p0) / h - 2.0 * v0 - v1) / h, d = (v0 + v1 - 2.0 * (p1 - p0) / h) / (h * h);
      for (int n = 0; n <= 1000; ++n) {
        const double t = h * n / 1000.0;
        fastest = std::max(fastest, std::abs(v0 + 2.0 * c * t + 3.0 * d * t * t));
      }
    }
    EXPECT_LE(fastest, 0.25 * (1.0 + 1e-12)) << seconds;
    EXPECT_GT(fastest, 0.2499) << seconds;
    EXPECT_LE(fastest, slowed->tool_speed * (1.0 + 1e-12)) << seconds;
  }
}

TEST(CheckedMotion, RefusesWhatMeetsTheCellOrLeavesTheLimits) {
  const auto meets = checkedMotion(SlideCell(0.45, 2.0).wanted);
  ASSERT_FALSE(meets);
  EXPECT_THAT(meets.error().message(), ::testing::HasSubstr("meets"));
  const auto leaves = checkedMotion(SlideCell(-1.2, 2.0).wanted);
  ASSERT_FALSE(leaves);
  EXPECT_THAT(leaves.error().message(), ::testing::HasSubstr("'x' is beyond its limit"));
}

}  // namespace
}  // namespace hapticell::bridge
