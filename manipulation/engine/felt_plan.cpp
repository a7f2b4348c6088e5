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
/// s to turn what is left, so that it ends gently; and of a robot that is kept on its way. Half and twice: half and twice
/// of that, and of what it stays behind.
constexpr double kTurnTime = 0.15, kKeptTurnTime = 0.04;
/// m of way that a kept robot's turning is ahead, kPlanLead of others: a turn at rest is made at kTurnSpeed. Half: at half of it; twice: turned before
/// it is there, by 0.08 rad.
constexpr double kTurnLead = 0.004;
/// rad of wanted turning that the entity has not followed: something is in the way. Half: a wrist that trembles is not
/// felt; twice: presses on for a tenth of a second longer.
constexpr double kTurnLag = 0.03;
/// rad, m: turning by so much makes a new set. Half: twice the sets; twice: contacts are 0.3 mm off at 0.1 m.
constexpr double kTurnSeen = 1e-3;
/// s out of the tube that are insisting (the figure), for the share to fall then, and to come back. Half:
/// slips are taken for a will; twice: one has to fight for a second.
constexpr double kInsists = 0.5, kFalls = 0.25, kReturns = 1.0;
/// m of hand between two configurations of the trail. Half: twice as many; twice: narrow bends are cut.
constexpr double kTrailSpacing = 0.003;
/// m a radian, as in trajectory::PathProgress and PlanView; and m of way of hand that is looked at for the nearest place. Half of
/// either: progress is lost where the hand is fast; twice: ways that come back are taken for the way there.
constexpr double kMetresPerRadian = 0.1, kProgressReach = 0.03;
/// m of the cell, of the same at large scales, as kProgressReach.
constexpr double kFarthestReach = 0.05;
/// Looks for the nearest place, each in a quarter of the last one's reach: to 0.2 mm. Half: turning stops before its
/// end; twice: no change seen.
constexpr int kRefinements = 3;
/// Of the way's clearance, how far beside it the entity may be while the hand is in the tube. Half: stiffer than what
/// positions are good for; twice: at 5 mm not within the 2 mm of a goal.
constexpr double kRoom = 0.25;
/// m/s of hand at which the entity is put back onto the way; not in contact, where the force on a table then changed by
/// 0.18 N/ms. Half: it leaves the way when the hand is fast; twice: changes of plan are seen as leaps.
constexpr double kShiftSpeed = 0.15;
/// m: what is nearer is in contact, five times the least boundary of a pair. Half: contacts that tremble come and go;
/// twice: not led where the clearance is 0.2 mm.
constexpr double kPressed = 1e-4;
/// m of hand, besides the step itself: it is not put nearer to what is so near. Half: a proxy that trembles feels it;
/// twice: kept off the way beside walls at large scales.
constexpr double kTouches = 1e-4;
/// m/s of the cell at most along the way, in steps. Half: robots are led slowly; twice: corners are cut by 8 mm at 250
/// Hz.
constexpr double kWaySpeed = 1.0;
/// rad or m that a joint may be away from the plan's, and rad of turning that may be missing, before the entity waits
/// there. Half: it waits for what a tool's own tremor does; twice: elbows pass 5 cm beside their way.
constexpr double kJointLag = 0.05;
/// m of way over which its direction is taken; twice as much again where it only turns. Half: rounding; twice: corners
/// are cut.
constexpr double kDirection = 0.002;

double shareOf(const FeltPlan::State& state) {
  return state.authority * state.share;
}

/// A robot's other links do not slide along what its tool's way passes: it is kept on its way.
bool isKept(const FeltPlan::State& state) {
  return state.way && !state.way->joints.empty();
}

/// Whether one of the near pairs is a contact with something else.
bool isPressed(const HeldEntity& held, const std::vector<FreeMotion::PairDistance>& near) {
  return std::any_of(near.begin(), near.end(), [&held](const FreeMotion::PairDistance& one) {
    const MotionPair& pair = held.motion().pairs()[one.pair];
    return pair.blocks && pair.other_part < 0 && one.result.distance < kPressed;
  });
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
    view_ = {};
  }
  source_ = std::move(source);
  state_.authority = std::isfinite(authority) ? std::clamp(authority, 0.0, 1.0) : 0.0;
}

void FeltPlan::forget() {
  trail_.clear();
  state_.way.reset();
  state_.share = 0.0;
  state_.insists = state_.reached = false;
  progress_ = {};
  leads_ = false;
  outside_s_ = 0.0;
  shift_W_ = dvec3(0.0);
}

void FeltPlan::look(const HeldEntity& held, const CellState& cell, double scale) {
  const Pose X_WM = held.movedFrame();
  const EntityConfiguration standing = held.standing();
  trail_.add(standing, X_WM, kTrailSpacing * scale);
  view_.time_ns = cell.clock().now();
  view_.scene = cell.scene();
  view_.placements = cell.placements();
  view_.entity = held.id();
  view_.standing = standing;
  view_.X_WM = X_WM;
  view_.trail = trail_.trail();
  view_.insistences = state_.insistences;
  view_.way_number = state_.way ? state_.way->number : 0;
  view_.way_left = state_.way ? progress_.length() - progress_.way() : 0.0;
  source_->look(view_);
  state_.reached = source_->isReached(view_);
}

/// A new way: the share comes back when it is the answer to the hand.
void FeltPlan::adopt(const Pose& X_WM) {
  const std::shared_ptr<const PlannedWay> newest = source_->newest();
  if (newest == state_.way) return;
  state_.way = newest;
  if (!newest || newest->X_WM.size() < 2) {
    state_.way.reset();
    return;
  }
  ++state_.ways;
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
  const dvec3 along = directionAt(progress_.way());
  const double most = isKept(state_) ? (kPlanLead + kPlanTube) * scale : 0.0;
  const double away = glm::length(off - std::clamp(glm::dot(off, along), -most, most) * along) / scale;
  outside_s_ = away > kPlanTube ? outside_s_ + dt : 0.0;
  if (outside_s_ >= kInsists && !state_.insists) {
    state_.insists = true;
    ++state_.insistences;
    view_.push_W = off;
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
bool FeltPlan::turn(const HeldEntity& held, HandMapping& hand, const Pose& X_DP, double dt) const {
  const MotionMapping& mapping = hand.mapping();
  if (!mapping.rotates()) return false;
  const Pose X_WM = held.movedFrame();
  const dquat wanted = mapping.toCell(X_DP).q * glm::conjugate(X_WM.q);
  // What the entity did not follow is taken back: it must not add up while something is in the way.
  const bool lags = glm::length(rotationVector(wanted)) > kTurnLag;
  const bool exact = isKept(state_) && !isPressed(held, near_);
  const double far = kPlanLead * mapping.scale(), lead = exact ? std::min(kTurnLead, far) : far;
  const Pose ahead = progress_.expertAt(std::min(progress_.length(), progress_.way() + lead));
  const dvec3 left = rotationVector(ahead.q * glm::conjugate(X_WM.q));
  const double most = shareOf(state_) * kTurnSpeed * dt;
  const dvec3 step = shortenedTo(left * std::min(1.0, dt / (exact ? kKeptTurnTime : kTurnTime)), most);
  if (most <= 0.0) return false;
  const dquat turned = quaternionFromRotationVector(step);
  hand.turn(lags ? turned * glm::conjugate(wanted) : turned, X_DP);
  return glm::length(left) > kTurnSeen;
}

/// Unit; zero where the whole way only turns.
dvec3 FeltPlan::directionAt(double way) const {
  for (double reach = kDirection; reach < progress_.length() + kDirection; reach *= 2.0) {
    const dvec3 along = progress_.expertAt(std::min(progress_.length(), way + reach)).p -
                        progress_.expertAt(std::max(0.0, way - reach)).p;
    const double length = glm::length(along);
    if (length > 0.1 * kDirection) return along / length;
  }
  return dvec3(0.0);
}

/// Where the entity is to be while the hand would have it at p_WH, going on by at most `step`.
dvec3 FeltPlan::keptOnWay(const dvec3& p_WH, bool waits, double step) const {
  const double room = kRoom * state_.way->clearance, here = progress_.way();
  const bool ends = progress_.length() - here < 2.0 * step;
  const dvec3 near = progress_.expertAt(ends && !waits ? progress_.length() : here).p, off = p_WH - near;
  if (ends && !waits) return near + shortenedTo(off, room);
  const dvec3 direction = directionAt(here);
  const double along = glm::dot(off, direction);
  return near + std::clamp(along, -step, waits ? 0.0 : step) * direction + shortenedTo(off - along * direction, room);
}

/// Moves a robot's arm towards the plan's joints here. True: it is not near them yet.
bool FeltPlan::lean(HeldEntity& held, double dt) const {
  const std::vector<std::vector<double>>& joints = state_.way->joints;
  if (joints.size() != state_.way->X_WM.size() || joints.empty()) return false;
  const double at = std::clamp(progress_.timeAt(progress_.way()), 0.0, static_cast<double>(joints.size() - 1));
  const auto before = static_cast<std::size_t>(at), after = std::min(before + 1, joints.size() - 1);
  std::vector<double> wanted = joints[before];
  for (std::size_t i = 0; i < wanted.size() && i < joints[after].size(); ++i)
    wanted[i] += (at - static_cast<double>(before)) * (joints[after][i] - wanted[i]);
  held.leanTo(wanted, shareOf(state_) * kTurnSpeed * dt);
  const std::vector<double>& stands = held.accepted().joints;
  double most = 0.0;
  for (std::size_t i = 0; i < wanted.size() && wanted.size() == stands.size(); ++i)
    most = std::max(most, std::abs(wanted[i] - stands[i]));
  return most > kJointLag;
}

/// Moves the hand's anchor so that the entity stays on the way while the hand wanders in the tube.
void FeltPlan::keepOnWay(bool waits, HeldEntity& held, HandMapping& hand, const Pose& X_DP, double dt) {
  const MotionMapping& mapping = hand.mapping();
  if (!mapping.translatesFreely() || isPressed(held, near_)) return;
  const double scale = mapping.scale(), room = kRoom * state_.way->clearance;
  const dvec3 p_WH = mapping.toCell(X_DP).p + shift_W_;
  const double step = std::max(2.0 * room, std::min(kLeadSpeed * scale, kWaySpeed) * dt);
  const dvec3 wanted = shareOf(state_) * (p_WH - keptOnWay(p_WH, waits, step));
  const dvec3 way = gentle(shift_W_ - wanted, held, scale, dt);
  shift_W_ -= way;
  hand.shift(way);
}

/// What may be made of a way (m, world) of the entity in one step: into nothing.
dvec3 FeltPlan::gentle(const dvec3& way_W, HeldEntity& held, double scale, double dt) {
  dvec3 way = shortenedTo(way_W, kShiftSpeed * scale * dt);
  if (glm::length(way) < 1e-9) return dvec3(0.0);
  held.distances(kTouches * scale + glm::length(way), near_);
  for (const FreeMotion::PairDistance& near : near_) {
    const MotionPair& pair = held.motion().pairs()[near.pair];
    if (!pair.blocks || pair.other_part >= 0) continue;
    const double into = -glm::dot(way, near.result.nhat_BA_W);
    if (into > 0.0) way += into * near.result.nhat_BA_W;
  }
  return way;
}

bool FeltPlan::step(HeldEntity& held, HandMapping& hand, const Pose& X_DP, const CellState& cell) {
  if (!source_) return false;
  const double scale = hand.mapping().scale(), dt = std::min(cell.clock().stepTime(), 0.1);
  const Pose X_WM = held.movedFrame();
  look(held, cell, scale);
  adopt(X_WM);
  if (!state_.way || state_.reached) {
    const bool led = std::exchange(leads_, false);
    state_.share = 0.0;
    shift_W_ = dvec3(0.0);
    return led;
  }
  const bool kept = isKept(state_);
  double reach = kept ? std::min(kProgressReach * scale, kFarthestReach) : kProgressReach * scale;
  for (int i = 0; i < (kept ? kRefinements : 1); ++i, reach *= 0.25) progress_.follow(X_WM, reach);
  watchHand(kept ? hand.mapping().toCell(X_DP).p + shift_W_ : X_WM.p, scale, dt);
  if (!leads_) p_WT_ = X_WM.p;
  leads_ = true;
  p_WT_ += shortenedTo(wantedPoint(scale) - p_WT_, kLeadSpeed * scale * dt);
  if (kept) held.distances(kPressed, near_);
  turn(held, hand, X_DP, dt);
  if (!kept) return true;
  const dquat missing = progress_.expertAt(progress_.way()).q * glm::conjugate(X_WM.q);
  const bool turns = hand.mapping().rotates() && glm::length(rotationVector(missing)) > kJointLag;
  const bool leans = lean(held, dt);
  keepOnWay(turns || leans, held, hand, X_DP, dt);
  return true;
}

void FeltPlan::addTo(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping) const {
  if (!leads_ || shareOf(state_) <= 0.0) return;
  makeRoom(built, 3);
  haptic::ConstraintSet& set = built.set;
  std::uint32_t group = set.count == 0 ? 0 : set.constraints[set.count - 1].group + 1;
  Pose X_WH = held.movedFrame();
  X_WH.p += shift_W_;
  for (haptic::Constraint& row : planPull(X_WH, p_WT_, shareOf(state_), mapping)) {
    if (set.count >= haptic::kMaxConstraints) return;
    row.group = group++;
    set.constraints[set.count++] = row;
    built.origins.push_back({});
  }
}

}  // namespace hapticell::manipulation
