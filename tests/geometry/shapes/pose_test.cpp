// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/pose.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/shapes/bounds.h"

namespace hapticell {
namespace {

dvec3 anyVector(double range) {
  const auto one = [&] { return *rc::gen::inRange(-1000000, 1000001) * (range / 1e6); };
  const double x = one(), y = one();
  return {x, y, one()};
}

Pose anyPose() {
  const dvec3 axis = anyVector(1.8);  // at most 3.12 rad long: rotation vectors stay unique
  return {anyVector(5.0), quaternionFromRotationVector(axis)};
}

RC_GTEST_PROP(Pose, CompositionAgreesWithMatrices, ()) {
  const Pose X_AB = anyPose(), X_BC = anyPose();
  const dvec3 p_CQ = anyVector(2.0);
  const dvec3 by_pose = (X_AB * X_BC) * p_CQ;
  const dvec3 by_matrix = X_AB.R() * (X_BC.R() * p_CQ + X_BC.p) + X_AB.p;
  RC_ASSERT(glm::distance(by_pose, by_matrix) < 1e-12);
}

RC_GTEST_PROP(Pose, InverseUndoes, ()) {
  const Pose X_AB = anyPose();
  const Pose X_AA = X_AB * X_AB.inverse();
  RC_ASSERT(glm::length(X_AA.p) < 1e-12);
  RC_ASSERT(glm::length(rotationVector(X_AA.q)) < 1e-12);
}

RC_GTEST_PROP(Pose, DifferenceAndDisplacedAreInverse, ()) {
  const Pose X_AB = anyPose(), X_AC = anyPose();
  const Pose again = displaced(X_AB, difference(X_AC, X_AB));
  RC_ASSERT(glm::distance(again.p, X_AC.p) < 1e-12);
  RC_ASSERT(glm::length(rotationVector(again.q * glm::conjugate(X_AC.q))) < 1e-12);
}

TEST(Pose, RotationVectorOfHalfTurnAndOfNothing) {
  const dvec3 half_turn = rotationVector(glm::angleAxis(std::numbers::pi, dvec3(0.0, 1.0, 0.0)));
  EXPECT_NEAR(half_turn.y, std::numbers::pi, 1e-12);
  EXPECT_EQ(rotationVector(dquat(1.0, 0.0, 0.0, 0.0)), dvec3(0.0));
  const dvec3 tiny(1e-14, 0.0, 0.0);
  EXPECT_NEAR(rotationVector(quaternionFromRotationVector(tiny)).x, 1e-14, 1e-20);
}

TEST(Pose, InterpolateMeetsBothEndsAndTheMiddle) {
  const Pose X_A0 = Pose::translation({1.0, 0.0, 0.0});
  const Pose X_A1{{3.0, 0.0, 0.0}, glm::angleAxis(1.0, dvec3(0.0, 0.0, 1.0))};
  EXPECT_NEAR(glm::distance(interpolate(X_A0, X_A1, 0.0).p, X_A0.p), 0.0, 1e-15);
  EXPECT_NEAR(glm::distance(interpolate(X_A0, X_A1, 1.0).p, X_A1.p), 0.0, 1e-15);
  EXPECT_NEAR(rotationVector(interpolate(X_A0, X_A1, 0.5).q).z, 0.5, 1e-12);
}

TEST(Pose, IsValidRefusesWhatIsNotAPose) {
  EXPECT_TRUE(Pose::identity().isValid());
  EXPECT_FALSE((Pose{{NAN, 0.0, 0.0}, dquat(1.0, 0.0, 0.0, 0.0)}).isValid());
  EXPECT_TRUE((Pose::translation({0.0, -1e12, 0.0}).isValid()));
  EXPECT_FALSE((Pose::translation({0.0, 0.0, -2e12}).isValid()));
  EXPECT_FALSE((Pose{{0.0, 0.0, 0.0}, dquat(0.9, 0.0, 0.0, 0.0)}).isValid());
}

RC_GTEST_PROP(Bounds, TransformedBoxHoldsEveryTransformedPoint, ()) {
  const Pose X_AB = anyPose();
  const std::array points{anyVector(1.0), anyVector(1.0), anyVector(1.0)};
  const geometry::Bounds box_A = geometry::transformed(X_AB, geometry::boundsOf(points));
  for (const dvec3& p_B : points) {
    const dvec3 p_A = X_AB * p_B;
    RC_ASSERT(glm::all(glm::greaterThanEqual(p_A, box_A.min - 1e-12)));
    RC_ASSERT(glm::all(glm::lessThanEqual(p_A, box_A.max + 1e-12)));
  }
}

}  // namespace
}  // namespace hapticell
