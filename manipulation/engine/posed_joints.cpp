// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/posed_joints.h"

#include <algorithm>
#include <cmath>

#include "manipulation/engine/snapshot_maker.h"
#include "manipulation/engine/stylus_holder.h"

namespace hapticell::manipulation {

namespace {

/// ns between two attempts: gloves give a hundred poses a second. Half: attempts without news; twice: every second pose
/// is left out.
constexpr std::int64_t kPosePeriod = 8'000'000;
/// m: nearer than this a posed part touches, as kContactOut. Half: light contacts are not shown; twice: shown early.
constexpr double kTouches = 2e-4;
/// m: pairs of a posed hand are shown from here on, as kShownAtLeast. Half: fewer near misses are looked for; twice:
/// more queries.
constexpr double kPosedShown = 0.05;

/// Each finger by itself: one that touches does not hold up the others. Where the hand stands then.
EntityConfiguration bringFingers(HeldEntity& hand, const command::PoseJoints& wanted) {
  EntityConfiguration at = hand.standing();
  for (const std::vector<std::size_t>& finger : wanted.fingers) {
    EntityConfiguration target = at;
    double way = 0.0;
    for (const std::size_t i : finger) {
      if (i >= at.joints.size()) continue;
      way = std::max(way, std::abs(wanted.joints[i] - at.joints[i]));
      target.joints[i] = wanted.joints[i];
    }
    if (way < 1e-9) continue;
    hand.goTo(target);
    at = hand.standing();
  }
  return at;
}

}  // namespace

void PosedJoints::want(const command::PoseJoints& wanted) {
  if (cell_.scene()) {  // Else judged when the first one comes.
    const workcell::Entity* entity = cell_.find(wanted.entity);
    if (entity == nullptr || entity->locked || wanted.joints.size() != cell_.placement(wanted.entity).joints.size()) {
      posed_.reset();
      wanted_.reset();
      return;
    }
  }
  wanted_ = wanted;
}

void PosedJoints::takeScene() {
  posed_.reset();
  if (wanted_) want(command::PoseJoints(*wanted_));
}

HeldEntity* PosedJoints::ownHand() {
  const workcell::EntityId entity = wanted_->entity;
  if (poses(entity)) return posed_.get();
  const workcell::Entity& found = *cell_.find(entity);
  const MovedBy moved_by = found.figure() ? MovedBy(by::Whole{}) : MovedBy(by::Base{});
  const HoldOptions options{moved_by, found.contact.on_contact, found.contact.force_class, true};
  auto taken = HeldEntity::take(cell_.scene(), entity, cell_.placements(), options, cell_.configuration());
  if (!taken) {
    log_.notice(taken.error().text());
    wanted_.reset();
    return nullptr;
  }
  posed_ = std::move(*taken);
  return posed_.get();
}

/// Who brings the joints there: the stylus that holds the entity, or a hand that is taken for it alone.
HeldEntity* PosedJoints::poser(StylusHolder& stylus) {
  if (!stylus.grip().holds(wanted_->entity)) return ownHand();
  posed_.reset();
  return stylus.yieldJoints() ? stylus.grip().held() : nullptr;
}

void PosedJoints::follow(StylusHolder& stylus) {
  const std::int64_t now = cell_.clock().now();
  if (!wanted_ || !cell_.scene() || now - posed_ns_ < kPosePeriod) return;
  posed_ns_ = now;
  HeldEntity* const hand = poser(stylus);
  if (hand == nullptr) return;
  const HeldEntity* const held = stylus.held();
  if (hand != held && held != nullptr) hand->placeOther(held->id(), held->standing());
  const EntityConfiguration before = hand->standing();
  const EntityConfiguration at = bringFingers(*hand, *wanted_);
  if (areSame(before, at)) return;
  moved_ = true;
  if (hand == held) return stylus.wantSetForOthers();
  stylus.placeOther(hand->id(), at);
}

void PosedJoints::placeOther(workcell::EntityId id, const EntityConfiguration& at) {
  if (posed_ && posed_->id() != id) posed_->placeOther(id, at);
}

void PosedJoints::addTo(SceneSnapshot& snapshot) const {
  if (!posed_) return;
  std::vector<FreeMotion::PairDistance> near;
  posed_->distances(kPosedShown, near);
  const std::size_t first = snapshot.pairs.size();
  for (const FreeMotion::PairDistance& one : near) {
    const HeldPair& pair = posed_->pairs()[one.pair];
    PairState shown = shownPair(pair, one.result, one.result.distance < std::max(kTouches, pair.safety_distance));
    if (shown.contact || shown.near_miss) snapshot.pairs.push_back(std::move(shown));
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
