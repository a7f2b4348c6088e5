// SPDX-License-Identifier: Apache-2.0
// What the hand feels in whole sessions: taps, torque, force classes, moving obstacles.
#include <gtest/gtest.h>

#include <cmath>

#include "manipulation/session.h"
#include "tests/manipulation/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::boxOverTable;
using test::handThrough;
using test::sessionOf;

/// A box under the stylus that taps the table three times a second with 0.25 m/s of hand.
haptic::HandPath tappingHand(double speed) {
  std::vector<haptic::HandSample> samples;
  const double omega = 6.0 * M_PI, swing = speed / omega;
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i, share = std::clamp(t - 1.2, 0.0, 1.0);
    const dvec3 p(0, 0, swing * (share * std::cos(omega * (t - 1.2)) - share));
    samples.push_back({t, Pose::translation(p), t >= 0.05 && t < 0.15 ? 1U : 0U});
  }
  return haptic::HandPath(std::move(samples));
}

TEST(SessionFeel, TapsMakeNoMoreThanAMillijoule) {
  for (const double rate : {10.0, 1000.0}) {
    const auto report = runSession(sessionOf(boxOverTable(0.012), "box", tappingHand(0.25), rate, 0.5 / rate));
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_GT(report->force_max_n, 2.0);
    EXPECT_LT(report->energy_min_j, 0.0);
    EXPECT_GE(report->energy_min_j, -1e-3) << rate;
  }
}

/// The box pressed onto the table and the wrist turned.
TEST(SessionFeel, ADeviceOfSixDrivenAxesResistsTheTurn) {
  const auto turnedHand = handThrough({{0.0, {0, 0, 0.01}},
                                       {1.2, {0, 0, 0.01}},
                                       {2.0, {0, 0, -0.002}},
                                       {3.0, {0, 0, -0.002}, {0, 0.2, 0}},
                                       {4.0, {0, 0, -0.002}, {0, 0.2, 0}}});
  auto options = sessionOf(boxOverTable(0.01), "box", turnedHand, 60.0, 0.01);
  dvec3 torque(0.0);
  double most = 0.0;
  const TraceSink watch = [&](const TraceRow& row) {
    torque = row.torque_D;
    most = std::max(most, glm::length(row.torque_D));
  };
  const auto three = runSession(options, watch);
  ASSERT_TRUE(three) << three.error().message();
  EXPECT_EQ(most, 0.0);
  options.device.driven_axes = 6;
  options.device.peak_torque = 0.188;
  const auto six = runSession(options, watch);
  ASSERT_TRUE(six) << six.error().message();
  EXPECT_GT(glm::length(torque), 0.02);
  EXPECT_LT(torque.y, 0.0) << "against the turn";
  EXPECT_LE(most, 0.188 + 1e-9);
  EXPECT_LE(six->penetration_max_m, 1e-4);
  EXPECT_GE(six->energy_min_j, -1e-3);
}

}  // namespace
}  // namespace hapticell::manipulation
