// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/figure_way.h"

#include <algorithm>
#include <cmath>

#include "manipulation/manipulators/posture_finder.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::manipulation {
namespace {

// Of the held entity between two pictures: 60 mm of way at most. Half: half as fast on the screen; twice: jerky
// pictures.
constexpr int kMostWaySteps = 12;
// m that one of them goes at the most: longer ones leave the straight way, as each turns joints by 1.8 deg (9 mm at 0.3
// m) a tick. Half: half as fast; twice: hands swing aside.
constexpr double kStrideAtMost = 5e-3;
// rad, 2 deg: as kStrideAtMost. Half: half as fast; twice: hands swing aside.
constexpr double kTurnAtMost = 0.035;
// m that a radian counts like: half of a hand. Half: rotations are left off sooner; twice: they hold up the way.
constexpr double kForearmLever = 0.1;
// m: arrived, ten times the solver's (kHandsArrived). Half: more steps for nothing seen; twice: still nothing seen.
constexpr double kThere = 2e-4;
// m: steps that bring less than this, one after the other, are the last; the solver's accuracy. Half: creeps on; twice:
// ends slow slides along a body.
constexpr double kNoNearer = 2e-5;
// Steps that bring nothing until the way ends. Half: it ends where joints only swing round; twice: twice as long at
// each end.
constexpr int kIdleSteps = 6;
// m that must be missing for a way round to be looked for, which takes a second. Half: searches for what nobody sees;
// twice: hands stay 10 mm short (Mannequin: within 10 mm).
constexpr double kWorthARound = 5e-3;
// m before it for a station of a way round (Mannequin, Drags): forearms free of the chest. Half: stations inside the
// body; twice: out of reach across.
constexpr double kBeforeTheBody = 0.28;
// Postures at the end, and each with up to three ways there. Half: fewer ways round are found; twice: the search takes
// twice as long.
constexpr std::size_t kGoalsTried = 3;
// Ways round to one place. Half: gives up sooner; twice: seconds more where there is none.
constexpr int kMostRounds = 4;
// m that are missing of who may step: the body rises and walks there from upright (Mannequin, Drags). Half: walks where
// a lean would do; twice: wrung bodies that do not come round.
constexpr double kFarOff = 0.1;
// rad of all joints together from one picture of a way round to the next. Our choice. Half: half as fast; twice: jerky.
constexpr double kPictureTurn = 1.5;
constexpr int kRoundShown = 1;  // to the next.
// Idle steps of a figure whose joints turn (kStillWalks): it walks, a stride takes some 30, so 13 strides. Half: 6;
// twice: a figure that treads on the spot does so twice as long.
constexpr int kWalkingSteps = 400;
// rad of all joints in one step: more is walking. Half: tremor of the solver counts as walking; twice: slow strides do
// not.
constexpr double kStillWalks = 0.01;
// m: what is nearer when the way ends is in the way. Half: the obstacle may not be named; twice: a neighbour is named.
constexpr double kLook = 2e-3;

}  // namespace

Expected<std::unique_ptr<FigureWay>> FigureWay::take(std::shared_ptr<const PreparedScene> scene,
                                                     workcell::EntityId entity, const HoldOptions& options, Turn turn,
                                                     const config::Configuration& configuration) {
  auto held = HeldEntity::take(scene, entity, {}, options, configuration);
  HAPTICELL_TRY(held);
  std::unique_ptr<FigureWay> way(new FigureWay);
  way->figure_ = scene->find(entity)->figure();
  way->scene_ = std::move(scene);
  way->held_ = std::move(*held);
  way->X_WTaken_ = way->X_WTarget_ = way->held_->movedFrame();
  way->mapping_.anchor(way->X_WTaken_, way->X_WTaken_);
  if (const auto* hand = std::get_if<by::Hand>(&options.moved_by)) {
    const bool left = hand->side == mannequin::Side::kLeft;
    if (turn == Turn::kWithTheForearm) way->turns_with_ = {left, !left};
    way->may_step_ = hand->may_step;
  } else if (const auto* both = std::get_if<by::BothHands>(&options.moved_by)) {
    if (turn == Turn::kWithTheForearm) way->turns_with_ = {true, true};
    way->may_step_ = both->may_step;
  }
  way->shown_ = way->held_->accepted();
  way->forearms_at_start_ = way->forearms();
  return way;
}

void FigureWay::aim(const Pose& X_WM) {
  X_WTarget_ = X_WM;
  rounds_left_ = kMostRounds;
  nearest_yet_ = least_missing_ = 1e9;
  idle_steps_ = 0;
  is_at_best_ = false;
}

FigureWay::Reach FigureWay::follow() {
  if (!round_.empty()) return showRound();
  bool blocked = false, ended = is_at_best_ || missing() < kThere;
  for (int step = 0; step < kMostWaySteps && !ended; ++step) {
    const EntityConfiguration before = held_->accepted();
    blocked = held_->follow(stride(), mapping_, nullptr).blocked;
    const double left = missing();
    idle_steps_ = left > nearest_yet_ - kNoNearer ? idle_steps_ + 1 : 0;
    nearest_yet_ = std::min(nearest_yet_, left);
    // Who walks leaves the hand behind meanwhile.
    const bool walks = may_step_ && held_->manipulator().turnBound(before, held_->accepted()) > kStillWalks;
    ended = left < kThere || idle_steps_ >= (walks ? kWalkingSteps : kIdleSteps);
    keepBest();
  }
  shown_ = held_->accepted();
  if (ended && !is_at_best_ && least_missing_ > kWorthARound && rounds_left_ > 0) {
    --rounds_left_;
    if (!isInterrupted() && goRound()) return showRound();
    if (isInterrupted()) {
      ++rounds_left_;
      ended = false;
    }
  }
  if (ended && goBack()) return showRound();
  Reach reach = reachNow();
  reach.arrived = ended;
  if (ended && (blocked || missing() > kWorthARound)) reach.obstacle = nearest();
  return reach;
}

bool FigureWay::isInterrupted() const {
  return interrupted_ && interrupted_();
}

void FigureWay::keepBest() {
  const double left = missing();
  if (left >= least_missing_ - kNoNearer) return;
  best_ = held_->accepted();
  least_missing_ = left;
}

FigureWay::Reach FigureWay::showRound() {
  for (int i = 0; i < kRoundShown && !round_.empty(); ++i) {
    shown_ = round_.back();
    round_.pop_back();
  }
  return reachNow();
}

FigureWay::Reach FigureWay::reachNow() const {
  Reach reach;
  reach.X_WM = held_->manipulator().movedFrame(shown_);
  reach.short_m = glm::length(reach.X_WM.p - X_WTarget_.p);
  return reach;
}

/// Goes to a newly solved posture at which the target is met, straight or by way of one before the body; true where
/// that was free. Where no such way is: who may step and is far off walks there upright; else only to a place before
/// the body, from where the target is drawn to once more. The hands of a standing figure only, and not past what
/// another entity holds up.
bool FigureWay::goRound() {
  const PostureFinder* hands = held_->manipulator().postureFinder();
  if (!hands || !(turns_with_[0] || turns_with_[1]) || isHeldUpByOthers()) return false;
  const EntityConfiguration start = held_->accepted();
  const dvec3 before = kBeforeTheBody * hands->facing_W(start);
  const dvec3 p_WM = held_->movedFrame().p;
  using StartFrom = PostureFinder::StartFrom;
  const auto solved = [&](const dvec3& p, StartFrom anew) { return hands->solvedFrom(start, p, anew, interrupted_); };
  std::vector<EntityConfiguration> near, far;
  bool is_in_reach = false;
  for (const StartFrom anew : {StartFrom::kPresent, StartFrom::kUpright}) {
    const auto goals = solved(X_WTarget_.p, anew);
    if (goals.empty()) continue;
    is_in_reach = true;
    near = solved(p_WM + before, anew);
    far = solved(X_WTarget_.p + before, anew);
    for (std::size_t i = 0; i < std::min(goals.size(), kGoalsTried) && !isInterrupted(); ++i) {
      if (goBy({goals[i]})) return true;
      if (!far.empty() && goBy({far.front(), goals[i]})) return true;
      if (!near.empty() && !far.empty() && goBy({near.front(), far.front(), goals[i]})) return true;
    }
  }
  if (rounds_left_ == 0 || isInterrupted()) return false;
  if (may_step_ && missing() > kFarOff && walkThere(*hands)) return true;
  // Who steps comes nearer: then only the height has to be one that a hand gets to.
  const dvec3 as_high(p_WM.x + before.x, p_WM.y + before.y, X_WTarget_.p.z);
  if (may_step_ && !is_in_reach) is_in_reach = !solved(as_high, StartFrom::kUpright).empty();
  if (!is_in_reach) return false;
  if (near.empty() && far.empty()) near = solved(p_WM + before, StartFrom::kUpright);
  if (!far.empty() && goBy({far.front()})) return true;
  return !near.empty() && goBy({near.front()});
}

/// To where the target is before the body, upright if that is free, and the hands to it; else only there.
bool FigureWay::walkThere(const PostureFinder& hands) {
  using StartFrom = PostureFinder::StartFrom;
  const EntityConfiguration start = held_->accepted();
  const auto ups = hands.upright(start);
  const dvec3 before = kBeforeTheBody * hands.facing_W(start);
  const auto near = hands.solvedFrom(start, held_->movedFrame().p + before, StartFrom::kPresent, interrupted_);
  const auto places = hands.uprightBefore(ups.front(), X_WTarget_.p);
  for (const EntityConfiguration& there : places) {
    const auto goals = hands.solvedFrom(there, X_WTarget_.p, StartFrom::kPresent, interrupted_);
    for (std::size_t i = 0; i < std::min(goals.size(), kGoalsTried) && !isInterrupted(); ++i) {
      for (const EntityConfiguration& up : ups)
        if (goBy({up, there, goals[i]}) || goBy({up, goals[i]})) return true;
      if (goBy({goals[i]})) return true;
      if (!near.empty() && (goBy({near.front(), ups.front(), goals[i]}) || goBy({near.front(), goals[i]}))) return true;
    }
  }
  if (isInterrupted()) return false;
  for (const EntityConfiguration& there : places)
    if (goBy({ups.front(), there}) || goBy({there})) return true;
  return goBy({ups.front()}) || goBy({ups.back()}) || (!near.empty() && goBy({near.front()}));
}

/// Where rounds or strides led farther off than it has been, back to there.
bool FigureWay::goBack() {
  if (is_at_best_ || missing() <= least_missing_ + kWorthARound) return false;
  const EntityConfiguration best = best_;
  is_at_best_ = true;
  return goBy({best});
}

/// Goes from one station to the next; where something is in the way, back to where it stood.
bool FigureWay::goBy(const std::vector<EntityConfiguration>& stations) {
  std::vector<EntityConfiguration> gone{held_->accepted()};
  bool free = true;
  for (const EntityConfiguration& station : stations) {
    free = free && !held_->goTo(station).blocked;
    gone.push_back(held_->accepted());
    if (!free) break;
  }
  if (!free) {
    for (auto back = gone.rbegin() + 1; back != gone.rend(); ++back) held_->goTo(*back);
    return false;
  }
  for (std::size_t leg = gone.size() - 1; leg > 0; --leg) {
    const int pictures =
        std::max(1, static_cast<int>(held_->manipulator().turnBound(gone[leg - 1], gone[leg]) / kPictureTurn));
    for (int i = pictures; i > 0; --i)
      round_.push_back(held_->manipulator().between(gone[leg - 1], gone[leg], static_cast<double>(i) / pictures));
  }
  idle_steps_ = 0;
  nearest_yet_ = 1e9;
  keepBest();
  return true;
}

bool FigureWay::isHeldUpByOthers() {
  std::vector<FreeMotion::PairDistance> near;
  held_->distances(kLook, near);
  return std::any_of(near.begin(), near.end(), [&](const auto& one) {
    return one.result.distance < kLook && held_->pairs()[one.pair].other != held_->id();
  });
}

double FigureWay::missing() const {
  const Twist left = difference(X_WTarget_, held_->movedFrame());
  const bool turn_counts = !turns_with_[0] && !turns_with_[1];
  return glm::length(left.linear) + (turn_counts ? kForearmLever * glm::length(left.angular) : 0.0);
}

/// What the next step wants: a piece of the way; all of it where pieces do not help any more.
Pose FigureWay::stride() const {
  const Pose X_WM = held_->movedFrame();
  Pose X_WT = X_WTarget_;
  if (turns_with_[0] || turns_with_[1]) {
    X_WT.q = glm::normalize(forearmsTurn() * X_WTaken_.q);
  }
  const Twist left = difference(X_WT, X_WM);
  const double parts = std::max(glm::length(left.linear) / kStrideAtMost, glm::length(left.angular) / kTurnAtMost);
  const bool as_a_whole = idle_steps_ > kIdleSteps / 2;
  if (parts <= 1.0 || as_a_whole) return X_WT;
  return interpolate(X_WM, X_WT, 1.0 / parts);
}

/// How the forearms that count have turned since the figure was taken.
dquat FigureWay::forearmsTurn() const {
  const std::array<dquat, 2> now = forearms();
  std::array<dquat, 2> turned;
  for (std::size_t i = 0; i < 2; ++i) turned[i] = now[i] * glm::conjugate(forearms_at_start_[i]);
  if (!turns_with_[0] || !turns_with_[1]) return turned[turns_with_[0] ? 0 : 1];
  const dquat mean = glm::slerp(turned[0], turned[1], 0.5);
  if (!may_step_) return mean;
  // Who walks faces what both hands are turned to: they must not turn further with the arms of a body that turns.
  const double length = std::hypot(mean.w, mean.z);
  return length > 1e-6 ? mean * glm::conjugate(dquat(mean.w / length, 0.0, 0.0, mean.z / length)) : mean;
}

std::array<dquat, 2> FigureWay::forearms() const {
  using mannequin::Side;
  const auto pose = mannequin::forwardKinematics(
      *figure_, mannequin::toPosture(*figure_, {held_->accepted().X_WE, held_->accepted().joints}));
  const auto turnOf = [&](Side side) {
    return pose[mannequin::armSegment(side, mannequin::Segment::kLeftWrist)].pose().q;
  };
  return {turnOf(Side::kLeft), turnOf(Side::kRight)};
}

std::string FigureWay::nearest() {
  std::vector<FreeMotion::PairDistance> near;
  held_->distances(kLook, near);
  double least = kLook;
  std::string name;
  for (const auto& one : near) {
    if (one.result.distance >= least) continue;
    least = one.result.distance;
    const auto* other = scene_->find(held_->pairs()[one.pair].other);
    name = other ? other->name : std::string();
  }
  return name;
}

}  // namespace hapticell::manipulation
