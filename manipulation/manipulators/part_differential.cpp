// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/part_differential.h"

#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

namespace {

dvec3 unit(std::size_t i) {
  return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
}

/// The part of a rotating lever's acceleration that is quadratic in the angular velocities, symmetric in both.
dvec3 centripetal(const dvec3& w1, const dvec3& w2, const dvec3& lever) {
  return 0.5 * (glm::cross(w1, glm::cross(w2, lever)) + glm::cross(w2, glm::cross(w1, lever)));
}

}  // namespace

PartDifferential rigidDifferential(const dvec3& p_WMo, const dvec3& p_WPo) {
  PartDifferential part;
  part.p_WPo = p_WPo;
  const dvec3 lever = p_WPo - p_WMo;
  for (std::size_t i = 0; i < 3; ++i) {
    part.velocity[i].linear = unit(i);
    part.velocity[i + 3] = {glm::cross(unit(i), lever), unit(i)};
    for (std::size_t j = i; j < 3; ++j) {
      part.acceleration[packedIndex(i + 3, j + 3)].linear = centripetal(unit(i), unit(j), lever);
    }
  }
  return part;
}

dvec3 pointVelocity(const PartDifferential& part, const dvec3& p_WQ, std::size_t i) {
  return part.velocity[i].linear + glm::cross(part.velocity[i].angular, p_WQ - part.p_WPo);
}

dvec3 pointAcceleration(const PartDifferential& part, const dvec3& p_WQ, std::size_t i, std::size_t j) {
  const dvec3 lever = p_WQ - part.p_WPo;
  const Twist& a = part.acceleration[i <= j ? packedIndex(i, j) : packedIndex(j, i)];
  return a.linear + glm::cross(a.angular, lever) +
         centripetal(part.velocity[i].angular, part.velocity[j].angular, lever);
}

namespace {

/// Second-order term of f = n(xi) . (a(xi) - q), where the part's face through a with normal n meets a fixed corner q.
double movingNormalTerm(const PartDifferential& part, const PointCondition& condition, std::size_t i, std::size_t j) {
  const Twist &vi = part.velocity[i], &vj = part.velocity[j];
  const dvec3& n = condition.nhat_W;
  const Twist& a = part.acceleration[packedIndex(i, j)];
  const dvec3 second = centripetal(vi.angular, vj.angular, n) + glm::cross(a.angular, n);
  return glm::dot(second, part.p_WPo - condition.p_WQ) + glm::dot(glm::cross(vi.angular, n), vj.linear) +
         glm::dot(glm::cross(vj.angular, n), vi.linear) + glm::dot(n, a.linear);
}

}  // namespace

void applyCondition(const PartDifferential& part, const PointCondition& condition, haptic::Constraint& constraint_W) {
  std::array<dvec3, 6> v;
  for (std::size_t i = 0; i < 6; ++i) v[i] = pointVelocity(part, condition.p_WQ, i);
  constraint_W.gap = condition.gap;
  for (std::size_t i = 0; i < 6; ++i) {
    constraint_W.gradient[i] = glm::dot(condition.nhat_W, v[i]);
    const dvec3 Mv = condition.M * v[i];
    for (std::size_t j = i; j < 6; ++j) {
      constraint_W.curvature[packedIndex(i, j)] =
          glm::dot(Mv, v[j]) + (condition.normal_moves
                                    ? movingNormalTerm(part, condition, i, j)
                                    : glm::dot(condition.nhat_W, pointAcceleration(part, condition.p_WQ, i, j)));
    }
  }
}

void applyTrim(const PartDifferential& part, const PointCondition& condition, haptic::Constraint& constraint_W) {
  constraint_W.has_trim = true;
  constraint_W.trim_gap = condition.gap;
  for (std::size_t i = 0; i < 6; ++i) {
    constraint_W.trim_gradient[i] = glm::dot(condition.nhat_W, pointVelocity(part, condition.p_WQ, i));
  }
}

}  // namespace hapticell::manipulation
