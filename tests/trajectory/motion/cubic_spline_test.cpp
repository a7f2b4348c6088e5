// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/cubic_spline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hapticell::trajectory {
namespace {

double polynomial(double u) {
  return 1.0 - 2.0 * u + 0.5 * u * u + 0.25 * u * u * u;
}

TEST(CubicSpline, GivesACubicBackExactlyWithItsDerivatives) {
  std::vector<double> u, values;
  for (int i = 0; i <= 40; ++i) {
    u.push_back(0.1 * i);
    values.push_back(polynomial(u.back()));
  }
  const CubicSpline spline = fitSpline({u, values, {}, 1}, {0.0, 0.7, 1.1, 2.5, 4.0}, 1e-14);
  for (double at = 0.0; at <= 4.0; at += 0.37) {
    double value[1];
    const double expected[] = {polynomial(at), -2.0 + at + 0.75 * at * at, 1.0 + 1.5 * at, 1.5};
    for (int order = 0; order < 4; ++order) {
      spline.evaluate(at, order, value);
      EXPECT_NEAR(value[0], expected[order], 1e-7) << "order " << order << " at " << at;
    }
  }
}

TEST(CubicSpline, BasisIsAPartitionOfUnityAndItsDerivativesAreDifferences) {
  const CubicSpline spline({0.0, 0.5, 0.6, 2.0, 3.0}, 1);
  for (double u = 0.01; u < 3.0; u += 0.0437) {
    double sum = 0.0;
    const auto basis = spline.basis(u);
    for (const double value : basis.values) sum += value;
    EXPECT_NEAR(sum, 1.0, 1e-12);
    const double h = 1e-6;
    const auto before = spline.basis(u - h), after = spline.basis(u + h), slope = spline.basis(u, 1);
    if (before.first != after.first) continue;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(slope.values[i], (after.values[i] - before.values[i]) / (2 * h), 1e-5);
  }
}

TEST(CubicSpline, SpansWithoutPointsDoNoHarm) {
  const std::vector<double> u{0.0, 0.1, 0.2, 9.8, 9.9, 10.0};
  const std::vector<double> values{0.0, 0.1, 0.2, 9.8, 9.9, 10.0};
  std::vector<double> breaks;
  for (int i = 0; i <= 20; ++i) breaks.push_back(0.5 * i);
  const CubicSpline spline = fitSpline({u, values, {}, 1}, breaks);
  for (double at = 0.0; at <= 10.0; at += 0.25) {
    double value[1];
    spline.evaluate(at, 0, value);
    EXPECT_TRUE(std::isfinite(value[0]));
    EXPECT_NEAR(value[0], at, 0.5);
  }
}

}  // namespace
}  // namespace hapticell::trajectory
