// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/set_scheduler.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

namespace {

constexpr double kFreeZone = 10.0;                              ///< m: nothing held, nothing to be met.
constexpr double kLeastTurnAhead = 0.06, kMostTurnAhead = 0.4;  ///< rad that a set is good for.
constexpr double kMostGuidedTurn = 0.6;                         ///< rad, where a guide turns the entity.
constexpr double kRefreshMoved = 1e-3;                          ///< m in hand space: worth a new set ...
constexpr double kRefreshAge = 25e-3;                           ///< ... after so many seconds,
constexpr double kOldestSet = 100e-3;                           ///< and in any case after so many.
constexpr double kRested = 2e-5;                                ///< m: has not moved,
constexpr double kOldestAtRest = 400e-3;                        ///< ... then the set may be older.
constexpr double kZoneShare = 0.3;                              ///< At once when so much of the zone is used up.
constexpr double kHeldShare = 0.6;                              ///< Of the zone: until then an old set does.
constexpr double kSpeedKept = 0.5;                              ///< s that a fast hand is expected to be fast again.
constexpr double kSpeedReserve = 1.3;                           ///< It may get faster meanwhile.
constexpr double kWidestZone = 0.5;                             ///< m of hand.
constexpr std::size_t kMostOnTheirWay = 1000;
constexpr double kLeastAhead = 2.0;  ///< Of the way since the last set, the least that a set is to be good for;
constexpr double kLeastZone = 0.8e-3, kMostLeastZone = 3e-3;  ///< m: always asked for, and never more.
constexpr double kLag = 0.5e-3;                   ///< m the accepted pose may stay behind before that is felt.
constexpr std::int64_t kNewsPeriod = 20'000'000;  ///< ns between two sets that are made because others moved.

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
  addLagRow(inputs);
  inputs.scripted.addVelocities(built_, held, mapping, inputs.hand.drift_D());
  return true;
}

void SetScheduler::update(const Inputs& inputs, haptic::HapticLink& link) {
  if (!isDue(inputs)) return;
  const bool changed = std::exchange(wanted_, false);
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
