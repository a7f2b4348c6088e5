// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/part_differential.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace hapticell::manipulation {
namespace {

dvec3 anyVector(double size) {
  const auto number = [size] { return size * (*rc::gen::inRange(-1000, 1001)) / 1000.0; };
  return {number(), number(), number()};
}

haptic::Vector6 vectorOf(const Twist& t) {
  return {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
}

/// Where a point fixed to a body goes when the body's frame M is displaced.
dvec3 carried(const dvec3& p_WQ, const dvec3& p_WMo, const Twist& motion) {
  return p_WMo + motion.linear + quaternionFromRotationVector(motion.angular) * (p_WQ - p_WMo);
}

RC_GTEST_PROP(PartDifferential, RigidConditionIsTrueToSecondOrder, ()) {
  const dvec3 p_WMo = anyVector(1.0), p_WPo = anyVector(1.0), p_WQ = anyVector(1.0);
  PointCondition condition;
  condition.p_WQ = p_WQ;
  condition.nhat_W = glm::normalize(anyVector(1.0) + dvec3(2.0, 0.0, 0.0));
  condition.gap = 0.02;
  condition.M = dmat3(10.0);
  haptic::Constraint constraint;
  applyCondition(rigidDifferential(p_WMo, p_WPo), condition, constraint);
  const Twist direction{anyVector(1.0), anyVector(1.0)};
  const auto error = [&](double h) {
    const Twist motion{h * direction.linear, h * direction.angular};
    const dvec3 e = carried(p_WQ, p_WMo, motion) - p_WQ;
    const double exact = condition.gap + glm::dot(condition.nhat_W, e) + 5.0 * glm::dot(e, e);
    return std::abs(haptic::evaluate(constraint, vectorOf(motion)) - exact);
  };
  // Third-order remainder: bounded by a constant times h^3.
  RC_ASSERT(error(1e-3) < 1e-6);
  RC_ASSERT(error(1e-4) < 1e-9);
}

RC_GTEST_PROP(PartDifferential, MovingNormalIsTrueToSecondOrder, ()) {
  const dvec3 p_WMo = anyVector(1.0), corner = anyVector(1.0), on_face = anyVector(1.0);
  PointCondition condition;
  condition.nhat_W = glm::normalize(anyVector(1.0) + dvec3(2.0, 0.0, 0.0));
  condition.p_WQ = corner;
  condition.gap = glm::dot(condition.nhat_W, on_face - corner);
  condition.normal_moves = true;
  haptic::Constraint constraint;
  applyCondition(rigidDifferential(p_WMo, anyVector(1.0)), condition, constraint);
  const Twist direction{anyVector(1.0), anyVector(1.0)};
  const Twist motion{1e-4 * direction.linear, 1e-4 * direction.angular};
  const dvec3 normal = quaternionFromRotationVector(motion.angular) * condition.nhat_W;
  const double exact = glm::dot(normal, carried(on_face, p_WMo, motion) - corner);
  RC_ASSERT(std::abs(haptic::evaluate(constraint, vectorOf(motion)) - exact) < 1e-10);
}

RC_GTEST_PROP(PartDifferential, MovingCylinderAgainstAFixedCorner, ()) {
  // The quadric of a cylinder of radius R that moves with the part, at a corner that stays: exact to second order.
  const double R = 0.5;
  const dvec3 p_WMo = anyVector(1.0), foot = anyVector(1.0);
  const dvec3 out = glm::normalize(anyVector(1.0) + dvec3(2.0, 0.0, 0.0));
  const dvec3 axis = glm::normalize(glm::cross(out, anyVector(1.0) + dvec3(0.0, 2.0, 0.0)));
  const dvec3 corner = foot + 0.1 * out;
  const dmat3 M = (dmat3(1.0) - glm::outerProduct(axis, axis)) / R;
  PointCondition condition;  // free where the corner is outside; the part's way out is -out
  condition.p_WQ = corner;
  condition.normal_moves = true;
  condition.M = M;
  condition.nhat_W = -(out + 0.1 * (M * out));
  condition.gap = 0.1 + 0.5 * 0.01 * glm::dot(out, M * out);
  haptic::Constraint constraint;
  applyCondition(rigidDifferential(p_WMo, anyVector(1.0)), condition, constraint);
  const Twist direction{anyVector(1.0), anyVector(1.0)};
  const Twist motion{1e-4 * direction.linear, 1e-4 * direction.angular};
  const dquat turn = quaternionFromRotationVector(motion.angular);
  const dvec3 e = glm::inverse(turn) * (corner - carried(foot, p_WMo, motion));  // as the part sees it
  const double exact = glm::dot(out, e) + 0.5 * glm::dot(e, M * e);
  RC_ASSERT(std::abs(haptic::evaluate(constraint, vectorOf(motion)) - exact) < 1e-9);
}

TEST(PartDifferential, GradientIsNormalAndLeverCrossNormal) {
  PointCondition condition;
  condition.p_WQ = {0.3, 0.1, 0.0};
  condition.nhat_W = {0.0, 0.0, 1.0};
  haptic::Constraint constraint;
  applyCondition(rigidDifferential(dvec3(0.0), dvec3(0.5)), condition, constraint);
  const dvec3 moment = glm::cross(condition.p_WQ, condition.nhat_W);
  const haptic::Vector6 expected{0, 0, 1, moment.x, moment.y, moment.z};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(constraint.gradient[i], expected[i], 1e-15);
}

TEST(PartDifferential, SphereIsExactAtAnyDistance) {
  // f = (|e + R n|^2 - R^2) / 2R is what rank-3 curvature 1/R means: zero on the whole sphere.
  const double R = 0.01;
  PointCondition condition;
  condition.M = dmat3(1.0 / R);
  haptic::Constraint constraint;
  applyCondition(rigidDifferential(dvec3(0.0), dvec3(0.0)), condition, constraint);
  for (double angle : {0.1, 0.7, 1.5, 3.0}) {
    const dvec3 e = R * dvec3(std::sin(angle), 0.0, std::cos(angle) - 1.0);
    EXPECT_NEAR(haptic::evaluate(constraint, {e.x, e.y, e.z, 0, 0, 0}), 0.0, 1e-12);
  }
}

TEST(PartDifferential, TrimIsTheFirstOrder) {
  PointCondition condition;
  condition.p_WQ = {0.0, 0.2, 0.0};
  condition.nhat_W = {1.0, 0.0, 0.0};
  condition.gap = 0.004;
  haptic::Constraint constraint;
  applyTrim(rigidDifferential(dvec3(0.0), dvec3(0.0)), condition, constraint);
  EXPECT_TRUE(constraint.has_trim);
  EXPECT_EQ(constraint.trim_gap, 0.004);
  EXPECT_NEAR(constraint.trim_gradient[0], 1.0, 1e-15);
  EXPECT_NEAR(constraint.trim_gradient[5], -0.2, 1e-15);
}

}  // namespace
}  // namespace hapticell::manipulation
