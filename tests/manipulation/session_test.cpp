// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/manipulation/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::boxOverTable;
using test::handThrough;
using test::sessionOf;

struct Rate {
  double hz;
  double latency_s;
};
const Rate kSlow{10.0, 0.050}, kFast{1000.0, 0.001};

/// Down into the table by 6 mm of hand, along it, and up again.
haptic::HandPath pressAndSlide() {
  return handThrough({{0.0, {0, 0, 0.02}},
                      {1.0, {0, 0, 0.02}},
                      {2.0, {0, 0, -0.006}},
                      {3.0, {0.05, 0, -0.006}},
                      {4.0, {0.05, 0.03, -0.004}},
                      {5.0, {0.05, 0.03, 0.03}},
                      {5.5, {0.05, 0.03, 0.03}}});
}

void expectFeelsRight(const SessionReport& report) {
  EXPECT_LE(report.penetration_max_m, 1e-4);
  EXPECT_LE(report.force_max_n, 6.4);
  EXPECT_LE(report.force_max_step_n_per_ms, 1.0 + 1e-6);
  EXPECT_GE(report.energy_min_j, -1e-3);
}

class SessionAtRate : public testing::TestWithParam<Rate> {};
INSTANTIATE_TEST_SUITE_P(Rates, SessionAtRate, testing::Values(kSlow, kFast),
                         [](const auto& which) { return which.param.hz < 100.0 ? "Slow" : "Fast"; });

TEST_P(SessionAtRate, BoxPressedOnTableSlidesAndLeaves) {
  const auto report =
      runSession(sessionOf(boxOverTable(0.02), "box", pressAndSlide(), GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  expectFeelsRight(*report);
  EXPECT_GT(report->force_max_n, 1.0);
  ASSERT_EQ(report->contacts.size(), 1U);
  EXPECT_EQ(report->contacts[0].other, 1U);
  EXPECT_GT(report->contacts[0].time_in, 1.2);
  EXPECT_LT(report->contacts[0].time_out, 5.0);
  EXPECT_TRUE(report->held);
  // The hand ends 10 mm above and 50, 30 mm beside where it took the box.
  EXPECT_NEAR(report->X_WMFinal.p.x, 0.05, 0.002);
  EXPECT_NEAR(report->X_WMFinal.p.y, 0.03, 0.002);
  EXPECT_NEAR(report->X_WMFinal.p.z, 0.06, 0.003);
}

}  // namespace
}  // namespace hapticell::manipulation
