// SPDX-License-Identifier: Apache-2.0
// A mannequin's hand with free feet: when it steps, and what its legs bear meanwhile.
#include <algorithm>
#include <cmath>

#include "manipulation/mannequin_manipulator.h"
#include "manipulation/mannequin_steps.h"

namespace hapticell::manipulation {

namespace {

using mannequin::Posture;
using mannequin::Side;

constexpr double kReached = 1e-3;               ///< m short of what is wanted that is no reason to step.
constexpr double kMostStep = 0.01;              ///< m a proposal that a foot goes.
constexpr double kComfortableReach = 0.80;      ///< Of the arm, level from over the feet: farther is walked.
constexpr double kWalkingSpeed = 1.5;           ///< m/s
constexpr double kFootSlack = 5e-4;             ///< m that a foot may be beside its place.
constexpr double kMostShift = 2e-3, kWrung = 0.05;  ///< m a proposal; m that the hand must lack for it.
constexpr double kLed = 0.03, kLedTurn = 0.15;  ///< m and rad ahead of the hand.
constexpr double kTwist = 0.61;      ///< rad (35 deg) that the pelvis heads beside the feet before they follow it.
constexpr double kMostTwist = 0.44;  ///< rad (25 deg) that the feet head beside the pelvis by turning.
constexpr double kLeastTwist = 0.12, kUntwisted = 0.3, kMostUntwisted = 0.03;  ///< rad, share and rad of one proposal.
constexpr double kAcross = 0.61, kOutward = 1.05;  ///< rad (35, 60 deg) from ahead within which a hand works.
constexpr double kNear = 0.25;                     ///< m from over the feet where no direction is meant.

/// The one that is longer over the floor.
dvec3 longer(const dvec3& a, const dvec3& b) {
  return std::hypot(a.x, a.y) >= std::hypot(b.x, b.y) ? a : b;
}

/// On the way from one pose to another, no farther than a hand is led at once.
Pose ahead(const Pose& from, const Pose& to) {
  const Twist way = difference(to, from);
  const double share = std::max(glm::length(way.linear) / kLed, glm::length(way.angular) / kLedTurn);
  if (share <= 1.0) return to;
  return {from.p + way.linear / share, glm::normalize(quaternionFromRotationVector(way.angular / share) * from.q)};
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

/// What the hand is wanted farther away, level, than an arm likes to reach from over the feet: people step before they
/// lean as far as they can.
dvec3 MannequinManipulator::beyondComfort(const Pose& X_WM, const Feet& X_WF) const {
  const std::size_t i = static_cast<std::size_t>(driven());
  const double out = (driven() == Side::kLeft ? 0.5 : -0.5) * figure().body[mannequin::Dimension::kBiacromialBreadth];
  dvec3 away = wantedHand(X_WM) - 0.5 * (X_WF[0].p + X_WF[1].p) - X_WF[i].rotate({0.0, out, 0.0});
  away.z = 0.0;
  const double distance = glm::length(away);
  const double comfortable = kComfortableReach * (figure().upperArmLength() + figure().forearmLength());
  return distance > comfortable ? (1.0 - comfortable / distance) * away : dvec3(0.0);
}

/// How far round the feet should head: after a pelvis that has turned over them; and with the pelvis to face what the
/// hand works at, and where both hands are turned, to go along; never far ahead of the pelvis, or the hips would lock.
double MannequinManipulator::wishedTurn(const Pose& X_WM, const Posture& posture, const Feet& X_WF) const {
  const double twist = headingBeside(posture.X_WR, X_WF);
  return std::clamp(std::abs(twist) > kTwist ? twist : turnToFace(X_WM, X_WF), twist - kMostTwist, twist + kMostTwist);
}

double MannequinManipulator::turnToFace(const Pose& X_WM, const Feet& X_WF) const {
  const dvec3 away = (isBoth() ? X_WM.p : wantedHand(X_WM)) - 0.5 * (X_WF[0].p + X_WF[1].p);
  const dvec3 ahead = X_WF[0].rotate({1.0, 0.0, 0.0}) + X_WF[1].rotate({1.0, 0.0, 0.0});
  const double beside = std::remainder(std::atan2(away.y, away.x) - std::atan2(ahead.y, ahead.x), 2.0 * M_PI);
  const bool near = std::hypot(away.x, away.y) < kNear, left = driven() == Side::kLeft;
  if (!isBoth()) return near ? 0.0 : beyond(beside, left ? -kAcross : -kOutward, left ? kOutward : kAcross);
  const dvec3 turned = rotationVector(X_WM.q * glm::conjugate(q_WM_));
  const double off = std::remainder(turned.z - turnedFeet(X_WF_, X_WF), 2.0 * M_PI);
  const double facing = near ? 0.0 : beyond(beside, -kAcross, kAcross);
  return facing != 0.0 ? facing : beyond(off, -kAcross, kAcross);
}

/// The posture that follows its feet from `feet` to `stepped`; nothing where its legs do not let it.
std::optional<Posture> MannequinManipulator::goTo(Feet stepped, const Feet& feet, const Posture& posture,
                                                  const Pose& X_WM) const {
  // A pelvis that is ahead of the feet waits for them.
  const double turned = std::remainder(turnedFeet(X_WF_, stepped) - turnedFeet(X_WF_, feet), 2.0 * M_PI);
  const double pelvis_turn = turned * headingBeside(posture.X_WR, feet) > 0.0 ? 0.0 : turned;
  const Feet wanted = stepped;
  const std::optional<Posture> gone = goneWith(figure(), posture, feet, stepped, pelvis_turn);
  if (!gone) stepped = wanted;  // Not in closed form: as far as the whole body gives way.
  Posture there = follow(taskFor(X_WM, stepped), gone ? *gone : posture, nullptr);
  const Feet reached = feetOf(there);
  for (std::size_t i = 0; i < 2; ++i)
    if (glm::length(reached[i].p - stepped[i].p) > kFootSlack) return std::nullopt;
  return there;
}

/// Where nothing else goes on: what the whole body can do to stand, and if need be without minding the hands.
Posture MannequinManipulator::standAgain(const Feet& down, const Posture& posture, const Pose& X_WM) const {
  const auto off = [&](const Posture& there) {
    const Feet reached = feetOf(there);
    return std::max(glm::length(reached[0].p - down[0].p), glm::length(reached[1].p - down[1].p));
  };
  if (off(posture) < kFootSlack && std::abs(headingBeside(posture.X_WR, down)) < kTwist) return posture;
  mannequin::PostureTask task = taskFor(X_WM, down);
  Posture there = follow(task, posture, nullptr);
  if (off(there) < off(posture) - kFootSlack) return there;
  task.held.reset();
  task.hands = {};
  const Posture loose = solver_.follow(task, posture).posture;
  if (off(loose) < off(posture) - kFootSlack) return loose;
  // Wrung so that no leg can be moved: it is shifted as it stands.
  there = posture;
  const dvec3 way = movedFrame(configurationOf(posture)).p - X_WM.p;
  if (std::hypot(way.x, way.y) < kWrung) return posture;
  there.X_WR.p -= std::min(1.0, kMostShift / std::max(1e-9, std::hypot(way.x, way.y))) * dvec3(way.x, way.y, 0.0);
  return there;
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
  // What is far away is gone to: a hand that pulled at it would wring the body.
  const Pose near = ahead(movedFrame(configurationOf(start)), X_WM);
  const Posture posture = follow(taskFor(near, feet), start, nullptr);
  StepWish wish;
  wish.missing_W = longer(X_WM.p - movedFrame(configurationOf(posture)).p, beyondComfort(X_WM, feet));
  if (std::hypot(wish.missing_W.x, wish.missing_W.y) < kReached) wish.missing_W = dvec3(0.0);
  wish.turn = wishedTurn(X_WM, posture, feet);
  const std::optional<std::size_t> foot = footToLift(X_WF_, feet, wish);
  if (!foot) return configurationOf(posture);
  if (const auto there = goTo(nextFeet(X_WF_, feet, wish, most), feet, posture, near)) return configurationOf(*there);
  // Where legs can go no farther the foot is put down, back beside the other one if need be.
  if (!footInAir(X_WF_, feet)) return configurationOf(standAgain(feet, posture, near));
  if (const auto there = goTo(puttingDown(X_WF_, feet, most), feet, posture, near)) return configurationOf(*there);
  if (const auto there = goTo(homeward(X_WF_, feet, most), feet, posture, near)) return configurationOf(*there);
  return configurationOf(standAgain(puttingDown(X_WF_, feet, most), posture, near));
}

}  // namespace hapticell::manipulation
