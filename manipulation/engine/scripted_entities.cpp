// SPDX-License-Identifier: Apache-2.0
// Entities that go by themselves (workcell::ScriptedMotion): the part of ManipulationEngine that moves them.
#include <algorithm>
#include <cmath>

#include "manipulation/engine/manipulation_step.h"

namespace hapticell::manipulation {

namespace {

constexpr double kLongestScriptedStep = 0.1;  // s: what stood still (a stalled machine) does not leap.

}  // namespace

void ManipulationEngine::moveScripted() {
  const double dt = scripted_ns_ < 0 ? 0.0 : std::min(kLongestScriptedStep, 1e-9 * static_cast<double>(now_ns_ - scripted_ns_));
  scripted_ns_ = now_ns_;
  if (!scene_) return;
  for (const workcell::Entity& entity : scene_->entities()) {
    if (!entity.motion || (held_ && held_->id() == entity.id)) continue;
    OnItsWay& at = scripted_[entity.id];
    EntityConfiguration where = placement(entity.id);
    const dvec3 before = entity.motion->displacementAt(at.t);
    const dvec3 way = entity.motion->displacementAt(at.t + dt) - before;
    // A belt that begins anew is not gone back with: nothing is pushed by that.
    const bool leaps = glm::length(way) > 2.0 * dt * 2.0 + 1e-9;
    double share = 1.0;
    if (held_ && way != dvec3(0.0) && !leaps) share = held_->moveOther(entity.id, way);
    if (share >= 1.0) {
      at.t += dt;
      where.X_WE.p = entity.X_WE.p + entity.motion->displacementAt(at.t);
    } else {
      at.t += share * dt;
      where.X_WE.p += share * way;
    }
    placements_[entity.id] = std::move(where);
    const dvec3 velocity = share >= 1.0 ? entity.motion->velocityAt(at.t) : dvec3(0.0);
    if (velocity != at.velocity_W || leaps) set_wanted_ = true;  // What was foreseen is no longer true.
    at.velocity_W = velocity;
    if (leaps && held_) retake();
  }
}

/// Of the obstacles, as motions of the stylus: those that go by themselves, and all where the mapping drifts.
void ManipulationEngine::addVelocities() {
  for (std::size_t i = 0; i < built_.set.count; ++i) {
    dvec3& velocity_D = built_.set.constraints[i].velocity_D;
    velocity_D -= drift_D_;
    const int pair = i < built_.origins.size() ? built_.origins[i].pair : -1;
    if (pair < 0 || scripted_.empty()) continue;
    const auto moving = scripted_.find(held_->pairs()[static_cast<std::size_t>(pair)].other);
    if (moving == scripted_.end()) continue;
    velocity_D += mapping_.toDevice(Twist{moving->second.velocity_W, dvec3(0.0)}).linear;
  }
}

}  // namespace hapticell::manipulation
