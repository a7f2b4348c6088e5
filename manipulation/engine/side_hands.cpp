// SPDX-License-Identifier: Apache-2.0
// What moves beside the stylus: a second stylus with an engine of its own, and a hand that a glove poses.
#include <algorithm>
#include <cmath>

#include "manipulation/engine/manipulation_step.h"

namespace hapticell::manipulation {

namespace {

constexpr std::int64_t kNewsPeriod = 20'000'000;  ///< ns between two sets that are made because others moved.
constexpr std::int64_t kPosePeriod = 8'000'000;   ///< ns between two attempts: gloves tell a hundred poses a second.
constexpr double kTouches = 2e-4;                 ///< m: nearer than this a posed part touches.
constexpr double kPosedShown = 0.05;              ///< m: pairs of a posed hand are told from here on.

/// One mannequin, drawn by its two hands.
bool areBothHands(const MovedBy& a, const MovedBy& b) {
  const auto *one = std::get_if<by::Hand>(&a), *other = std::get_if<by::Hand>(&b);
  return one != nullptr && other != nullptr && one->side != other->side;
}

bool same(const EntityConfiguration& a, const EntityConfiguration& b) {
  return a.X_WE.p == b.X_WE.p && a.X_WE.q == b.X_WE.q && a.joints == b.joints;
}

}  // namespace

/// Others moved: the set that is felt is not true any more. Not at every step, a set costs time.
void ManipulationEngine::wishSetForOthers() {
  if (now_ns_ - set_ns_ >= kNewsPeriod) set_wanted_ = true;
}

void ManipulationEngine::placeOther(workcell::EntityId id, const EntityConfiguration& at) {
  if (same(placement(id), at)) return;
  placements_[id] = at;
  if (held_) held_->placeOther(id, at);
  if (posed_ && posed_->id() != id) posed_->placeOther(id, at);
  wishSetForOthers();
}

bool ManipulationEngine::standsOn(workcell::EntityId entity, workcell::EntityId below) const {
  const workcell::Entity* at = scene_->find(entity);
  for (std::size_t deep = 0; at != nullptr && deep <= scene_->entities().size(); ++deep) {
    if (at->id == below) return true;
    at = at->attachment.to.empty() ? nullptr : scene_->find(at->attachment.to);
  }
  return false;
}

/// Why it may not be taken while the other stylus holds what it holds; empty: it may.
std::string ManipulationEngine::heldElsewhere(workcell::EntityId wanted) const {
  const workcell::Entity* entity = scene_->find(wanted);
  const workcell::Entity* other = scene_->find(other_held_);
  if (entity == nullptr || other == nullptr) return {};
  if (wanted == other_held_) {
    if (entity->figure && areBothHands(moved_by_, other_moved_by_)) return {};
    return entity->name + " is held by the other stylus";
  }
  if (standsOn(wanted, other_held_))
    return entity->name + " goes with " + other->name + ", which the other stylus holds";
  if (standsOn(other_held_, wanted)) return other->name + ", which the other stylus holds, goes with " + entity->name;
  return {};
}

void ManipulationEngine::takeOver(const ManipulationEngine& other) {
  other_held_ = scene_ && other.held_ && other.scene_ == scene_ ? other.held_->id() : 0;
  const bool is_mine = held_ && other.posed_ && held_->id() == other.posed_->id();
  if (scene_ && other.posed_ && other.scene_ == scene_ && !is_mine)
    placeOther(other.posed_->id(), other.posed_->standing());
  if (other_held_ == 0) return;
  if (posed_ && posed_->id() == other_held_) posed_.reset();
  other_moved_by_ = other.moved_by_;
  if (held_) {
    if (const std::string why = heldElsewhere(held_->id()); !why.empty()) {
      notice(why);
      release();
    }
  }
  recordOther(other);
  const workcell::EntityId id = other.held_->id();
  const EntityConfiguration at = other.held_->standing();
  if (held_ && held_->id() == id) {
    if (same(held_->standing(), at) || !yieldJoints()) return;
    held_->goTo(at);
    wishSetForOthers();
    return;
  }
  const auto goes_along = [&](workcell::EntityId one) {
    if (!held_) return false;
    const auto carried = held_->carried();
    return held_->id() == one ||
           std::any_of(carried.begin(), carried.end(), [&](const auto& c) { return c.first == one; });
  };
  placeOther(id, at);
  for (const auto& [carried, there] : other.held_->carried()) {
    if (!goes_along(carried)) placeOther(carried, there);
  }
}

void ManipulationEngine::borrowPose(const ManipulationEngine& other) {
  const bool mine = other.wanted_pose_ && held_ && held_->id() == other.wanted_pose_->entity &&
                    !(other.held_ && other.held_->id() == held_->id());
  wanted_pose_ = mine ? other.wanted_pose_ : std::nullopt;
}

void ManipulationEngine::poseJoints(const command::PoseJoints& wanted) {
  if (!scene_) {  // Judged when the first one comes.
    wanted_pose_ = wanted;
    return;
  }
  const workcell::Entity* entity = scene_->find(wanted.entity);
  if (entity == nullptr || entity->locked || wanted.joints.size() != placement(wanted.entity).joints.size()) {
    posed_.reset();
    wanted_pose_.reset();
    return;
  }
  wanted_pose_ = wanted;
}

/// What is held lets somebody else move its joints: it is taken anew for that where it must. False: it cannot.
bool ManipulationEngine::yieldJoints() {
  if (held_->manipulator().movesJoints()) return true;
  if (joints_move_) return false;
  joints_move_ = true;
  retake();
  return held_ && held_->manipulator().movesJoints();
}

/// Who brings the joints there: the hand that holds the entity, or one that is taken for it alone.
HeldEntity* ManipulationEngine::poser(workcell::EntityId entity) {
  if (held_ && held_->id() == entity) {
    posed_.reset();
    return yieldJoints() ? held_.get() : nullptr;
  }
  if (posed_ && posed_->id() == entity) return posed_.get();
  const workcell::Entity& found = *scene_->find(entity);
  const MovedBy moved_by = found.figure ? MovedBy(by::Whole{}) : MovedBy(by::Base{});
  const HoldOptions options{moved_by, found.on_contact, found.force_class, true};
  auto taken = HeldEntity::take(scene_, entity, placements_, options, configuration_);
  if (!taken) {
    notice(taken.error().message());
    wanted_pose_.reset();
    return nullptr;
  }
  posed_ = std::move(*taken);
  return posed_.get();
}

void ManipulationEngine::followPose() {
  if (!wanted_pose_ || !scene_ || now_ns_ - posed_ns_ < kPosePeriod) return;
  posed_ns_ = now_ns_;
  const bool is_held_here = held_ && held_->id() == wanted_pose_->entity;
  if (wanted_pose_->entity == other_held_ && !is_held_here) return;  // The other one poses what it holds.
  HeldEntity* const hand = poser(wanted_pose_->entity);
  if (hand == nullptr) return;
  if (hand == posed_.get() && held_) hand->placeOther(held_->id(), held_->standing());
  const EntityConfiguration before = hand->standing();
  EntityConfiguration at = before;
  // Each finger by itself: one that touches does not hold up the others.
  for (const std::vector<std::size_t>& finger : wanted_pose_->fingers) {
    EntityConfiguration target = at;
    double way = 0.0;
    for (const std::size_t i : finger) {
      if (i >= at.joints.size()) continue;
      way = std::max(way, std::abs(wanted_pose_->joints[i] - at.joints[i]));
      target.joints[i] = wanted_pose_->joints[i];
    }
    if (way < 1e-9) continue;
    hand->goTo(target);
    at = hand->standing();
  }
  if (same(before, at)) return;
  posed_moved_ = true;
  if (hand == held_.get()) return wishSetForOthers();
  placements_[hand->id()] = at;
  if (held_) held_->placeOther(hand->id(), at);
  wishSetForOthers();
}

/// What a posed hand touches and is near, as the window and a glove's vibrators want it.
void ManipulationEngine::addPosed(SceneSnapshot& snapshot) {
  if (!posed_) return;
  std::vector<FreeMotion::PairDistance> near;
  posed_->distances(kPosedShown, near);
  const std::size_t first = snapshot.pairs.size();
  for (const FreeMotion::PairDistance& one : near) {
    const HeldPair& pair = posed_->pairs()[one.pair];
    PairState shown;
    shown.moved = pair.owner;
    shown.other = pair.other;
    shown.moved_part = pair.moved_part;
    shown.other_part = pair.other_part;
    shown.distance = one.result.distance;
    shown.p_WA = one.result.p_WA;
    shown.p_WB = one.result.p_WB;
    shown.contact = one.result.colliding || one.result.distance < std::max(kTouches, pair.safety_distance);
    shown.near_miss_distance = pair.near_miss;
    shown.near_miss = one.result.distance < pair.near_miss;
    if (shown.contact || shown.near_miss) snapshot.pairs.push_back(shown);
  }
  std::sort(snapshot.pairs.begin() + static_cast<std::ptrdiff_t>(first), snapshot.pairs.end(),
            [](const PairState& a, const PairState& b) { return a.distance < b.distance; });
  for (EntityState& entity : snapshot.entities) {
    if (entity.id != posed_->id()) continue;
    for (std::size_t i = first; i < snapshot.pairs.size(); ++i) {
      entity.in_contact = entity.in_contact || snapshot.pairs[i].contact;
      entity.near_miss = entity.near_miss || snapshot.pairs[i].near_miss;
    }
  }
}

}  // namespace hapticell::manipulation
