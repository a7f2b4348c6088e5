// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/straight_hand.h"

#include <gtest/gtest.h>

namespace hapticell::manipulation {
namespace {

/// A stylus that follows at once but not beyond `wall` along x.
double farthest(double wall, double seconds, double* push) {
  StraightHandOptions options = seededHand(7);
  options.X_WG = Pose::translation({0.1, 0.0, 0.0});
  StraightHand hand(options);
  Pose X_DS;
  double most = 0.0;
  for (int i = 0; i < std::lround(1e3 * seconds); ++i) {
    const haptic::HandSample sample = hand.next(1e-3 * i, X_DS, X_DS);
    if (push) *push = std::max(*push, options.stiffness * glm::length(sample.X_DH.p - X_DS.p));
    X_DS.p = sample.X_DH.p;
    X_DS.p.x = std::min(X_DS.p.x, wall);
    most = std::max(most, X_DS.p.x);
  }
  return most;
}

TEST(StraightHand, GoesToTheGoalInTheAir) {
  EXPECT_NEAR(farthest(1.0, 3.0, nullptr), 0.1, 1e-3);
}

TEST(StraightHand, GivesWayAtAWall) {
  double push = 0.0;
  EXPECT_NEAR(farthest(0.04, 5.0, &push), 0.04, 1e-9);
  EXPECT_LT(push, 1.3 + 0.2) << "N: its push and its tremor";
  EXPECT_GT(push, 0.5);
}

TEST(StraightHand, IsTheSameForTheSameSeed) {
  const StraightHandOptions a = seededHand(3), b = seededHand(3), c = seededHand(4);
  EXPECT_EQ(a.push, b.push);
  EXPECT_EQ(a.speed, b.speed);
  EXPECT_NE(a.push, c.push);
}

}  // namespace
}  // namespace hapticell::manipulation
