// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/scripted_entities.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

namespace {

/// s: what stood still (a stalled machine) does not leap; the slowest loop's period (10 Hz). Half: at 10 Hz conveyors
/// lag; twice: leaps of twice the length.
constexpr double kLongestScriptStep = 0.1;

/// The share of its way that an entity can go; what the grips hold has given way then.
double shareGone(workcell::EntityId entity, const dvec3& way, std::span<StylusGrip* const> grips) {
  double share = 1.0;
  for (StylusGrip* grip : grips) {
    if (grip->held() != nullptr && share > 0.0) share *= grip->held()->moveOther(entity, share * way);
  }
  return share;
}

}  // namespace

bool ScriptedEntities::move(std::span<StylusGrip* const> grips, const std::function<void()>& leapt) {
  const std::int64_t now = cell_.clock().now();
  const double dt = moved_ns_ < 0 ? 0.0 : std::min(kLongestScriptStep, 1e-9 * static_cast<double>(now - moved_ns_));
  moved_ns_ = now;
  if (!cell_.scene()) return false;
  bool changed = false;
  for (const workcell::Entity& entity : cell_.scene()->entities()) {
    const auto holds = [&](const StylusGrip* grip) { return grip->holds(entity.id); };
    if (!entity.motion || std::any_of(grips.begin(), grips.end(), holds)) continue;
    changed |= moveOne(entity, dt, grips, leapt);
  }
  return changed;
}

bool ScriptedEntities::moveOne(const workcell::Entity& entity, double dt, std::span<StylusGrip* const> grips,
                               const std::function<void()>& leapt) {
  OnItsWay& at = on_their_way_[entity.id];
  EntityConfiguration where = cell_.placement(entity.id);
  const dvec3 way = entity.motion->displacementAt(at.t + dt) - entity.motion->displacementAt(at.t);
  // The held part does not follow a belt that restarts: nothing is pushed by that.
  const bool leaps = glm::length(way) > 2.0 * dt * 2.0 + 1e-9;
  const double share = way != dvec3(0.0) && !leaps ? shareGone(entity.id, way, grips) : 1.0;
  if (share >= 1.0) {
    at.t += dt;
    where.X_WE.p = entity.X_WE.p + entity.motion->displacementAt(at.t);
  } else {
    at.t += share * dt;
    where.X_WE.p += share * way;
  }
  // Those that gave way before another could not believe it farther on than it came.
  for (StylusGrip* grip : grips) {
    if (share < 1.0 && grips.size() > 1 && grip->held() != nullptr) grip->held()->placeOther(entity.id, where);
  }
  cell_.place(entity.id, std::move(where));
  const dvec3 velocity = share >= 1.0 ? entity.motion->velocityAt(at.t) : dvec3(0.0);
  const bool changed = velocity != at.velocity_W || leaps;  // What was foreseen is no longer true.
  at.velocity_W = velocity;
  if (leaps) leapt();
  return changed;
}

double ScriptedEntities::fastest() const {
  double fastest = 0.0;
  for (const auto& [id, on_its_way] : on_their_way_) fastest = std::max(fastest, glm::length(on_its_way.velocity_W));
  return fastest;
}

void ScriptedEntities::addVelocities(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping,
                                     const dvec3& drift_D) const {
  for (std::size_t i = 0; i < built.set.count; ++i) {
    dvec3& velocity_D = built.set.constraints[i].velocity_D;
    velocity_D -= drift_D;
    const int pair = i < built.origins.size() ? built.origins[i].pair : -1;
    if (pair < 0 || on_their_way_.empty()) continue;
    const auto moving = on_their_way_.find(held.pairs()[static_cast<std::size_t>(pair)].other);
    if (moving == on_their_way_.end()) continue;
    velocity_D += mapping.toDevice(Twist{moving->second.velocity_W, dvec3(0.0)}).linear;
  }
}

}  // namespace hapticell::manipulation
