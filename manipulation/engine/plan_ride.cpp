// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/plan_ride.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hapticell::manipulation {

namespace {

/// m/s of hand, m/s of the cell: how fast the entity is moved along the way or back to it at most. Half: slow hands
/// only; twice: changes of plan are seen as leaps.
constexpr double kRideSpeed = 0.15, kRideSpeedOfCell = 1.0;
/// m/s of hand in contact: 0.03 N/ms on a coupling of 1 N/mm, a third of M1's bound. Half: leaves contacts slowly;
/// twice: with the hand's own motion above the bound (ChangingPlan).
constexpr double kPressedSpeed = 0.03;
/// rad/s that a solid turns, as a wrist that is at ease, and in contact, as a calm one. Half: turning takes longest (5.1
/// s of the extraction exercise); twice: of the first, an eye no longer follows; of the second, surfaces at 0.1 m move by
/// 4 mm between two sets.
constexpr double kRideTurn = 2.0, kPressedTurn = 1.0;
/// rad/s or m/s of a joint: of the 2 to 3 rad/s of robots. Half: arms are led slowly; twice: as fast as they are.
constexpr double kRideJoint = 2.0;
/// rad (or m of a joint), and m of a solid: as far off the way, the way does not go on. Half: waits for rounding; twice:
/// corners are cut by more than a clearance of 5 mm at 0.5 m.
constexpr double kOff = 0.01, kOffSolid = 0.5e-3;
/// Looks for the longest step of the way that the entity can make in time, each halves the error: to 2 %. Half: a
/// quarter of the speed is lost; twice: no change seen.
constexpr int kLooksForStep = 6;
/// Of the authority, as far as rows of the set tell of it: at 1, contacts would be infinitely far. Half of what is left:
/// rows of 1 um are as far as the tube is wide; twice: a gap of 0.02 mm of hand is felt.
constexpr double kMostCarried = 0.999;
/// m of hand: no zone is wider, as SetScheduler's. Half and twice: wider than any workspace here.
constexpr double kCarriedZone = 0.5;
/// s that something keeps it off the way until it strays. Half: a brush counts; twice: it is stuck for half a second.
constexpr double kHeldUp = 0.2;
/// m of way over which its direction is taken; twice as much again where it only turns. Half: rounding; twice: corners
/// are cut.
constexpr double kAlong = 0.002;
/// m of the way of hand that is looked at for the nearest place, and m of the cell at most. Half of either: progress is
/// lost where the hand is fast; twice: ways that come back are taken for the way there.
constexpr double kNearReach = 0.03, kNearestOfCell = 0.05;
/// Looks for it, each in a quarter of the last one's reach: to 0.2 mm. Half: coarse; twice: no change seen.
constexpr int kLooksNearer = 3;

/// The entity's configuration at a place of the way.
EntityConfiguration configurationAt(const HeldEntity& held, const PlannedWay& way,
                                    const trajectory::PathProgress& progress, double place) {
  EntityConfiguration at = held.accepted();
  if (way.postures.empty()) {
    at.X_WE = progress.expertAt(place) * held.movedFrame().inverse() * at.X_WE;
    return at;
  }
  const double index = std::clamp(progress.timeAt(place), 0.0, static_cast<double>(way.postures.size() - 1));
  const auto before = static_cast<std::size_t>(index), after = std::min(before + 1, way.postures.size() - 1);
  return held.manipulator().between(way.postures[before], way.postures[after], index - static_cast<double>(before));
}

double farthestJoint(const EntityConfiguration& from, const EntityConfiguration& to) {
  double most = 0.0;
  for (std::size_t i = 0; i < from.joints.size() && i < to.joints.size(); ++i)
    most = std::max(most, std::abs(to.joints[i] - from.joints[i]));
  return most;
}

/// m/s and rad/s of the moved frame, at most.
struct Pace {
  double speed, turn;
};

/// s that the entity needs to get there.
double timeTo(const HeldEntity& held, const EntityConfiguration& to, const Pace& pace) {
  const EntityConfiguration& from = held.accepted();
  const Twist way = difference(held.manipulator().movedFrame(to), held.movedFrame());
  const double moves = std::max(held.manipulator().leastTime(from, to).seconds, glm::length(way.linear) / pace.speed);
  if (from.joints.empty()) return std::max(moves, glm::length(way.angular) / pace.turn);
  return std::max(moves, farthestJoint(from, to) / kRideJoint);
}

/// Goes on along the way by `farthest` (m), or as far as the entity gets in `dt`; returns where it then is to be.
EntityConfiguration stepInTime(const HeldEntity& held, const PlannedWay& way, trajectory::PathProgress& progress,
                               double farthest, const Pace& pace, double dt) {
  const double from = progress.way();
  double share = 1.0;
  const auto at = [&](double part) { return configurationAt(held, way, progress, from + part * farthest); };
  const auto inTime = [&](double part) { return timeTo(held, at(part), pace) <= dt; };
  if (!inTime(1.0)) {
    double late = 1.0;
    share = 0.0;
    for (int i = 0; i < kLooksForStep; ++i) {
      const double middle = 0.5 * (share + late);
      (inTime(middle) ? share : late) = middle;
    }
    // Near enough to what takes longer than a step: it is gone on to in several.
    if (share == 0.0) share = late;
  }
  progress.setWay(from + share * farthest);
  return at(share);
}

bool isOff(const HeldEntity& held, const EntityConfiguration& wanted) {
  const EntityConfiguration& at = held.accepted();
  if (!at.joints.empty()) return farthestJoint(at, wanted) > kOff;
  const Twist off = difference(wanted.X_WE, at.X_WE);
  return glm::length(off.linear) > kOffSolid || glm::length(off.angular) > kOff;
}

/// m of the way on (or back) to where the hand is, at most `most`; on by a share `agrees` of that wherever the hand is.
double stepTo(const dvec3& p_WH, const trajectory::PathProgress& progress, double most, double agrees) {
  const double here = progress.way(), left = progress.length() - here;
  const dvec3 direction = directionOf(progress, here);
  if (direction == dvec3(0.0)) return std::min(left, most);
  const double along = glm::dot(p_WH - progress.expertAt(here).p, direction);
  if (agrees > 0.0) return std::min(left, std::clamp(along, agrees * most, most));
  // At its end the way has no more place for a hand to be ahead of.
  if (left < 2.0 * most && along > -most) return std::min(left, most);
  return std::clamp(along, -std::min(here, most), std::min(left, most));
}

}  // namespace

dvec3 directionOf(const trajectory::PathProgress& progress, double way) {
  for (double reach = kAlong; reach < progress.length() + kAlong; reach *= 2.0) {
    const dvec3 along = progress.expertAt(std::min(progress.length(), way + reach)).p -
                        progress.expertAt(std::max(0.0, way - reach)).p;
    const double length = glm::length(along);
    if (length > 0.1 * kAlong) return along / length;
  }
  return dvec3(0.0);
}

bool PlanRide::carries(const HeldEntity& held, const PlannedWay& way, const MotionMapping& mapping) {
  if (!mapping.translatesFreely() || !mapping.rotates()) return false;
  const std::size_t joints = held.accepted().joints.size();
  if (joints == 0) return way.postures.empty();
  return way.postures.size() == way.X_WM.size() && way.postures.front().joints.size() == joints;
}

bool PlanRide::strays() const {
  return held_up_s_ > kHeldUp;
}

void PlanRide::step(HeldEntity& held, HandMapping& hand, const Pose& X_DP, const PlannedWay& way,
                    trajectory::PathProgress& progress, const Step& now) {
  const MotionMapping& mapping = hand.mapping();
  const double scale = mapping.scale();
  const Pace pace = now.pressed ? Pace{kPressedSpeed * scale, kPressedTurn}
                                : Pace{std::min(kRideSpeed * scale, kRideSpeedOfCell), kRideTurn};
  const Pose X_WBefore = held.movedFrame(), X_WHand = mapping.toCell(X_DP);
  const bool by_hand = now.authority < 1.0;
  double reach = std::min(kNearReach * scale, kNearestOfCell);
  for (int i = 0; by_hand && i < kLooksNearer; ++i, reach *= 0.25) progress.follow(X_WBefore, reach);
  EntityConfiguration wanted = configurationAt(held, way, progress, progress.way());
  const bool off = isOff(held, wanted);
  if (!off) {
    const double farthest =
        stepTo(mapping.toCell(now.X_DS).p + shift_W_, progress, pace.speed * now.dt, now.agrees);
    wanted = stepInTime(held, way, progress, farthest, pace, now.dt);
  }
  const double needed = timeTo(held, wanted, pace), time = now.authority * now.dt;
  const bool blocked =
      needed > 0.0 &&
      held.goTo(needed <= time ? wanted : held.manipulator().between(held.accepted(), wanted, time / needed)).blocked;
  held_up_s_ = blocked || (off && now.pressed) ? held_up_s_ + now.dt : 0.0;
  // The anchor follows, less what the hand's own motion is to move.
  const Pose X_WM = held.movedFrame();
  const dvec3 way_W = X_WM.p + (1.0 - now.authority) * (X_WHand.p - X_WBefore.p) - X_WHand.p;
  const dvec3 turned = rotationVector(X_WHand.q * glm::conjugate(X_WBefore.q));
  const dquat q_Wanted = quaternionFromRotationVector((1.0 - now.authority) * turned) * X_WM.q;
  shift_W_ -= way_W;
  hand.shift(way_W);
  hand.turn(q_Wanted * glm::conjugate(X_WHand.q), X_DP);
}

void easeContacts(BuiltConstraints& built, const HeldEntity& held, double scale, double authority) {
  const double by_hand = 1.0 - std::clamp(authority, 0.0, kMostCarried);
  if (by_hand >= 1.0) return;
  // Of the distance itself: a way may be nearer than what is felt as contact.
  const auto farther = [by_hand](double gap, double boundary) {
    return gap + boundary > 0.0 ? (gap + boundary) / by_hand - boundary : gap;
  };
  haptic::ConstraintSet& set = built.set;
  built.eased = by_hand;
  for (std::size_t i = 0; i < set.count; ++i) {
    const ConstraintOrigin& origin = built.origins[i];
    // What blocks by its row alone is not checked otherwise.
    const bool is_soft = origin.pair >= 0 && held.motion().isSoft(static_cast<std::uint32_t>(origin.pair));
    haptic::Constraint& row = set.constraints[i];
    // Guides stay; the bound of turning (BuiltConstraints::turn), which has no slope in its middle, does not.
    const bool is_guide = origin.pair < 0 && origin.limit < 0 && row.gradient != haptic::Vector6{};
    if (is_soft || is_guide) continue;
    const double felt_from =
        origin.pair < 0 ? 0.0 : held.pairs()[static_cast<std::size_t>(origin.pair)].feel.boundary / scale;
    row.gap = farther(row.gap, felt_from);
    row.trim_gap = farther(row.trim_gap, 0.0);
    for (double& bend : row.curvature) bend *= by_hand;
  }
  set.zone_radius = std::max(set.zone_radius, std::min(kCarriedZone, set.zone_radius / by_hand));
}

}  // namespace hapticell::manipulation
