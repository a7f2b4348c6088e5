// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/penetration_meter.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "collision/queries/motion_bound.h"
#include "collision/queries/proximity_query.h"

namespace hapticell::manipulation {

namespace {

/// m: what is not free by then counts as this deep. Half and twice only change that number.
constexpr double kDeepest = 1.0;

/// m: what is farther apart than this is looked at again only when something has moved half as far. Half: all is looked
/// at twice as often; twice: more pairs are measured each time.
constexpr double kListed = 0.02;

struct Placed {
  std::shared_ptr<const collision::MeshCollider> collider;
  Pose X_W;
};

/// Shortest translation along `direction` (doubled, then halved) that takes `moved` out of `other`.
double depthAlong(const Placed& moved, const Placed& other, const dvec3& direction) {
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

double depthOf(const Placed& moved, const Placed& other) {
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

/// The parts of all pairs, each once.
void PenetrationMeter::gather(const ManipulationEngine& engine) {
  gathered_of_ = engine.held();
  scene_ = engine.scene();
  bodies_.clear();
  watched_.clear();
  std::map<std::pair<workcell::EntityId, std::string>, std::uint32_t> known;
  const auto bodyOf = [&](workcell::EntityId id, const std::string& name) {
    const auto [at, is_new] = known.try_emplace({id, name}, static_cast<std::uint32_t>(bodies_.size()));
    if (!is_new) return at->second;
    Body body;
    for (const ScenePart& part : scene_->partsOf(id)) {
      if (body.part == nullptr && part.name == name) body.part = &part;
    }
    if (body.part != nullptr) {
      const EntityConfiguration stands = engine.placement(id);
      body.X_W = PreparedScene::partPose(*scene_->find(id), stands.X_WE, stands.joints, body.part->link);
    }
    bodies_.push_back(body);
    return at->second;
  };
  std::set<workcell::EntityId> owners;
  for (const HeldPair& pair : gathered_of_->pairs()) {
    const std::uint32_t moved = bodyOf(pair.owner, pair.moved_part), other = bodyOf(pair.other, pair.other_part);
    watched_.push_back({moved, other});
    owners.insert(pair.owner);
  }
  // Links of what is held are also the other part of pairs: they move as well.
  for (Body& body : bodies_) body.may_move = body.part != nullptr && owners.contains(body.part->entity);
  listNear();
}

/// Brings what moves to where it is now; how far (m) any of it has come since the list was made, at most.
double PenetrationMeter::place(const ManipulationEngine& engine) {
  double furthest = 0.0;
  for (Body& body : bodies_) {
    if (body.part == nullptr) continue;
    const workcell::EntityId id = body.part->entity;
    if (!body.may_move && engine.placements().count(id) == 0) continue;
    const EntityConfiguration at = engine.placement(id);
    const collision::MeshCollider& mesh = *body.part->mesh.collider;
    body.X_W = PreparedScene::partPose(*scene_->find(id), at.X_WE, at.joints, body.part->link);
    furthest = std::max(furthest, collision::motionBound(body.X_WListed, body.X_W, mesh.center(), mesh.radius()));
  }
  return furthest;
}

void PenetrationMeter::listNear() {
  near_.clear();
  std::vector<geometry::Bounds> boxes(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].X_WListed = bodies_[i].X_W;
    const ScenePart* part = bodies_[i].part;
    if (part == nullptr || !part->mesh.collider || part->mesh.collider->isEmpty()) continue;
    boxes[i] = geometry::transformed(bodies_[i].X_W, part->mesh.collider->bounds());
  }
  for (std::size_t pair = 0; pair < watched_.size(); ++pair) {
    const geometry::Bounds &a = boxes[watched_[pair].moved], &b = boxes[watched_[pair].other];
    if (a.isEmpty() || b.isEmpty()) continue;
    const dvec3 gap = glm::max(a.min - b.max, b.min - a.max);
    if (std::max({gap.x, gap.y, gap.z}) <= kListed) near_.push_back(static_cast<std::uint32_t>(pair));
  }
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
  if (gathered_of_ != held || scene_ != scene || watched_.size() != held->pairs().size()) gather(engine);
  if (2.0 * place(engine) > kListed) listNear();
  double deepest = 0.0;
  for (const std::uint32_t pair : near_) {
    const Body &moved = bodies_[watched_[pair].moved], &other = bodies_[watched_[pair].other];
    const double depth = depthOf({moved.part->mesh.collider, moved.X_W}, {other.part->mesh.collider, other.X_W});
    deepest = std::max(deepest, depth);
    if (held->pairs()[pair].on_contact != workcell::OnContact::kPass) worst_blocked_ = std::max(worst_blocked_, depth);
  }
  last_ = deepest;
  worst_ = std::max(worst_, deepest);
  return deepest;
}

}  // namespace hapticell::manipulation
