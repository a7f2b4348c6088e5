// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/session_meter.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/proximity_query.h"

namespace hapticell::manipulation {

namespace {

constexpr double kInterruption = 0.050;  ///< s
constexpr double kDeepest = 1.0;         ///< m: what is not free by then counts as this deep.

struct Body {
  std::shared_ptr<const collision::MeshCollider> collider;
  Pose X_W;
};

/// Shortest translation along `direction` (doubled, then halved) that takes `moved` out of `other`.
double depthAlong(const Body& moved, const Body& other, const dvec3& direction) {
  const auto collides = [&](double shift) {
    const Pose X_W{moved.X_W.p + shift * direction, moved.X_W.q};
    return collision::distance(moved.collider, X_W, other.collider, other.X_W).colliding;
  };
  double free = 1e-7;
  while (free < kDeepest && collides(free)) free *= 2.0;
  if (free >= kDeepest) return kDeepest;
  double stuck = 0.5 * free;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (free + stuck);
    (collides(middle) ? stuck : free) = middle;
  }
  return free;
}

double depthOf(const Body& moved, const Body& other) {
  const collision::DistanceResult found =
      collision::distance(moved.collider, moved.X_W, other.collider, other.X_W, 1e-3);
  if (!found.colliding) return 0.0;
  double least = depthAlong(moved, other, found.nhat_BA_W);
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 direction(0.0);
    direction[axis] = 1.0;
    least = std::min({least, depthAlong(moved, other, direction), depthAlong(moved, other, -direction)});
  }
  return least;
}

}  // namespace

void ForceMeter::add(const MeteredTick& tick) {
  max_force_ = std::max(max_force_, glm::length(tick.force_D));
  if (started_) {
    const double ms = std::max(1e-6, 1e3 * (tick.t - last_.t));
    max_step_ = std::max(max_step_, glm::length(tick.force_D - last_.force_D) / std::max(1.0, ms));
    energy_.add(tick.step_D, last_.coupling_D, tick.stiffness);
    energy_.note(tick.t);
  }
  started_ = true;
  last_ = tick;
}

void ContactLog::add(double t, const ManipulationEngine& engine, double force) {
  if (const HeldEntity* held = engine.held()) {
    for (const std::size_t i : engine.contacts()) {
      const HeldPair& pair = held->pairs()[i];
      const auto key = std::pair(held->id(), pair.other);
      if (open_.count(key) == 0) {
        open_[key] = events_.size();
        // Of what it carries the carried entity's name stands for the part.
        const bool own = pair.owner == held->id();
        const std::string& part = own ? pair.moved_part : engine.scene()->find(pair.owner)->name;
        events_.push_back({held->id(), pair.other, part, pair.other_part, t, t, 0.0, true});
      }
      const std::size_t event = open_[key];
      last_seen_[event] = t;
      events_[event].time_out = t;
      const bool passes = pair.on_contact == workcell::OnContact::kPass;
      events_[event].max_force = std::max(events_[event].max_force, passes ? 0.0 : force);
    }
  }
  for (auto it = open_.begin(); it != open_.end();) {
    const bool over = t - last_seen_[it->second] > kInterruption;
    if (over) events_[it->second].open = false;
    it = over ? open_.erase(it) : std::next(it);
  }
}

void ContactLog::finish(double t) {
  for (const auto& [key, event] : open_) events_[event].time_out = t;
}

void LimitLog::add(double t, const ManipulationEngine& engine) {
  const double interruption = std::max(kInterruption, 2.5 * (t - t_before_));  // a slow loop looks rarely
  t_before_ = t;
  for (const LimitState& limit : engine.nearLimits()) {
    if (!limit.holds) continue;
    const auto key = std::pair(limit.kind, limit.joint);
    const auto known = open_.find(key);
    if (known == open_.end() || t - events_[known->second].time_out > interruption) {
      open_[key] = events_.size();
      events_.push_back({english(limit.text), limit.kind, limit.joint, t, t});
    }
    events_[open_[key]].time_out = t;
  }
}

void JointMeter::add(double t, const ManipulationEngine& engine) {
  const HeldEntity* held = engine.held();
  const workcell::Entity* entity = held ? engine.scene()->find(held->id()) : nullptr;
  if (!entity || !entity->robot || entity->figure) {
    id_ = 0;
    return;
  }
  const std::vector<double> now = held->standing().joints;
  const bool goes_on = id_ == held->id() && before_.size() == now.size() && t > t_before_;
  if (joints_.size() != now.size()) joints_.assign(now.size(), {});
  for (std::size_t i = 0; i < now.size(); ++i) {
    JointUse& use = joints_[i];
    const int joint = entity->robot->moving[i];
    if (use.joint < 0) {
      use = {joint, now[i], now[i], 0.0,
             kinematics::greatestSpeed(entity->robot->joints[static_cast<std::size_t>(joint)])};
    }
    use.lowest = std::min(use.lowest, now[i]);
    use.highest = std::max(use.highest, now[i]);
    if (goes_on) use.max_speed = std::max(use.max_speed, std::abs(now[i] - before_[i]) / (t - t_before_));
  }
  before_ = now;
  t_before_ = t;
  id_ = held->id();
}

double PenetrationMeter::measure(const ManipulationEngine& engine) {
  const HeldEntity* held = engine.held();
  const PreparedScene* scene = engine.scene();
  if (held == nullptr || scene == nullptr) return 0.0;
  const EntityConfiguration& now = held->accepted();
  if (measured_id_ == held->id() && now.X_WE.p == measured_.X_WE.p && now.X_WE.q == measured_.X_WE.q &&
      now.joints == measured_.joints) {
    return last_;  // Nothing has moved since.
  }
  measured_id_ = held->id();
  measured_ = now;
  const auto bodyOf = [&](workcell::EntityId id, const std::string& part_name) {
    const EntityConfiguration at = engine.placement(id);
    for (const ScenePart& part : scene->parts()) {
      if (part.entity != id || part.name != part_name) continue;
      return Body{part.mesh.collider, PreparedScene::partPose(*scene->find(id), at.X_WE, at.joints, part.link)};
    }
    return Body{};
  };
  double deepest = 0.0;
  for (const HeldPair& pair : held->pairs()) {
    const Body moved = bodyOf(pair.owner, pair.moved_part), other = bodyOf(pair.other, pair.other_part);
    if (!moved.collider || !other.collider) continue;
    const double depth = depthOf(moved, other);
    deepest = std::max(deepest, depth);
    if (pair.on_contact != workcell::OnContact::kPass) worst_blocked_ = std::max(worst_blocked_, depth);
  }
  last_ = deepest;
  worst_ = std::max(worst_, deepest);
  return deepest;
}

}  // namespace hapticell::manipulation
