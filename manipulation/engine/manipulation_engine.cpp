// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/manipulation_engine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/system/assertion.h"

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
constexpr std::int64_t kPassedPeriod = 10'000'000;            ///< ns.
constexpr double kContactIn = 5e-5, kContactOut = 2e-4;       ///< m of gap.
constexpr double kLag = 0.5e-3;  ///< m the accepted pose may stay behind before that is felt.

double metric(const Pose& a, const Pose& b) {
  const Twist t = difference(a, b);
  return std::sqrt(glm::dot(t.linear, t.linear) +
                   haptic::kRotationLever * haptic::kRotationLever * glm::dot(t.angular, t.angular));
}

double seconds(std::int64_t nanoseconds) {
  return 1e-9 * static_cast<double>(nanoseconds);
}

}  // namespace

ManipulationEngine::ManipulationEngine(haptic::HapticLink& link, const config::Configuration& configuration)
    : link_(link), configuration_(configuration) {
  control_.stiffness = configuration.haptic.stiffness;
  control_.damping = configuration.haptic.damping;
  // A camera in front of the cell: screen axes are then the cell's own.
  camera_.X_WCamera = {dvec3(0.0, -1.0, 0.0), quaternionFromRotationVector(dvec3(0.5 * std::numbers::pi, 0.0, 0.0))};
  updateMapping();
}

void ManipulationEngine::searchInThread() {
  if (search_) return;
  search_ = std::make_unique<ContactSearch>();
  if (held_) held_->searchWith(search_.get());
}

std::vector<Result> ManipulationEngine::takeResults() {
  std::vector<Result> taken;
  taken.swap(results_);
  return taken;
}

EntityConfiguration ManipulationEngine::placement(workcell::EntityId entity) const {
  if (held_ && held_->id() == entity) return held_->standing();
  if (held_) {
    for (auto& [id, at] : held_->carried()) {
      if (id == entity) return at;
    }
  }
  if (const auto moved = placements_.find(entity); moved != placements_.end()) return moved->second;
  const workcell::Entity* found = scene_ ? scene_->find(entity) : nullptr;
  HAPTICELL_DEMAND(found != nullptr);
  return {found->X_WE, found->joints};
}

void ManipulationEngine::takeState() {
  const haptic::LinkState now = link_.linkState();
  // Forces that a lost server took away do not come back with the next one: they are asked for again.
  if (link_state_ == haptic::LinkState::kConnected && now != link_state_) control_.forces_enabled = false;
  if (now != link_state_ && now == haptic::LinkState::kConnected) {
    link_.sendControl(control_);
    set_wanted_ = true;
    updateMapping();
  }
  link_state_ = now;
  if (std::optional<haptic::HapticState> newest = link_.latestState()) state_ = *newest;
  // What a server said that is gone is no answer for the next one: its forces are off until it says otherwise.
  if (state_ && now != haptic::LinkState::kConnected) {
    state_->forces_on = false;
    state_->force_ramp = 0.0;
    state_->force_D = dvec3(0.0);
  }
  if (std::optional<haptic::ServerStatistics> newest = link_.latestStatistics()) statistics_ = *newest;
}

bool ManipulationEngine::needsSet() const {
  const double age = seconds(now_ns_ - set_ns_);
  if (set_wanted_) return true;
  if (held_ && !clutched_ && held_->hasAnswer()) return true;
  if (!held_ || clutched_) return age >= kOldestSet;
  const double moved = metric(mapping_.toDevice(held_->movedFrame(), state_->X_DP), built_.set.X_DR);
  // Sets that are dear are made less often: they get half of the time.
  if (age < std::min(kOldestSet, 2.0 * built_.cost)) return false;
  if (age >= (moved > kRested ? kOldestSet : kOldestAtRest)) return true;
  return moved > kZoneShare * built_.set.zone_radius || (moved > kRefreshMoved && age >= kRefreshAge);
}

/// The set that was sent last goes on being good while the next one is being worked out.
bool ManipulationEngine::holdsStill() const {
  const double moved = metric(mapping_.toDevice(held_->movedFrame(), state_->X_DP), built_.set.X_DR);
  return built_.complete && moved < kHeldShare * built_.set.zone_radius;
}

void ManipulationEngine::addLagRow() {
  haptic::ConstraintSet& set = built_.set;
  const Twist lag = difference(state_->X_DP, set.X_DR);
  const double length = metric(state_->X_DP, set.X_DR);
  const double moved = metric(set.X_DR, X_DLag_);
  X_DLag_ = set.X_DR;
  // An entity that is on its way is given time to come.
  if (length < kLag || moved > kLag || set.count >= haptic::kMaxConstraints) return;
  // Only where nothing in the set says why the entity stays behind: the inverse model's branch, a motion that the exact
  // check refuses.
  pairGaps(built_, state_->X_DP, gaps_);
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
void ManipulationEngine::wishZone(HeldEntity::SetWish& wish) {
  while (!on_their_way_.empty() && on_their_way_.front().first <= state_->adopted_set) {
    adopted_ns_ = on_their_way_.front().second;
    on_their_way_.pop_front();
  }
  const double aged = std::exp(-seconds(now_ns_ - speed_ns_) / kSpeedKept);
  speed_ = std::max(glm::length(state_->v_DS), aged * speed_);
  speed_ns_ = now_ns_;
  const double configured = configuration_.manipulation.zone_radius;
  wish.zone_radius = configured;
  if (state_->adopted_set == 0) return;
  const double ahead = seconds(now_ns_ - adopted_ns_) + seconds(now_ns_ - last_set_ns_);
  double coming = 0.0;
  for (const auto& [id, on_its_way] : scripted_) coming = std::max(coming, glm::length(on_its_way.velocity_W));
  // Where the last one had to shrink, asking for more only costs time.
  const double most = std::max(configured, std::min(kWidestZone, 2.0 * built_.set.zone_radius));
  wish.needed_radius = std::min(kWidestZone, kSpeedReserve * (speed_ + coming / mapping_.scale()) * ahead);
  wish.zone_radius = std::clamp(wish.needed_radius, configured, most);
}

void ManipulationEngine::updateSet() {
  if (!needsSet()) return;
  const bool changed = std::exchange(set_wanted_, false);
  const std::int64_t before_ns = std::exchange(last_set_ns_, std::exchange(set_ns_, now_ns_));
  if (held_ && !clutched_) {
    // A wrist that turns fast needs a set that knows more of turning, at the cost of its radius.
    const Twist since = difference(state_->X_DS, X_DSeen_);
    const double turned = glm::length(since.angular);
    X_DSeen_ = state_->X_DS;
    HeldEntity::SetWish wish;
    wish.turn_ahead = std::clamp(kLeastTurnAhead + 2.0 * turned, kLeastTurnAhead, kMostTurnAhead);
    // A slow hand is content with a small zone, as long as it says everything.
    wish.least_radius = std::clamp(kLeastAhead * glm::length(since.linear), kLeastZone, kMostLeastZone);
    wish.anew = changed;
    wish.may_wait = !changed && holdsStill();
    wishZone(wish);
    wish.turn_ahead = std::max(wish.turn_ahead, std::min(kMostGuidedTurn, guidedTurnWithin(wish.zone_radius)));
    BuiltConstraints built = held_->constraints(mapping_, state_->X_DP, wish);
    if (built.pending && wish.may_wait) {
      set_ns_ = std::exchange(last_set_ns_, before_ns);
      return;
    }
    built_ = std::move(built);
    // Where nothing is to be felt the set is good everywhere: its edge must not be felt instead.
    const auto passes = [](const HeldPair& pair) { return pair.on_contact == workcell::OnContact::kPass; };
    if (built_.set.count == 0 && std::all_of(held_->pairs().begin(), held_->pairs().end(), passes)) {
      built_.set.zone_radius = kFreeZone;
    }
    addGuideRows();
    addLagRow();
    addVelocities();
  } else {
    built_ = {};
    built_.set.X_DR = state_->X_DP;
    built_.set.zone_radius = kFreeZone;
  }
  built_.set.sequence = ++sequence_;
  built_.set.stamp_ns = now_ns_;
  on_their_way_.emplace_back(sequence_, now_ns_);
  if (on_their_way_.size() > kMostOnTheirWay) on_their_way_.pop_front();
  link_.sendSet(built_.set);
}

bool ManipulationEngine::isIdle() const {
  const bool forces = control_.forces_enabled || (state_ && state_->forces_on);
  return !forces && !held_ && !posed_ && !recorder_ && other_held_ == 0 && scripted_.empty();
}

/// What the joints may use of time in this step. A loop that was held up does not let them catch up at once.
double ManipulationEngine::stepTime() const {
  constexpr double kLongest = 0.1, kShortest = 1e-4;  // s
  return std::clamp(seconds(now_ns_ - last_step_ns_), kShortest, kLongest);
}

void ManipulationEngine::findContacts() {
  if (!held_ || clutched_) return;
  pairGaps(built_, state_->X_DP, gaps_);
  std::vector<std::size_t> now;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const bool was = std::find(contacts_.begin(), contacts_.end(), i) != contacts_.end();
    if (gaps_[i] < (was ? kContactOut : kContactIn)) now.push_back(i);
  }
  findPassed();
  now.insert(now.end(), passed_.begin(), passed_.end());
  const auto is_new = [this](std::size_t i) {
    return std::find(contacts_.begin(), contacts_.end(), i) == contacts_.end();
  };
  if (std::any_of(now.begin(), now.end(), is_new)) felt_ns_ = stateTime();
  contacts_.swap(now);
}

/// When the newest state was, by this program's clock: the tick's stamp, as far as it can be brought to that clock.
std::int64_t ManipulationEngine::stateTime() const {
  constexpr std::int64_t kOldest = 1'000'000'000;  // ns: beyond it the clocks are not as they were told.
  if (!statistics_.clock_offset_ms) return now_ns_;
  const std::int64_t tick = state_->server_stamp_ns - std::llround(1e6 * *statistics_.clock_offset_ms);
  return now_ns_ - tick > kOldest ? now_ns_ : std::min(tick, now_ns_);
}

/// Pairs that pass have no row in the set that could tell of their contact: they are measured.
void ManipulationEngine::findPassed() {
  if (passed_ns_ >= 0 && now_ns_ - passed_ns_ < kPassedPeriod && now_ns_ >= passed_ns_) return;
  passed_ns_ = now_ns_;
  const auto passes = [](const HeldPair& pair) { return pair.on_contact == workcell::OnContact::kPass; };
  const auto& pairs = held_->pairs();
  std::vector<FreeMotion::PairDistance> near;
  if (std::any_of(pairs.begin(), pairs.end(), passes)) held_->distances(kContactOut, near);
  std::vector<std::size_t> now;
  for (const FreeMotion::PairDistance& one : near) {
    const bool was = std::find(passed_.begin(), passed_.end(), one.pair) != passed_.end();
    const bool touches = one.result.colliding || one.result.distance < (was ? kContactOut : kContactIn);
    if (passes(pairs[one.pair]) && touches) now.push_back(one.pair);
  }
  passed_.swap(now);
}

/// Once for each two entities.
void ManipulationEngine::tellWherePlain() {
  if (!held_ || contacts_.empty() || !held_->isPlain()) return;
  const HeldPair& pair = held_->pairs()[contacts_.front()];
  const std::string sentence = scene_->find(held_->id())->name + " against " + scene_->find(pair.other)->name +
                               ": the meshes are too dense there to tell all contacts, so only the nearest point of " +
                               "each pair is felt";
  if (told_.insert(sentence).second) notice(sentence);
}

void ManipulationEngine::step(std::int64_t now_ns) {
  last_step_ns_ = step_ == 0 ? now_ns : now_ns_;
  now_ns_ = now_ns;
  if (start_ns_ < 0) start_ns_ = now_ns;
  ++step_;
  takeState();
  followPose();  // A glove poses whether a stylus is connected or not.
  if (!state_) return;
  watchButtons();
  driftAtEdge();
  mapping_.lookFrom(state_->X_DP);
  moveScripted();
  if (held_ && !clutched_) {
    const HeldEntity::FollowResult followed = held_->follow(onGuides(state_->X_DP), mapping_, &built_, stepTime());
    hurried_joint_ = followed.hurried_joint;
    stopped_ = followed.stopped;
  }
  updateLoad();
  updateSet();
  findContacts();
  tellWherePlain();
  for (const std::size_t i : contacts_) {
    stopped_ = stopped_ || held_->pairs()[i].on_contact == workcell::OnContact::kStop;
  }
  recordStep();
}

}  // namespace hapticell::manipulation
