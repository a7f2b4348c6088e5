// SPDX-License-Identifier: Apache-2.0
#include "collision/motion_bound.h"

#include <algorithm>
#include <cmath>

namespace hapticell::collision {

double motionBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius) {
  const double shift = glm::distance(X_WB0 * p_BS, X_WB1 * p_BS);
  const dquat turn = X_WB1.q * glm::conjugate(X_WB0.q);
  const double half_sine = std::min(1.0, glm::length(dvec3(turn.x, turn.y, turn.z)));
  return shift + 2.0 * radius * half_sine;
}

double pathBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius) {
  // About the body's own origin, which is what runs straight: S itself may swing about it.
  const Twist whole = difference(X_WB1, X_WB0);
  return glm::length(whole.linear) + glm::length(whole.angular) * (glm::length(p_BS) + radius);
}

}  // namespace hapticell::collision
