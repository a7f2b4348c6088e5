// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/scripted_motion.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/shapes/vector.h"

namespace hapticell::workcell {

namespace {

// m/s, as a hand moves quickly: a part that the held one is to be kept from must not jump over it. Half: such motions
// are refused; twice: contacts are met 2 mm deeper in a step of 1 ms.
constexpr double kFastest = 2.0;

/// The time within the points, and whether it runs backwards there.
struct Phase {
  double t = 0.0;
  bool back = false;
  bool over = false;
};

Phase phaseOf(const ScriptedMotion& motion, double t) {
  const double end = motion.points.back().t;
  if (!(t > 0.0)) return {};
  if (motion.repeat == MotionRepeat::kOnce) return {std::min(t, end), false, t >= end};
  if (motion.repeat == MotionRepeat::kLoop) return {std::fmod(t, end)};
  const double u = std::fmod(t, 2.0 * end);
  return u < end ? Phase{u} : Phase{2.0 * end - u, true};
}

/// The leg that is gone at `phase`: index of its first point.
std::size_t legAt(const ScriptedMotion& motion, const Phase& phase) {
  std::size_t leg = 0;
  while (leg + 2 < motion.points.size() &&
         (phase.back ? motion.points[leg + 1].t < phase.t : motion.points[leg + 1].t <= phase.t)) {
    ++leg;
  }
  return leg;
}

}  // namespace

dvec3 ScriptedMotion::displacementAt(double t) const {
  if (points.size() < 2) return dvec3(0.0);
  const Phase phase = phaseOf(*this, t);
  const std::size_t leg = legAt(*this, phase);
  const Point &a = points[leg], &b = points[leg + 1];
  return glm::mix(a.p_W, b.p_W, std::clamp((phase.t - a.t) / (b.t - a.t), 0.0, 1.0));
}

dvec3 ScriptedMotion::velocityAt(double t) const {
  if (points.size() < 2) return dvec3(0.0);
  const Phase phase = phaseOf(*this, t);
  if (phase.over) return dvec3(0.0);
  const std::size_t leg = legAt(*this, phase);
  const dvec3 v = (points[leg + 1].p_W - points[leg].p_W) / (points[leg + 1].t - points[leg].t);
  return phase.back ? -v : v;
}

Expected<void> checkMotion(const ScriptedMotion& motion) {
  const auto refuse = [](Text place, Text found, Text expected) {
    return makeError({.place = std::move(place), .found = std::move(found), .expected = std::move(expected)});
  };
  if (motion.points.size() < 2) {
    return refuse("motion.path", Text("%1 points", motion.points.size()), Text("at least two"));
  }
  if (motion.points.front().t != 0.0) {
    return refuse(Text("motion.path point %1", 1), Text("time %1", std::to_string(motion.points.front().t)), "0");
  }
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const ScriptedMotion::Point& p = motion.points[i];
    const Text place("motion.path point %1", i + 1);
    if (!std::isfinite(p.t) || !isFinite(p.p_W))
      return refuse(place, Text("a number that is not finite"), "t, x, y, z");
    if (i == 0) continue;
    const double dt = p.t - motion.points[i - 1].t;
    if (!(dt > 0.0))
      return refuse(place, Text("a time that is not after the time before"), Text("increasing times in seconds"));
    const double speed = glm::distance(p.p_W, motion.points[i - 1].p_W) / dt;
    if (!(speed <= kFastest)) return refuse(place, std::to_string(speed) + " m/s", Text("at most 2 m/s"));
  }
  return {};
}

}  // namespace hapticell::workcell
