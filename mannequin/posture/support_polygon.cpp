// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/support_polygon.h"

#include <algorithm>
#include <utility>

namespace hapticell::mannequin {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace

double SupportPolygon::margin(const glm::dvec2& point) const {
  double least = 1e9;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 a = points[i], edge = points[(i + 1) % count] - a;
    const double length = glm::length(edge);
    if (length > 1e-9) least = std::min(least, cross(edge, point - a) / length);
  }
  return least;
}

SupportPolygon supportPolygon(const Figure& figure, const std::array<SegmentPlace, 2>& feet,
                              const std::array<bool, 2>& on_ground) {
  const Sole& sole = figure.sole;
  std::array<glm::dvec2, 10> all{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!on_ground[i]) continue;
    const auto add = [&](double x, double y) { all[n++] = glm::dvec2(feet[i].point({x, y, sole.z})); };
    for (const double edge : {-0.5, 0.5}) {
      add(sole.heel_x, edge * sole.heel_width);
      add(sole.ball_x, edge * sole.ball_width);
    }
    add(sole.toe_x, 0.0);
  }
  const auto before = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  for (std::size_t i = 1; i < n; ++i) {
    for (std::size_t k = i; k > 0 && before(all[k], all[k - 1]); --k) std::swap(all[k], all[k - 1]);
  }
  // Monotone chain (A. M. Andrew, 1979): lower hull, then upper.
  SupportPolygon hull;
  const auto extend = [&](const glm::dvec2& p, std::size_t keep) {
    while (hull.count >= keep + 2 &&
           cross(hull.points[hull.count - 1] - hull.points[hull.count - 2], p - hull.points[hull.count - 1]) <= 0.0) {
      --hull.count;
    }
    hull.points[hull.count++] = p;
  };
  for (std::size_t i = 0; i < n; ++i) extend(all[i], 0);
  const std::size_t lower = hull.count > 0 ? hull.count - 1 : 0;
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 == n) continue;
    extend(all[i], lower);
  }
  if (hull.count > 1) --hull.count;
  return hull;
}

std::array<bool, 2> standingFeet(const Figure& figure, const FigurePose& pose) {
  // m over the lower sole: the foot bears nothing; over what a step of the solver leaves. Half: a sole on a mat bears
  // nothing; twice: a foot over the floor bears.
  constexpr double kLifted = 0.01;
  std::array<double, 2> height{};
  for (const Side side : {Side::kLeft, Side::kRight})
    height[static_cast<std::size_t>(side)] = (footPose(pose, side) * dvec3(0.0, 0.0, figure.sole.z)).z;
  const double floor = std::min(height[0], height[1]);
  return {height[0] < floor + kLifted, height[1] < floor + kLifted};
}

}  // namespace hapticell::mannequin
