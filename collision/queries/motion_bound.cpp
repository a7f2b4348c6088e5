// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/motion_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::collision {

double turnBound(const Pose& X_WB0, const Pose& X_WB1, double radius) {
  const dquat turn = X_WB1.q * glm::conjugate(X_WB0.q);
  return 2.0 * radius * std::min(1.0, glm::length(dvec3(turn.x, turn.y, turn.z)));
}

Turn turnOf(const Pose& X_WB0, const Pose& X_WB1) {
  const dquat turn = X_WB1.q * glm::conjugate(X_WB0.q);
  const dvec3 v(turn.x, turn.y, turn.z);  // The sine of half of the angle, along the axis.
  const double square = glm::dot(v, v);
  // A rotation is 1 + sin [n]x + (1 - cos) [n]x^2.
  return {2.0 * turn.w * v, 2.0 * square, 2.0 * std::min(1.0, std::sqrt(square))};
}

double motionBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius) {
  return glm::distance(X_WB0 * p_BS, X_WB1 * p_BS) + turnBound(X_WB0, X_WB1, radius);
}

MotionLever leverOf(const MeshCollider& a, const MeshCollider& b) {
  const bool is_a = a.radius() < b.radius();
  const MeshCollider& smaller = is_a ? a : b;
  return {smaller.center(), smaller.radius(), is_a};
}

double motionBound(const MotionLever& lever, const Pose& X_AB0, const Pose& X_AB1) {
  return lever.is_a ? motionBound(X_AB0.inverse(), X_AB1.inverse(), lever.p, lever.radius)
                    : motionBound(X_AB0, X_AB1, lever.p, lever.radius);
}

double pathBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius) {
  const Twist whole = difference(X_WB1, X_WB0);
  const double angle = glm::length(whole.angular);
  const dvec3 swing = glm::cross(whole.angular, X_WB0.rotate(p_BS));
  // S moves with `linear` plus a swing that only turns: bounded by their sum, and by the speed at the start plus how
  // far the swing can turn away from that. The second is the better one when a body turns about its own middle.
  const double turned_away = glm::length(swing) * 2.0 * std::sin(0.5 * std::min(angle, std::numbers::pi));
  const double speed_of_center =
      std::min(glm::length(whole.linear) + glm::length(swing), glm::length(whole.linear + swing) + turned_away);
  return speed_of_center + angle * radius;
}

}  // namespace hapticell::collision
