// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/felt_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "manipulation/engine/felt_guides.h"

namespace hapticell::manipulation {

namespace {

/// N/m at full authority: 2 N at kPlanLead, twice what a light hand pushes. Half: a hand that pushes straight on is not
/// turned aside; twice: at the bound of pulls (3 N) all the time.
constexpr double kStiffness = 150.0;
/// m of hand: from here on a hand that went away is let go. Half: it is let go inside the tube; twice: held back for 10
/// cm.
constexpr double kReach = 2.0 * (kPlanTube + kPlanLead);
/// m/s of hand of the point that pulls: a calm hand. Half: slow guidance; twice: a change of plan is a pull of 2 N
/// within 50 ms.
constexpr double kLeadSpeed = 0.15;
/// m of hand that the way may stray from the straight line to the point that pulls: less far ahead in bends. Half: weak
/// pulls in gentle bends; twice: corners are cut by 4 mm of hand.
constexpr double kBend = 0.002;
/// rad/s that the entity is turned at full authority, as a calm wrist. Half: turning takes longest; twice: surfaces at
/// 0.1 m move by 4 mm between two sets.
constexpr double kTurnSpeed = 1.0;
/// s to turn what is left, so that it ends gently. Half and twice: half and twice of that.
constexpr double kTurnTime = 0.15;
/// rad of wanted turning that the entity has not followed: something is in the way. Half: a wrist that trembles is not
/// felt; twice: presses on for a tenth of a second longer.
constexpr double kTurnLag = 0.03;
/// s out of the tube that are insisting (the figure), for the share to fall then, and to come back. Half:
/// slips are taken for a will; twice: one has to fight for a second.
constexpr double kInsists = 0.5, kFalls = 0.25, kReturns = 1.0;
/// m of hand between two configurations of the trail. Half: twice as many; twice: narrow bends are cut.
constexpr double kTrailSpacing = 0.003;
/// m a radian, as in trajectory::PathProgress and PlanView; and m of way of hand that is looked at for the nearest place. Half of
/// either: progress is lost where the hand is fast; twice: ways that come back are taken for the way there.
constexpr double kMetresPerRadian = 0.1, kProgressReach = 0.03;
/// m of hand between stylus and proxy: pressed, half of what 0.1 N make of it. Half: tremor in a slot; twice: thin
/// contacts are left too fast.
constexpr double kPressed = 5e-5;

/// Share of the pull from which on an entity that the hand presses against something is carried: what the hand presses
/// against gives way then, and the pull is to hold the hand. Half: the hand leaps away from the way; twice: waits for a
/// second at each contact.
constexpr double kTakes = 0.5;

double shareOf(const FeltPlan::State& state) {
  return state.authority * state.share;
}

trajectory::Trajectory motionOf(const std::vector<Pose>& X_WM) {
  trajectory::Trajectory motion;
  for (std::size_t i = 0; i < X_WM.size(); ++i) motion.addFrame({.t = static_cast<double>(i), .X_WT = X_WM[i]});
  return motion;
}

}  // namespace

std::array<haptic::Constraint, 3> planPull(const Pose& X_WM, const dvec3& p_WT, double authority,
                                           const MotionMapping& mapping) {
  std::array<haptic::Constraint, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    dvec3 direction(0.0);
    direction[static_cast<int>(i)] = 1.0;
    haptic::Constraint& row = rows[i];
    row.kind = haptic::ConstraintKind::kPull;
    row.gap = glm::dot(direction, X_WM.p - p_WT);
    row.gradient = {direction.x, direction.y, direction.z, 0.0, 0.0, 0.0};
    mapping.toDevice(row);
    row.stiffness = kStiffness * authority;
    row.reach = kReach;
  }
  return rows;
}

void FeltPlan::set(std::shared_ptr<PlanSource> source, double authority) {
  if (source != source_) {
    forget();
    state_.ways = state_.insistences = 0;
    const std::uint64_t hold = view_.hold;
    view_ = {};
    view_.hold = hold;
  }
  source_ = std::move(source);
  state_.authority = std::isfinite(authority) ? std::clamp(authority, 0.0, 1.0) : 0.0;
}

void FeltPlan::forget() {
  ++view_.hold;
  trail_.clear();
  state_.way.reset();
  state_.share = 0.0;
  state_.insists = state_.reached = false;
  progress_ = {};
  leads_ = false;
  outside_s_ = 0.0;
  ride_.restart();
  rides_ = false;
  carried_ = 0.0;
}

void FeltPlan::look(const HeldEntity& held, const CellState& cell, double scale) {
  const Pose X_WM = held.movedFrame();
  const EntityConfiguration standing = held.standing();
  trail_.add(standing, X_WM, kTrailSpacing * scale);
  view_.time_ns = cell.clock().now();
  view_.scene = cell.scene();
  view_.placements = cell.placements();
  view_.entity = held.id();
  view_.hand = held.hand();
  view_.standing = standing;
  view_.X_WM = X_WM;
  view_.trail = trail_.trail();
  view_.insistences = state_.insistences;
  view_.way_number = state_.way ? state_.way->number : 0;
  view_.strayed = rides_ && ride_.strays();
  view_.way_left = state_.way ? progress_.length() - progress_.way() : 0.0;
  source_->look(view_);
  state_.reached = source_->isReached(view_);
}

/// A new way: the share comes back when it is the answer to the hand.
void FeltPlan::adopt(const Pose& X_WM) {
  const std::shared_ptr<const PlannedWay> newest = source_->newest();
  if (newest == state_.way) return;
  state_.way = newest;
  if (!newest || newest->X_WM.size() < 2 || newest->hold != view_.hold) {
    state_.way.reset();
    return;
  }
  ++state_.ways;
  ride_.restart();
  progress_ = trajectory::PathProgress(motionOf(newest->X_WM), kMetresPerRadian);
  // The hand has gone on while the way was worked out.
  progress_.follow(X_WM, progress_.length());
  if (newest->answers < state_.insistences) return;
  state_.insists = false;
  outside_s_ = 0.0;
}

/// Whether the hand insists, and what share that leaves.
void FeltPlan::watchHand(const dvec3& p_WH, double scale, double dt) {
  // Where the entity waits, the hand may be ahead of it.
  const dvec3 near = progress_.expertAt(progress_.way()).p, off = p_WH - near;
  const dvec3 along = directionOf(progress_, progress_.way());
  const double most = rides_ ? (kPlanLead + kPlanTube) * scale : 0.0;
  double away = glm::length(off - std::clamp(glm::dot(off, along), -most, most) * along) / scale;
  // In a bend the point that pulls is beside the way's direction.
  if (leads_) away = std::min(away, glm::distance(p_WH, p_WT_) / scale);
  outside_s_ = away > kPlanTube ? outside_s_ + dt : 0.0;
  if (outside_s_ >= kInsists && !state_.insists) {
    state_.insists = true;
    ++state_.insistences;
    view_.push_W = off;
    ride_.restart();
  }
  const double change = state_.insists ? -dt / kFalls : dt / kReturns;
  state_.share = std::clamp(state_.share + change, 0.0, 1.0);
}

/// m of way ahead, as far as it is nearly straight.
double FeltPlan::aheadOn(double scale) const {
  const double here = progress_.way(), left = std::max(0.0, progress_.length() - here);
  double ahead = std::min(kPlanLead * scale, left);
  for (int halvings = 0; halvings < 3; ++halvings, ahead *= 0.5) {
    const dvec3 from = progress_.expertAt(here).p, to = progress_.expertAt(here + ahead).p;
    double off = 0.0;
    for (int k = 1; k < 8; ++k) {
      const dvec3 p = progress_.expertAt(here + ahead * k / 8.0).p - from;
      const double s = glm::dot(p, to - from) / std::max(glm::dot(to - from, to - from), 1e-18);
      off = std::max(off, glm::length(p - std::clamp(s, 0.0, 1.0) * (to - from)));
    }
    if (off <= kBend * scale) break;
  }
  return ahead;
}

/// The point that is to pull: from the way's nearest point along it, less far where the way turns more than it moves.
dvec3 FeltPlan::wantedPoint(double scale) const {
  const double ahead = aheadOn(scale), here = progress_.way(), most = kPlanLead * scale;
  const dvec3 near = progress_.expertAt(here).p;
  const dvec3 to = progress_.expertAt(std::min(progress_.length(), here + ahead)).p - near;
  const double length = glm::length(to);
  // At the end of the way the pull is into it; before, a bend near by is no reason to pull less.
  const bool ends = progress_.length() - here <= most;
  if (ends || length < 1e-9) return near + to;
  const double share = std::min(1.0, length / std::max(ahead, 1e-9));
  return near + to * (share * most / length);
}

/// Turns the entity under the hand, as far as it has followed so far.
void FeltPlan::turn(const HeldEntity& held, HandMapping& hand, const Pose& X_DP, double dt) const {
  const MotionMapping& mapping = hand.mapping();
  const double most = shareOf(state_) * kTurnSpeed * dt;
  if (!mapping.rotates() || most <= 0.0) return;
  const Pose X_WM = held.movedFrame();
  const dquat wanted = mapping.toCell(X_DP).q * glm::conjugate(X_WM.q);
  // What the entity did not follow is taken back: it must not add up while something is in the way.
  const bool lags = glm::length(rotationVector(wanted)) > kTurnLag;
  const Pose ahead = progress_.expertAt(std::min(progress_.length(), progress_.way() + kPlanLead * mapping.scale()));
  const dvec3 left = rotationVector(ahead.q * glm::conjugate(X_WM.q));
  const dquat turned = quaternionFromRotationVector(shortenedTo(left * std::min(1.0, dt / kTurnTime), most));
  hand.turn(lags ? turned * glm::conjugate(wanted) : turned, X_DP);
}

bool FeltPlan::step(HeldEntity& held, HandMapping& hand, const Pose& X_DS, const Pose& X_DP, const CellState& cell) {
  if (!source_) return false;
  const MotionMapping& mapping = hand.mapping();
  const double scale = mapping.scale(), dt = std::min(cell.clock().stepTime(), 0.1);
  look(held, cell, scale);
  adopt(held.movedFrame());
  const bool was_carried = std::exchange(carried_, 0.0) > 0.0;
  if (!state_.way || state_.reached) {
    const bool led = std::exchange(leads_, false);
    state_.share = 0.0;
    ride_.restart();
    return led;
  }
  rides_ = PlanRide::carries(held, *state_.way, mapping);
  if (!rides_) progress_.follow(held.movedFrame(), kProgressReach * scale);
  watchHand(rides_ ? ride_.handAt(mapping, X_DP) : held.movedFrame().p, scale, dt);
  if (!leads_) p_WT_ = held.movedFrame().p;
  leads_ = true;
  const dvec3 p_WWanted = wantedPoint(scale);
  p_WT_ += shortenedTo(p_WWanted - p_WT_, kLeadSpeed * scale * dt);
  if (!rides_) {
    turn(held, hand, X_DP, dt);
  } else if (!state_.insists && state_.authority > 0.0) {
    const bool pressed = glm::distance(X_DS.p, X_DP.p) > kPressed;
    if (pressed && !was_carried && state_.share < kTakes) {
      progress_.follow(held.movedFrame(), kProgressReach * scale);
      return true;
    }
    carried_ = state_.authority;
    // A hand that holds against less than the full pull gives way to it.
    const double holds = glm::distance(ride_.handAt(mapping, X_DP), p_WWanted) / (kPlanLead * scale);
    const double agrees = std::clamp(2.0 * (1.0 - holds), 0.0, 1.0);
    ride_.step(held, hand, X_DP, *state_.way, progress_, {carried_, dt, pressed, X_DS, agrees});
  }
  return true;
}

void FeltPlan::addTo(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping) const {
  if (!leads_ || shareOf(state_) <= 0.0) return;
  easeContacts(built, held, mapping.scale(), carried_);
  makeRoom(built, 3);
  haptic::ConstraintSet& set = built.set;
  std::uint32_t group = set.count == 0 ? 0 : set.constraints[set.count - 1].group + 1;
  Pose X_WH = held.movedFrame();
  X_WH.p += ride_.shift_W();
  for (haptic::Constraint& row : planPull(X_WH, p_WT_, shareOf(state_), mapping)) {
    if (set.count >= haptic::kMaxConstraints) return;
    row.group = group++;
    set.constraints[set.count++] = row;
    built.origins.push_back({});
  }
}

}  // namespace hapticell::manipulation
