// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/shapes/shapes.h"
#include "manipulation/session/session.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation::test {

inline workcell::Entity solid(workcell::EntityId id, const std::string& name, geometry::TriangleMesh mesh,
                              const Pose& X_WE = {}) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.X_WE = X_WE;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
  return entity;
}

/// A table 1 x 1 m with its top at z = 0, and a box of 60 mm whose bottom is `height` above it.
inline std::vector<workcell::Entity> boxOverTable(double height) {
  return {solid(1, "table", geometry::makeBox({1.0, 1.0, 0.1}), Pose::translation({0, 0, -0.05})),
          solid(2, "box", geometry::makeBox(dvec3(0.06)), Pose::translation({0, 0, 0.03 + height}))};
}

struct Waypoint {
  double t;
  dvec3 p;
  dvec3 turn{0.0};
};

/// A hand that goes smoothly from one point to the next (cosine speed), the button pressed from `press` on for 0.1 s.
inline haptic::HandPath handThrough(const std::vector<Waypoint>& points, double press = 0.05) {
  std::vector<haptic::HandSample> samples;
  for (int i = 0; i <= std::lround(points.back().t * 100.0); ++i) {
    const double t = 0.01 * i;
    std::size_t k = 0;
    while (k + 2 < points.size() && points[k + 1].t < t) ++k;
    const Waypoint &a = points[k], &b = points[k + 1];
    const double u = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
    const double s = 0.5 - 0.5 * std::cos(std::numbers::pi * u);
    const Pose X_DH{a.p + s * (b.p - a.p), quaternionFromRotationVector(a.turn + s * (b.turn - a.turn))};
    samples.push_back({t, X_DH, t >= press && t < press + 0.1 ? 1U : 0U});
  }
  return haptic::HandPath(std::move(samples));
}

inline SessionOptions sessionOf(std::vector<workcell::Entity> entities, const std::string& entity,
                                haptic::HandPath hand, double rate_hz, double latency_s) {
  SessionOptions options;
  options.entities = std::move(entities);
  options.entity = entity;
  options.hand = std::move(hand);
  options.configuration.manipulation.rate_hz = rate_hz;
  options.latency_s = latency_s;
  return options;
}

/// m, with a radian as 0.1 m.
inline double placeError(const Pose& a, const Pose& b) {
  const Twist off = difference(a, b);
  return std::max(glm::length(off.linear), 0.1 * glm::length(off.angular));
}

}  // namespace hapticell::manipulation::test
