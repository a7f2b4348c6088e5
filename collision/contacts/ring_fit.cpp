// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/ring_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::collision {
namespace {

/// From the foot, along the ring and round the tube: each 22.5 deg. Half: the worst place may be missed by 22 deg;
/// twice: twice the time.
constexpr int kWays = 16;
/// Places on each way; the deviation grows with the third power, so the last one counts. Half: an end between two is
/// missed and found by halving; twice: twice the time.
constexpr int kSteps = 6;
/// And where the reach or the element ends, to 1/96 of the way (1 / (6 x 2^4)): 3 % of the deviation. Half: 12 %;
/// twice: a third more time for nothing.
constexpr int kHalvings = 4;
/// m that a place may lie beyond the element's end: rounding and the accuracy of recognition (1 um). Half and twice
/// still stand between that and 0.1 mm of a facet.
constexpr double kEndSlack = 1e-5;

/// Where a ball's centre runs on the ring: place and outward normal by the angles from the foot.
struct Ring {
  dvec3 center, axis, e1, e2;  // e1 points to the foot
  double major = 0.0, tube = 0.0, side = 1.0, foot = 0.0;

  Ring(const SurfaceShape& shape, double offset, const dvec3& p) : center(shape.p_M), axis(shape.axis_M) {
    major = shape.major_radius;
    side = shape.side;
    tube = shape.radius + side * offset;
    const dvec3 v = p - center;
    const double height = glm::dot(v, axis);
    const dvec3 flat = v - height * axis;
    const double out = glm::length(flat);
    const dvec3 any = std::abs(axis.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    e1 = out > 1e-12 ? flat / out : glm::normalize(glm::cross(axis, any));
    e2 = glm::cross(axis, e1);
    foot = std::atan2(height, out - major);
  }
  dvec3 at(double along, double round) const {
    const dvec3 ray = std::cos(along) * e1 + std::sin(along) * e2;
    return center + major * ray + tube * (std::cos(foot + round) * ray + std::sin(foot + round) * axis);
  }
};

}  // namespace

double ringDeviation(const BallQuery& ball, const SurfaceElement& element, const dmat3& row_M) {
  const Ring ring(element.shape, ball.radius, ball.p_M);
  if (ring.tube <= 0.0) return 0.0;
  const dvec3 foot = ring.at(0.0, 0.0);
  const double gap = glm::length(foot - ball.p_M);
  if (gap >= ball.reach) return 0.0;
  const SurfaceView view = viewFrom(element.shape, ball.p_M);
  const double wide = std::sqrt(ball.reach * ball.reach - gap * gap) + gap;
  const double most_along = std::min(std::numbers::pi, wide / std::max(1e-9, ring.major - ring.tube));
  const double most_round = std::min(std::numbers::pi, 1.6 * wide / ring.tube);
  const auto counts = [&](const dvec3& q) {
    if (glm::length(q - ball.p_M) > ball.reach) return false;
    const double value = elementValue(element, q, ball.radius);
    return element.shape.side > 0.0 ? value >= -kEndSlack : value <= kEndSlack;
  };
  const auto deviation = [&](const dvec3& q) {
    const dvec3 e = q - foot, slope = view.nhat_M + row_M * e;
    const double value = glm::dot(view.nhat_M, e) + 0.5 * glm::dot(e, row_M * e);
    return std::abs(value) / std::max(0.2, glm::length(slope));
  };
  double worst = 0.0;
  const auto follow = [&](const auto& place) {
    double inside = 0.0, outside = 0.0;
    for (int k = 1; k <= kSteps; ++k) {
      const double share = static_cast<double>(k) / kSteps;
      const dvec3 q = place(share);
      if (!counts(q)) {
        outside = outside > inside ? outside : share;
        continue;
      }
      worst = std::max(worst, deviation(q));
      inside = share;
    }
    // It grows outwards, so the last place that counts says most.
    for (int k = 0; k < kHalvings && outside > inside; ++k) {
      const double middle = 0.5 * (inside + outside);
      const dvec3 q = place(middle);
      if (counts(q)) {
        worst = std::max(worst, deviation(q));
        inside = middle;
      } else {
        outside = middle;
      }
    }
  };
  for (int i = 0; i < kWays; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kWays;
    const double along = most_along * std::cos(turn), round = most_round * std::sin(turn);
    follow([&](double share) { return ring.at(share * along, share * round); });
  }
  if (counts(foot)) return worst;
  // The element is elsewhere on the tube, and ways from the foot may pass it by: along the ring at all of its height.
  for (int i = 0; i < kWays; ++i) {
    const double round = most_round * (2.0 * i / (kWays - 1) - 1.0);
    follow([&](double share) { return ring.at(share * most_along, round); });
    follow([&](double share) { return ring.at(-share * most_along, round); });
  }
  return worst;
}

}  // namespace hapticell::collision
