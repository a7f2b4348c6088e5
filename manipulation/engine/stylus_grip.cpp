// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/stylus_grip.h"

#include <algorithm>
#include <utility>

namespace hapticell::manipulation {

namespace {

/// One mannequin, drawn by its two hands.
bool areBothHands(const MovedBy& a, const MovedBy& b) {
  const auto *one = std::get_if<by::Hand>(&a), *other = std::get_if<by::Hand>(&b);
  return one != nullptr && other != nullptr && one->side != other->side;
}

}  // namespace

void StylusGrip::searchInThread() {
  if (search_) return;
  search_ = std::make_unique<ContactSearch>();
  if (held_) held_->searchWith(search_.get());
}

bool StylusGrip::moves(workcell::EntityId id) const {
  if (!held_) return false;
  const auto carried = held_->carried();
  return held_->id() == id || std::any_of(carried.begin(), carried.end(), [&](const auto& c) { return c.first == id; });
}

EntityConfiguration StylusGrip::placement(workcell::EntityId id) const {
  if (holds(id)) return held_->standing();
  if (held_) {
    for (auto& [carried, at] : held_->carried()) {
      if (carried == id) return at;
    }
  }
  return cell_.placement(id);
}

void StylusGrip::choose(workcell::EntityId entity) {
  chosen_ = entity;
  on_contact_.reset();
  force_class_.reset();
}

bool StylusGrip::take(workcell::EntityId entity) {
  const workcell::Entity* found = cell_.find(entity);
  if (found == nullptr) return false;
  const HoldOptions options{moved_by_, on_contact_.value_or(found->contact.on_contact), forceClassOf(*found),
                            joints_move_};
  auto taken = HeldEntity::take(cell_.scene(), entity, cell_.placements(), options, cell_.configuration());
  if (!taken) {
    log_.notice(taken.error().text());
    return false;
  }
  held_ = std::move(*taken);
  held_->searchWith(search_.get());
  told_.clear();
  for (const Text& note : held_->notes()) log_.noticeOnce(note);
  return true;
}

void StylusGrip::putDown() {
  cell_.place(held_->id(), held_->standing());
  for (auto& [id, at] : held_->carried()) cell_.place(id, std::move(at));
  held_.reset();
}

result::Moved StylusGrip::whereHeld() const {
  const EntityConfiguration at = held_->standing();
  result::Moved moved{held_->id(), at.X_WE, at.joints};
  for (auto& [id, axis] : held_->axes()) moved.axes.push_back({id, axis.X_WE, axis.joints});
  return moved;
}

workcell::EntityId StylusGrip::entityAt(const Pose& X_WTip, double reach) const {
  geometry::TriangleMesh point;
  point.vertices = {dvec3(0.0)};
  point.triangles = {{0, 0, 0}};
  const auto tip = collision::MeshCollider::build(point);
  double nearest = reach;
  workcell::EntityId found = 0;
  for (const ScenePart& part : cell_.scene()->parts()) {
    const workcell::Entity& entity = *cell_.find(part.entity);
    if (entity.locked || !entity.visible) continue;
    const EntityConfiguration at = placement(part.entity);
    const Pose X_WP = PreparedScene::partPose(entity, at.X_WE, at.joints, part.link);
    const collision::DistanceResult result = collision::distance(tip, X_WTip, part.mesh.collider, X_WP, nearest);
    if (result.beyond_limit || result.distance >= nearest) continue;
    nearest = result.distance;
    found = part.entity;
  }
  return found;
}

void StylusGrip::setOther(workcell::EntityId held, const MovedBy& moved_by) {
  other_held_ = held;
  if (held != 0) other_moved_by_ = moved_by;
}

Text StylusGrip::heldElsewhere(workcell::EntityId wanted) const {
  const workcell::Entity* entity = cell_.find(wanted);
  const workcell::Entity* other = cell_.find(other_held_);
  if (entity == nullptr || other == nullptr) return {};
  if (wanted == other_held_) {
    if (entity->figure() && areBothHands(moved_by_, other_moved_by_)) return {};
    return Text("%1 is held by the other stylus", entity->name);
  }
  if (cell_.standsOn(wanted, other_held_))
    return Text("%1 moves with %2, which the other stylus holds: release it there first", entity->name, other->name);
  if (cell_.standsOn(other_held_, wanted))
    return Text("%2 carries %1, which the other stylus holds: release it there first", other->name, entity->name);
  return {};
}

bool StylusGrip::placeOther(workcell::EntityId id, const EntityConfiguration& at) {
  const bool moved = !areSame(cell_.placement(id), at);
  if (moved) cell_.place(id, at);
  const auto [told, is_new] = told_.try_emplace(id, at);
  if (!is_new && areSame(told->second, at)) return false;
  told->second = at;
  if (held_) held_->placeOther(id, at);
  return moved || !is_new || held_;
}

}  // namespace hapticell::manipulation
