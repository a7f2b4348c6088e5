// SPDX-License-Identifier: Apache-2.0
// A mannequin's hand with free feet: when it steps, and what its legs bear meanwhile.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "manipulation/manipulators/mannequin_manipulator.h"
#include "manipulation/manipulators/mannequin_steps.h"

namespace hapticell::manipulation {

namespace {

using mannequin::Posture;
using mannequin::Side;

/// m a proposal that a foot goes: at 100 Hz 1 m/s. Half: it walks slowly at low rates; twice: legs turn more than the
/// solver's 1.8 deg a tick.
constexpr double kMostStep = 0.01;
/// m/s of a foot in the air, a brisk walk's body (feet go faster). Our choice. Half: dragging; twice: hurried, and
/// nothing follows so fast.
constexpr double kWalkingSpeed = 1.5;
/// m and rad ahead of the hand that it is led at once, what a few ticks of the solver turn. Half: slower; twice: arms
/// leave the straight way.
constexpr double kLed = 0.03, kLedTurn = 0.15;
/// rad (35 deg) that the pelvis heads beside the feet before they follow it. Our choice. Half: feet tread at each turn
/// of the trunk; twice: over the hips' range.
constexpr double kTwist = 0.61;
/// rad (25 deg) that the feet head beside the pelvis by turning. Our choice: less than kTwist, so that they do not turn
/// back. Half: turns of more steps; twice: hips lock.
constexpr double kMostTwist = 0.44;
/// rad, share and rad of one proposal by which a twisted pelvis comes round. Our choice. Half: hips stay turned for
/// longer; twice: the body sways with each step.
constexpr double kLeastTwist = 0.12, kUntwisted = 0.3, kMostUntwisted = 0.03;
/// rad, m: a pelvis farther turned or off its feet stops, as legs lock. Our choice. Half: stands up to walk more often;
/// twice: legs do not reach their steps.
constexpr double kWalkingTwist = 0.25, kWalkingLean = 0.15;
/// Of the leg, and cosine of the pelvis's tilt (32 deg), for the same. 0.97 is preferred. Half of what is missing:
/// walks only upright; twice: walks crouched, with legs at their limits.
constexpr double kWalkingHeight = 0.80, kWalkingUpright = 0.85;
/// rad (35, 60 deg) from ahead within which a hand works, across and to its own side (Mannequin, Steps; our choice).
/// Half: it turns for little; twice: it works behind its back.
constexpr double kAcross = 0.61, kOutward = 1.05;
/// m of one proposal: a pelvis that rises by less is upright. Half: more steps until it walks; twice: it walks off
/// while it still rises.
constexpr double kUnwound = 2e-3;
/// Of the arm, level from over the feet: farther is walked, as people step before they lean as far as they can
/// (Mannequin, Steps; our choice). Half: walks for all; at 1: leans first.
constexpr double kComfortableReach = 0.80;
/// rad (37 deg) of the hand from how it was taken, seen from the body (Mannequin, Steps; our choice). Half: the feet
/// turn with each turn of the hand; twice: the wrist is at its limit first.
constexpr double kHandTurn = 0.65;
/// m ahead of the ankles, where a hand begins to work before the body and beside it (Mannequin, Steps; our choice).
/// Half: hands against the belly; twice: it steps back from near work.
constexpr double kBeforeBelly = 0.20, kBehindSide = -0.10;
/// Of the arm; m ahead of and aside from between the feet for both hands (Mannequin; our choice). Half: it steps for
/// little; twice: beyond the arms.
constexpr double kBothReach = 0.80, kBothAhead = 0.30, kBothAside = 0.20;
/// rad (20 deg) for both hands, which turn with the trunk; m that one hand goes to the other side (Mannequin, Steps;
/// our choice). Half: it treads more; twice: the trunk is wrung.
constexpr double kBothTurn = 0.35, kFarAcross = 0.22;
/// m to its side within which the belly is in the way, and from where it is not. Our choice. Half or twice: hands that
/// step back too late or too early.
constexpr double kBellySide = 0.10, kBesideBody = 0.25;
/// Of the stature, the height of the shoulders: above it a hand is before no belly. Half: hands through the chest; at
/// 1: it steps back from what is before its face.
constexpr double kBellyUpTo = 0.80;
/// m from over the feet where no direction is meant. Half: feet turn about a hand at the belly; twice: they do not face
/// near work.
constexpr double kNear = 0.25;
/// Passes that put a place onto one bound and the other; both are convex, so it closes in. Half: off by some mm; twice:
/// no difference that a foot makes.
constexpr int kComfortPasses = 8;

/// On the way from one pose to another, no farther than a hand is led at once.
Pose ahead(const Pose& from, const Pose& to) {
  const Twist way = difference(to, from);
  const double share = std::max(glm::length(way.linear) / kLed, glm::length(way.angular) / kLedTurn);
  if (share <= 1.0) return to;
  return {from.p + way.linear / share, glm::normalize(quaternionFromRotationVector(way.angular / share) * from.q)};
}

/// rad to the left of the cell's x in which the feet head.
double aheadOf(const std::array<Pose, 2>& feet) {
  const dvec3 ahead = feet[0].rotate({1.0, 0.0, 0.0}) + feet[1].rotate({1.0, 0.0, 0.0});
  return std::atan2(ahead.y, ahead.x);
}

/// rad of a turn that are about the vertical, -pi to pi.
double aboutVertical(const dquat& turn) {
  return std::remainder(2.0 * std::atan2(turn.z, turn.w), 2.0 * std::numbers::pi);
}

/// What an angle is beyond a range.
double beyond(double angle, double lower, double upper) {
  return angle - std::clamp(angle, lower, upper);
}

}  // namespace

dvec3 MannequinManipulator::wantedHand(const Pose& X_WM) const {
  const mannequin::PostureTask task = taskFor(X_WM, X_WF_);
  const std::size_t i = static_cast<std::size_t>(driven());
  return task.held ? (task.held->X_WO * task.held->X_OH[i]).p : task.hands[i]->p;
}

/// A place near `seen`, level, where an arm likes to work: not farther than it likes to reach from its shoulder (people
/// step before they lean as far as they can), not behind the own belly and not far to the other side. It is put onto
/// the one bound and the other in turns, since both are convex and have room in common.
dvec3 MannequinManipulator::comfortableNear(const dvec3& seen) const {
  const double left = driven() == Side::kLeft ? 1.0 : -1.0;
  const dvec3 shoulder(0.0, isBoth() ? 0.0 : 0.5 * left * figure().body[mannequin::Dimension::kBiacromialBreadth], 0.0);
  const double reach =
      (isBoth() ? kBothReach : kComfortableReach) * (figure().upperArmLength() + figure().forearmLength());
  const bool low = seen.z <= kBellyUpTo * figure().body[mannequin::Dimension::kStature];
  const double beside =
      isBoth() ? 0.0 : std::clamp((left * seen.y - kBellySide) / (kBesideBody - kBellySide), 0.0, 1.0);
  const double least = isBoth() ? kBothAhead : std::lerp(kBeforeBelly, kBehindSide, beside);
  dvec3 place(seen.x, seen.y, 0.0);
  for (int i = 0; i < kComfortPasses; ++i) {
    if (low) {
      place.x = std::max(place.x, least);
      place.y = isBoth() ? std::clamp(place.y, -kBothAside, kBothAside) : left * std::max(left * place.y, -kFarAcross);
    }
    const dvec3 away = place - shoulder;
    const double distance = glm::length(away);
    if (distance > reach) place = shoulder + (reach / distance) * away;
  }
  return place;
}

/// How the feet should be moved, level, for the hand to be where an arm likes to work.
dvec3 MannequinManipulator::beyondComfort(const Pose& X_WM, const Feet& X_WF) const {
  const dquat heading = turnedLeft(aheadOf(X_WF) + turnToFace(X_WM, X_WF));
  const dvec3 middle = 0.5 * (X_WF[0].p + X_WF[1].p);
  const dvec3 seen = glm::conjugate(heading) * ((isBoth() ? X_WM.p : wantedHand(X_WM)) - middle);
  const dvec3 place = comfortableNear(seen);
  return heading * dvec3(seen.x - place.x, seen.y - place.y, 0.0);
}

/// How far round the feet should head: after a pelvis that has turned over them; and with the pelvis to face what the
/// hand works at, and where both hands are turned, to go along; never far ahead of the pelvis, or the hips would lock.
double MannequinManipulator::wishedTurn(const Pose& X_WM, const Posture& posture, const Feet& X_WF) const {
  const double twist = headingBeside(posture.X_WR, X_WF);
  const double turn = std::abs(twist) > kTwist ? mindingTheHand(twist, X_WM, X_WF) : turnToFace(X_WM, X_WF);
  return std::clamp(turn, twist - kMostTwist, twist + kMostTwist);
}

/// A turn of the feet as far as the hand, which turns with the body, is then not turned farther from how it is wanted
/// than a wrist and a shoulder make good.
double MannequinManipulator::mindingTheHand(double turn, const Pose& X_WM, const Feet& X_WF) const {
  const double turned = aboutVertical(X_WM.q * glm::conjugate(q_WM_));
  const double off = std::remainder(turned - turnedFeet(X_WF_, X_WF), 2.0 * std::numbers::pi);
  const double most = isBoth() ? kBothTurn : kHandTurn;
  return std::clamp(turn, off - most, off + most);
}

/// What the hand works at is to be ahead.
double MannequinManipulator::turnToFace(const Pose& X_WM, const Feet& X_WF) const {
  const dvec3 away = (isBoth() ? X_WM.p : wantedHand(X_WM)) - 0.5 * (X_WF[0].p + X_WF[1].p);
  const double beside = std::remainder(std::atan2(away.y, away.x) - aheadOf(X_WF), 2.0 * std::numbers::pi);
  const bool outward_left = !isBoth() && driven() == Side::kLeft, outward_right = !isBoth() && !outward_left;
  double facing = 0.0;
  if (std::hypot(away.x, away.y) >= kNear)
    facing = beyond(beside, outward_right ? -kOutward : -kAcross, outward_left ? kOutward : kAcross);
  return mindingTheHand(facing, X_WM, X_WF);
}

/// The posture that follows its feet from `feet` to `stepped`, and the hand from there; nothing where its legs do not
/// let it.
std::optional<Posture> MannequinManipulator::goTo(Feet stepped, const Feet& feet, const Posture& posture,
                                                  const Pose* X_WM) const {
  // A pelvis that is ahead of the feet waits for them.
  const double turned = std::remainder(turnedFeet(X_WF_, stepped) - turnedFeet(X_WF_, feet), 2.0 * std::numbers::pi);
  const double pelvis_turn = turned * headingBeside(posture.X_WR, feet) > 0.0 ? 0.0 : turned;
  const std::optional<Posture> gone = goneWith(figure(), posture, feet, stepped, pelvis_turn);
  if (!gone) return std::nullopt;
  if (X_WM) {
    const Posture there = followStanding(*X_WM, stepped, *gone);
    if (walksWell(there, stepped)) return there;
  }
  return unwound(*gone, stepped);
}

/// Whether legs have room to walk: the pelvis upright, high enough, over the feet and heading as they do.
bool MannequinManipulator::walksWell(const Posture& posture, const Feet& feet) const {
  const double leg = figure().thighLength() + figure().shankLength();
  const dvec3 middle = 0.5 * (feet[0].p + feet[1].p);
  const dvec3 off = posture.X_WR.p - middle;
  const double leans = posture.X_WR.rotate({0.0, 0.0, 1.0}).z;
  return std::abs(headingBeside(posture.X_WR, feet)) < kWalkingTwist && off.z > kWalkingHeight * leg &&
         std::hypot(off.x, off.y) < kWalkingLean && leans > kWalkingUpright;
}

/// What the whole body does for the hand, as far as no foot glides by it.
Posture MannequinManipulator::followStanding(const Pose& X_WM, const Feet& feet, const Posture& posture) const {
  return stoodOn(figure(), posture, follow(taskFor(X_WM, feet), posture, nullptr), feet);
}

/// A body that is wrung so far that no leg can be moved lets go of the hand, a little at a time.
Posture MannequinManipulator::unwound(const Posture& start, const Feet& feet) const {
  mannequin::PostureTask task;
  const Feet as_they_are = feetOf(start);
  for (std::size_t i = 0; i < 2; ++i) task.feet[i] = as_they_are[i];
  Posture loose = start;
  for (const bool balanced : {true, false}) {
    task.balance = balanced;
    loose = stoodOn(figure(), start, solver_.relax(task, start).posture, feet);
    if (glm::length(loose.X_WR.p - start.X_WR.p) > kUnwound) break;
  }
  return loose;
}

/// The pelvis a little nearer to where the feet head: on hips that are turned as far as they go no leg can be moved.
Posture MannequinManipulator::untwisted(const Posture& posture, const Feet& feet) const {
  const double twist = headingBeside(posture.X_WR, feet);
  if (std::abs(twist) < kLeastTwist) return posture;
  Feet stays = feet;
  return goneWith(figure(), posture, feet, stays, -std::clamp(kUntwisted * twist, -kMostUntwisted, kMostUntwisted))
      .value_or(posture);
}

EntityConfiguration MannequinManipulator::proposeStepping(const Posture& from, const Pose& X_WM,
                                                          double duration_s) const {
  const Feet feet = standingFeet(X_WF_, levelled(X_WF_, feetOf(from), figure().sole.ball_x));
  const Posture start = untwisted(from, feet);
  const double most = std::min(kMostStep, kWalkingSpeed * duration_s);
  StepWish wish;
  wish.missing_W = beyondComfort(X_WM, feet);
  wish.turn = wishedTurn(X_WM, start, feet);
  const bool steps = footToLift(X_WF_, feet, wish).has_value();
  // What is far away or behind the body is gone to: a hand that pulled at it would wring the body. It waits where it
  // works well until the feet have come.
  Pose meant = X_WM;
  if (steps) meant.p -= wish.missing_W;
  const Pose near = ahead(movedFrame(configurationOf(start)), meant);
  const Posture posture = followStanding(near, feet, start);
  if (!steps) return configurationOf(posture);
  // Who is crouched or turned stands up to walk, and the hand comes after.
  const Feet next = nextFeet(X_WF_, feet, wish, most);
  const bool well = walksWell(posture, feet);
  if (well || walksWell(start, feet))
    if (const auto there = goTo(next, feet, well ? posture : start, &near)) return configurationOf(*there);
  const Posture loose = unwound(start, feet);
  if (const auto there = goTo(next, feet, loose, nullptr)) return configurationOf(*there);
  // Where legs can go no farther although the body is upright, the foot is put down.
  const bool upright_already = glm::length(loose.X_WR.p - start.X_WR.p) < kUnwound;
  if (upright_already && footInAir(X_WF_, feet))
    if (const auto there = goTo(puttingDown(X_WF_, feet), feet, loose, nullptr)) return configurationOf(*there);
  return configurationOf(loose);
}

}  // namespace hapticell::manipulation
