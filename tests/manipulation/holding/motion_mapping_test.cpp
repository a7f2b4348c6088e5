// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/motion_mapping.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {
namespace {

dvec3 anyVector(double size) {
  const auto number = [size] { return size * (*rc::gen::inRange(-1000, 1001)) / 1000.0; };
  return {number(), number(), number()};
}

Pose anyPose(double size) {
  return {anyVector(size), quaternionFromRotationVector(anyVector(1.5))};
}

MotionMapping anyMapping() {
  MotionMapping mapping;
  mapping.setAxes(quaternionFromRotationVector(anyVector(2.0)));
  mapping.setRotationScale(*rc::gen::inRange(1, 11) * 0.1);
  mapping.setScale(*rc::gen::element(0.25, 1.0, 4.0));
  mapping.anchor(anyPose(0.05), anyPose(1.0));
  return mapping;
}

MotionMapping anyFilteredMapping() {
  MotionMapping mapping = anyMapping();
  mapping.setAxisFilter(*rc::gen::arbitrary<bool>(), true, *rc::gen::arbitrary<bool>());
  mapping.setTurnFilter(*rc::gen::arbitrary<bool>(), true, *rc::gen::arbitrary<bool>());
  return mapping;
}

double distance(const Pose& a, const Pose& b) {
  const Twist t = difference(a, b);
  return glm::length(t.linear) + glm::length(t.angular);
}

haptic::Vector6 vectorOf(const Twist& t) {
  return {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
}

TEST(MotionMapping, ScreenAxesFollowTheCamera) {
  // A camera that looks along +y with z up is the device's own arrangement.
  const Pose front{dvec3(0.0, -2.0, 0.0), quaternionFromRotationVector(dvec3(std::numbers::pi / 2.0, 0.0, 0.0))};
  const dquat q = deviceAxes(AxesMode::kScreen, front, {});
  EXPECT_NEAR(glm::length(q * dvec3(1, 0, 0) - dvec3(1, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(q * dvec3(0, 0, 1) - dvec3(0, 0, 1)), 0.0, 1e-12);
  // Seen from above (looking along -z, up is +y): away from the user means down in the cell.
  const dquat above = deviceAxes(AxesMode::kScreen, Pose::translation({0, 0, 3}), {});
  EXPECT_NEAR(glm::length(above * dvec3(0, 1, 0) - dvec3(0, 0, -1)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(above * dvec3(0, 0, 1) - dvec3(0, 1, 0)), 0.0, 1e-12);
}

TEST(MotionMapping, CellAxesIgnoreTheCameraAndFrameAxesTakeTheFrame) {
  const Pose camera{dvec3(0.0), quaternionFromRotationVector({0.3, 1.0, 0.2})};
  const Pose frame{dvec3(1.0), quaternionFromRotationVector({0.0, 0.0, 1.0})};
  EXPECT_EQ(deviceAxes(AxesMode::kCell, camera, frame), dquat(1.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(deviceAxes(AxesMode::kFrame, camera, frame), frame.q);
}

TEST(MotionMapping, ScreenScaleIsTheRatioOfWidths) {
  EXPECT_DOUBLE_EQ(screenScale(0.8, 0.16), 5.0);
  EXPECT_DOUBLE_EQ(screenScale(0.0, 0.16), 1.0);
  EXPECT_DOUBLE_EQ(screenScale(1.0, std::nan("")), 1.0);
}

TEST(MotionMapping, ScaleRefusesWhatIsNotANumber) {
  MotionMapping mapping;
  mapping.setScale(std::nan(""));
  EXPECT_EQ(mapping.scale(), 1.0);
  mapping.setScale(0.0);
  EXPECT_EQ(mapping.scale(), 1e-3);
}

RC_GTEST_PROP(MotionMapping, AnchorMeansNoJump, ()) {
  MotionMapping mapping = anyMapping();
  const Pose X_DP = anyPose(0.06), X_WM = anyPose(2.0);
  mapping.anchor(X_DP, X_WM);
  RC_ASSERT(distance(mapping.toCell(X_DP), X_WM) < 1e-9);
}

RC_GTEST_PROP(MotionMapping, ToDeviceInvertsToCell, ()) {
  const MotionMapping mapping = anyMapping();
  const Pose X_DP = anyPose(0.06);
  RC_ASSERT(distance(mapping.toDevice(mapping.toCell(X_DP), {}), X_DP) < 1e-7);
}

RC_GTEST_PROP(MotionMapping, TwistIsTheDifferenceOfPoses, ()) {
  MotionMapping mapping = anyMapping();
  Pose X_DP = anyPose(0.03);
  // Turns that are scaled do not add up as vectors: the map is that of where the hand is turned to.
  mapping.lookFrom(X_DP);
  const Twist small{anyVector(1e-5), anyVector(1e-5)};
  const Twist seen = difference(mapping.toCell(displaced(X_DP, small)), mapping.toCell(X_DP));
  const Twist told = mapping.toCell(small);
  RC_ASSERT(glm::length(seen.linear - told.linear) < 1e-9);
  RC_ASSERT(glm::length(seen.angular - told.angular) < 1e-8);
}

RC_GTEST_PROP(MotionMapping, ConstraintMeansTheSameInBothSpaces, ()) {
  const MotionMapping mapping = anyMapping();
  haptic::Constraint in_cell;
  in_cell.gap = 0.01;
  for (double& a : in_cell.gradient) a = anyVector(1.0).x;
  for (double& a : in_cell.trim_gradient) a = anyVector(1.0).x;
  for (double& b : in_cell.curvature) b = anyVector(20.0).x;
  haptic::Constraint in_device = in_cell;
  mapping.toDevice(in_device);
  const Twist motion{anyVector(0.03), anyVector(0.3)};
  const double cell = haptic::evaluate(in_cell, vectorOf(mapping.toCell(motion)));
  const double device = haptic::evaluate(in_device, vectorOf(motion));
  RC_ASSERT(std::abs(device * mapping.scale() - cell) < 1e-12);
}

RC_GTEST_PROP(MotionMapping, SlopeInHandSpaceMatchesFiniteDifferences, ()) {
  const MotionMapping mapping = anyFilteredMapping();
  haptic::Constraint constraint;
  for (double& a : constraint.gradient) a = anyVector(1.0).x;
  for (double& b : constraint.curvature) b = anyVector(20.0).x;
  haptic::Constraint in_device = constraint;
  mapping.toDevice(in_device);
  const Twist at{anyVector(0.02), anyVector(0.1)};
  const haptic::Vector6 slope = haptic::gradientAt(in_device, vectorOf(at));
  for (std::size_t i = 0; i < 6; ++i) {
    const auto f = [&](double h) {
      haptic::Vector6 xi = vectorOf(at);
      xi[i] += h;
      const Twist moved{{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}};
      return haptic::evaluate(constraint, vectorOf(mapping.toCell(moved))) / mapping.scale();
    };
    RC_ASSERT(std::abs((f(1e-5) - f(-1e-5)) / 2e-5 - slope[i]) < 1e-6 * (1.0 + std::abs(slope[i])));
  }
}

TEST(MotionMapping, OneAxisOrAPlaneOnly) {
  MotionMapping mapping;
  mapping.setAxisFilter(false, true, false);
  mapping.setRotationScale(2.0);
  mapping.anchor({}, Pose::translation({1, 0, 0}));
  const Pose moved{dvec3(0.01, 0.02, 0.03), quaternionFromRotationVector({0, 0, 0.2})};
  const Pose wanted{dvec3(1.0, 0.02, 0.0), quaternionFromRotationVector({0, 0, 0.4})};
  EXPECT_NEAR(distance(mapping.toCell(moved), wanted), 0.0, 1e-12);
  EXPECT_NEAR(distance(mapping.toDevice(mapping.toCell(moved), moved), moved), 0.0, 1e-12);
  mapping.drift({0.0, 0.005, 0.0});
  EXPECT_NEAR(mapping.toCell(moved).p.y, 0.025, 1e-12);
}

TEST(MotionMapping, TurningAboutOneAxisOnly) {
  MotionMapping mapping;
  mapping.setTurnFilter(false, false, true);
  mapping.anchor({}, Pose::translation({1, 0, 0}));
  const Pose moved{dvec3(0.01, 0.02, 0.03), quaternionFromRotationVector({0.1, -0.2, 0.3})};
  const Pose wanted{dvec3(1.01, 0.02, 0.03), quaternionFromRotationVector({0, 0, 0.3})};
  EXPECT_NEAR(distance(mapping.toCell(moved), wanted), 0.0, 1e-12);
  EXPECT_NEAR(distance(mapping.toDevice(mapping.toCell(moved), moved), moved), 0.0, 1e-12);
}

TEST(MotionMapping, FiltersHideTranslationOrRotation) {
  MotionMapping mapping;
  mapping.setFilter(true, false);
  mapping.anchor({}, Pose::translation({1, 0, 0}));
  const Pose turned{dvec3(0.01, 0, 0), quaternionFromRotationVector({0, 0, 0.5})};
  EXPECT_NEAR(distance(mapping.toCell(turned), Pose::translation({1.01, 0, 0})), 0.0, 1e-12);
  // What is hidden is taken from the pose nearby, so that the set's reference stays at the proxy.
  EXPECT_NEAR(distance(mapping.toDevice(mapping.toCell(turned), turned), turned), 0.0, 1e-12);
  haptic::Constraint constraint;
  constraint.gradient = {1, 0, 0, 0, 0, 1};
  mapping.toDevice(constraint);
  EXPECT_EQ(constraint.gradient[0], 1.0);
  EXPECT_EQ(constraint.gradient[5], 0.0);
}

TEST(Symmetric, BlocksAndBack) {
  haptic::SymmetricMatrix6 packed{};
  for (std::size_t k = 0; k < packed.size(); ++k) packed[k] = static_cast<double>(k + 1);
  EXPECT_EQ(symmetricOf(blocksOf(packed)), packed);
  EXPECT_EQ(packedIndex(5, 5), 20U);
}

RC_GTEST_PROP(MotionMapping, TurningTheAnchorTurnsTheTargetInItsPlace, ()) {
  MotionMapping mapping = anyMapping();
  const Pose X_DP = anyPose(0.05);
  const Pose before = mapping.toCell(X_DP);
  const dquat turn = quaternionFromRotationVector(anyVector(0.3));
  mapping.turn(turn, X_DP);
  const Pose after = mapping.toCell(X_DP);
  RC_ASSERT(glm::distance(before.p, after.p) < 1e-9);
  RC_ASSERT(glm::length(rotationVector(after.q * glm::conjugate(turn * before.q))) < 1e-6);
}

}  // namespace
}  // namespace hapticell::manipulation
