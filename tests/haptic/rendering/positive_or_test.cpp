// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/positive_or.h"

#include <gtest/gtest.h>

#include <limits>

namespace hapticell::haptic {
namespace {

TEST(PositiveOr, TakesFiniteNumbersAboveZeroOnly) {
  using Limits = std::numeric_limits<double>;
  for (const double good : {1e-300, Limits::denorm_min(), 1.0, Limits::max()}) EXPECT_EQ(positiveOr(good, 7.0), good);
  for (const double bad : {0.0, -0.0, -1.0, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_EQ(positiveOr(bad, 7.0), 7.0) << bad;
}

}  // namespace
}  // namespace hapticell::haptic
