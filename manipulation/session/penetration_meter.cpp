// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/penetration_meter.h"

#include <algorithm>
#include <memory>
#include <string>

#include "collision/queries/proximity_query.h"

namespace hapticell::manipulation {

namespace {

/// m: what is not free by then counts as this deep. Half and twice only change that number.
constexpr double kDeepest = 1.0;

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
