// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/set_scheduler.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

namespace {

/// m: nothing held, nothing to be met; wider than any workspace. Half and twice as well.
constexpr double kFreeZone = 10.0;
/// rad that a set is good for: a slow wrist (0.6 rad/s) for 0.1 s, and 23 deg at most, as rows are of second order.
/// Half: the turn's bound is felt; twice: more entries, smaller zones.
constexpr double kLeastTurnAhead = 0.06, kMostTurnAhead = 0.4;
/// rad, where a guide turns the entity, as its turn follows from its place. Half: narrow zones near hinges; twice:
/// beyond what second order tells (proxy_rows.cpp: 0.1 % off at 0.5 rad).
constexpr double kMostGuidedTurn = 0.6;
/// m in hand space: worth a new set, a sixtieth of the wanted zone. Half: twice the sets of a slow hand; twice: sets
/// that are good for less when they are needed.
constexpr double kRefreshMoved = 1e-3;
/// s after which such a motion makes a set: 40 a second. Half: twice the searches while moving; twice: a hand at 0.25
/// m/s is 12 mm farther.
constexpr double kRefreshAge = 25e-3;
/// s, and in any case a new set, kLateSetAge of the server. Half: twice the sets of a resting hand; twice: moved parts
/// are felt late.
constexpr double kOldestSet = 100e-3;
/// m: has not moved, the skin of a held part. Half: tremor counts; twice: slow motion counts as rest for 0.4 s.
constexpr double kRested = 2e-5;
/// s for a hand at rest; the server misses sets after 2 s (Safety analysis). Half: twice the sets; twice: still under
/// it.
constexpr double kOldestAtRest = 400e-3;
/// Of the zone: at once when so much is used up, so that the hand has the rest until the new set is there. Half: twice
/// the sets; twice: it meets the edge where a search takes longer.
constexpr double kZoneShare = 0.3;
/// Of the zone: until then an old set does while the next is worked out (Contacts: the inner 0.6). Half: plain sets
/// sooner; 0.9: the hand meets the edge while waiting.
constexpr double kHeldShare = 0.6;
/// s that a fast hand is expected to be fast again: a time constant, about a stroke. Half: the second stroke meets the
/// edge; twice: wide zones, which are dear, for a slow hand.
constexpr double kSpeedKept = 0.5;
/// It may get faster meanwhile, by 30 %. Half (15 %): the edge is felt at each start; twice: zones wider than needed.
constexpr double kSpeedReserve = 1.3;
/// m of hand: wider than any workspace here. Half: still; twice: searches for what no hand reaches.
constexpr double kWidestZone = 0.5;
/// Sets sent and not adopted yet whose times are kept: a second at 1000 Hz. Half and twice matter only to links that
/// are lost.
constexpr std::size_t kMostOnTheirWay = 1000;
/// Of the way since the last set, the least that a set is to be good for: one for the next set, one in reserve. Half:
/// no reserve; twice: crowded places turn to plain sets.
constexpr double kLeastAhead = 2.0;
/// m: always asked for (a hand at 0.08 m/s until the next of 100 sets), and never more. Half: slow hands meet the edge;
/// twice: crowds have plain sets in place of complete ones.
constexpr double kLeastZone = 0.8e-3, kMostLeastZone = 3e-3;
/// m the accepted pose may stay behind before that is felt: half of a N at 1 N/mm. Half: an entity on its way is felt
/// as a drag; twice: it is seen beside the pen.
constexpr double kLag = 0.5e-3;
/// ns between two sets that are made because others moved: 50 a second. Half: sets for each small step of a conveyor;
/// twice: moved parts are felt 40 ms late (their velocity is in the set).
constexpr std::int64_t kNewsPeriod = 20'000'000;

double metric(const Pose& a, const Pose& b) {
  const Twist t = difference(a, b);
  return std::sqrt(glm::dot(t.linear, t.linear) +
                   haptic::kRotationLever * haptic::kRotationLever * glm::dot(t.angular, t.angular));
}

double seconds(std::int64_t nanoseconds) {
  return 1e-9 * static_cast<double>(nanoseconds);
}

}  // namespace

void SetScheduler::wantForOthers(std::int64_t now_ns) {
  if (now_ns - set_ns_ >= kNewsPeriod) wanted_ = true;
}

/// m of hand between where the entity stands and the reference of the newest set.
double SetScheduler::moved(const Inputs& inputs) const {
  return metric(inputs.hand.mapping().toDevice(inputs.held->movedFrame(), inputs.state.X_DP), built_.set.X_DR);
}

bool SetScheduler::isDue(const Inputs& inputs) const {
  const double age = seconds(inputs.now_ns - set_ns_);
  if (wanted_) return true;
  if (inputs.held == nullptr) return age >= kOldestSet;
  if (inputs.held->hasAnswer()) return true;
  if (refresh_ && inputs.now_ns - set_ns_ >= kNewsPeriod && age >= 2.0 * built_.cost) return true;
  const double way = moved(inputs);
  // Sets that are dear are made less often: they get half of the time.
  if (age < std::min(kOldestSet, 2.0 * built_.cost)) return false;
  if (age >= (way > kRested ? kOldestSet : kOldestAtRest)) return true;
  return way > kZoneShare * built_.set.zone_radius || (way > kRefreshMoved && age >= kRefreshAge);
}

/// The set that was sent last goes on being good while the next one is being worked out.
bool SetScheduler::holdsStill(const Inputs& inputs) const {
  const double way = moved(inputs);
  return built_.complete && way < kHeldShare * built_.set.zone_radius;
}

void SetScheduler::addLagRow(const Inputs& inputs) {
  haptic::ConstraintSet& set = built_.set;
  const Pose& X_DP = inputs.state.X_DP;
  const Twist lag = difference(X_DP, set.X_DR);
  const double length = metric(X_DP, set.X_DR);
  const double way = metric(set.X_DR, X_DLag_);
  X_DLag_ = set.X_DR;
  // An entity that is on its way is given time to come.
  if (length < kLag || way > kLag || set.count >= haptic::kMaxConstraints) return;
  // Only where nothing in the set says why the entity stays behind: the inverse model's branch, a motion that the exact
  // check refuses.
  gaps_.resize(inputs.held->pairs().size());
  pairGaps(built_, X_DP, gaps_);
  for (const double gap : gaps_) {
    if (gap < -0.2 * kLag) return;
  }
  const haptic::Vector6 xi{lag.linear.x, lag.linear.y, lag.linear.z, lag.angular.x, lag.angular.y, lag.angular.z};
  for (std::size_t i = 0; i < set.count; ++i) {
    if (built_.origins[i].limit >= 0 && haptic::evaluate(set.constraints[i], xi) < -0.2 * kLag) return;
  }
  haptic::Constraint row;
  row.group = set.count == 0 ? 0 : set.constraints[set.count - 1].group + 1;
  row.gap = 0.4 * kLag;
  row.id = ~std::uint64_t{0};
  for (std::size_t i = 0; i < 6; ++i) {
    const double weight = i < 3 ? 1.0 : haptic::kRotationLever * haptic::kRotationLever;
    row.gradient[i] = -weight * xi[i] / length;
  }
  set.constraints[set.count++] = row;
  built_.origins.push_back({});
}

/// A zone wide enough for what the hand does until the set after this one is felt: its way there and back and one
/// period.
void SetScheduler::wishZone(const Inputs& inputs, HeldEntity::SetWish& wish) {
  while (!on_their_way_.empty() && on_their_way_.front().first <= inputs.state.adopted_set) {
    adopted_ns_ = on_their_way_.front().second;
    on_their_way_.pop_front();
  }
  const double aged = std::exp(-seconds(inputs.now_ns - speed_ns_) / kSpeedKept);
  speed_ = std::max(glm::length(inputs.state.v_DS), aged * speed_);
  speed_ns_ = inputs.now_ns;
  wish.zone_radius = configured_radius_;
  if (inputs.state.adopted_set == 0) return;
  const double ahead = seconds(inputs.now_ns - adopted_ns_) + seconds(inputs.now_ns - last_set_ns_);
  const double coming = inputs.scripted.fastest();
  // Where the last one had to shrink, asking for more only costs time.
  const double most = std::max(configured_radius_, std::min(kWidestZone, 2.0 * built_.set.zone_radius));
  wish.needed_radius = std::min(kWidestZone, kSpeedReserve * (speed_ + coming / inputs.hand.mapping().scale()) * ahead);
  wish.zone_radius = std::clamp(wish.needed_radius, configured_radius_, most);
}

HeldEntity::SetWish SetScheduler::wish(const Inputs& inputs, bool changed) {
  // A wrist that turns fast needs a set that knows more of turning, at the cost of its radius.
  const Twist since = difference(inputs.state.X_DS, X_DSeen_);
  X_DSeen_ = inputs.state.X_DS;
  HeldEntity::SetWish wish;
  wish.turn_ahead = std::clamp(kLeastTurnAhead + 2.0 * glm::length(since.angular), kLeastTurnAhead, kMostTurnAhead);
  // A slow hand is content with a small zone, as long as it says everything.
  wish.least_radius = std::clamp(kLeastAhead * glm::length(since.linear), kLeastZone, kMostLeastZone);
  wish.anew = changed;
  wish.may_wait = !changed && holdsStill(inputs);
  wishZone(inputs, wish);
  const double guided = inputs.guides.turnWithin(wish.zone_radius, *inputs.held, inputs.hand.mapping());
  wish.turn_ahead = std::max(wish.turn_ahead, std::min(kMostGuidedTurn, guided));
  return wish;
}

bool SetScheduler::make(const Inputs& inputs, bool changed) {
  HeldEntity& held = *inputs.held;
  const MotionMapping& mapping = inputs.hand.mapping();
  const HeldEntity::SetWish wanted = wish(inputs, changed);
  BuiltConstraints built = held.constraints(mapping, inputs.state.X_DP, wanted);
  if (built.pending && wanted.may_wait) return false;
  built_ = std::move(built);
  // Where nothing is to be felt the set is good everywhere: its edge must not be felt instead.
  const auto passes = [](const HeldPair& pair) { return pair.on_contact == workcell::OnContact::kPass; };
  if (built_.set.count == 0 && std::all_of(held.pairs().begin(), held.pairs().end(), passes))
    built_.set.zone_radius = kFreeZone;
  inputs.guides.addTo(built_, held, mapping, inputs.state.X_DP);
  inputs.plan.addTo(built_, held, mapping);
  addLagRow(inputs);
  inputs.scripted.addVelocities(built_, held, mapping, inputs.hand.drift_D());
  return true;
}

void SetScheduler::update(const Inputs& inputs, haptic::HapticLink& link) {
  if (!isDue(inputs)) return;
  const bool changed = std::exchange(wanted_, false);
  refresh_ = false;
  const std::int64_t before_ns = std::exchange(last_set_ns_, std::exchange(set_ns_, inputs.now_ns));
  if (inputs.held != nullptr) {
    if (!make(inputs, changed)) {
      set_ns_ = std::exchange(last_set_ns_, before_ns);
      return;
    }
  } else {
    built_ = {};
    built_.set.X_DR = inputs.state.X_DP;
    built_.set.zone_radius = kFreeZone;
  }
  built_.set.sequence = ++sequence_;
  built_.set.stamp_ns = inputs.now_ns;
  on_their_way_.emplace_back(sequence_, inputs.now_ns);
  if (on_their_way_.size() > kMostOnTheirWay) on_their_way_.pop_front();
  link.sendSet(built_.set);
}

}  // namespace hapticell::manipulation
