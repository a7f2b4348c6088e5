// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/mannequin_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mannequin/body/joint_limits.h"
#include "mannequin/posture/limb_inverse.h"

namespace hapticell::manipulation {

namespace {

/// m along the floor that must be missing before a foot is lifted: what is asked for is beyond comfort already. Half
/// and twice: the first step by a millimetre sooner or later.
constexpr double kStepsFrom = 1e-3;
/// Of what is missing: a hand that lacks height alone is no reason to walk. Half: it steps under a high shelf; twice:
/// it stretches where a step would do.
constexpr double kLevelShare = 0.2;
/// m from under the body, so a foot goes up to 0.4 (Mannequin; our choice). Half: twice the steps; twice: legs at their
/// limits.
constexpr double kStride = 0.20;
/// m (Mannequin; our choice). Half: twice the steps; twice: hips at their limits.
constexpr double kSideStep = 0.18;
/// m that a foot is lifted (Mannequin; our choice). Half: the toes touch on the way; twice: knees at each step.
constexpr double kLift = 0.04;
/// m: the foot stands. A thousand times the solver's tenth of a micron. Half and twice as well.
constexpr double kOnFloor = 1e-4;
/// rad: the foot heads as it was taken, so that its pose is the same to the bit. Half and twice are far above rounding.
constexpr double kSameHeading = 1e-6;
/// m: a shorter one is not begun, a tenth of kStride. Half: it trips along; twice: it stops 40 mm short of comfort.
constexpr double kLeastStride = 0.02;
/// rad (12 deg) that a foot must lag before it steps round. Our choice. Half: it treads at each turn; twice: feet stay
/// askew.
constexpr double kTurnFrom = 0.21;
/// rad that is left when it has come round, half a degree. Half: a proposal more; twice: the next turn begins sooner.
constexpr double kTurned = 0.01;
/// rad (35 deg) between both feet, beyond how they stood (Mannequin, Steps; our choice). Half: turns of many steps;
/// twice: beyond the hips.
constexpr double kMostApart = 0.61;
/// rad (20 deg) between both feet that are left alone. Our choice. Half: it treads after each turn; twice: it stands
/// pigeon-toed.
constexpr double kAskew = 0.35;
/// m that a foot keeps to its side of the other one: a foot's breadth, so that they do not overlap. Half: feet through
/// each other; twice: astride.
constexpr double kLeastApart = 0.12;
/// m that a rad of a lifted foot counts, about from the ankle to the toes. Half: it whirls; twice: it turns slowly.
constexpr double kTurnLever = 0.15;

/// Of a straight one, so that the knee has a direction (11 deg bent). Half of what is missing: 8 deg, near its
/// singularity; twice: a pelvis that sinks with each stride.
constexpr double kLongestLeg = 0.995;
/// Times kHeelStep (rad) that the heel of a lifted foot comes up: 43 deg, as in a push off. Half: strides end sooner;
/// twice: on the tips of its toes.
constexpr int kHeelTries = 5;
/// rad: coarse, as it is seen only on the way. Half: more tries; twice: the heel jumps.
constexpr double kHeelStep = 0.15;
/// Passes that lower the pelvis onto both legs in turns; each closes in. Half: some steps fail; twice: no more succeed.
constexpr int kPelvisPasses = 6;
/// Of a way that is gone at all, ten halvings. Half: one more; twice: one fewer.
constexpr double kLeastShare = 1e-3;
/// rad beyond its limits that a leg is helped out of by a pelvis that rises (the solver leaves 1e-7). Half and twice as
/// well.
constexpr double kLittleBent = 1e-3;
/// So many m for a rad: a bent leg's ankle turns by 2 to 4 rad a metre. Half: more tries; twice: it hops by twice of
/// what is needed.
constexpr double kRise = 0.5;
/// Tries of it; one is nearly right. Half: some ankles stay stuck; twice: nothing more.
constexpr int kRises = 3;

double headingOf(const dquat& q) {
  const dvec3 ahead = q * dvec3(1.0, 0.0, 0.0);
  return std::atan2(ahead.y, ahead.x);
}
double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}
struct Gait {
  Gait(const FootPlaces& feet_taken, const FootPlaces& feet, const StepWish& wish) : taken(feet_taken), now(feet) {
    for (std::size_t i = 0; i < 2; ++i) yaw[i] = wrapped(headingOf(now[i].q) - headingOf(taken[i].q));
    const double mean = turnedFeet(taken, now);
    // Both on the same side of the turn where angles jump.
    for (double& angle : yaw) angle = mean + wrapped(angle - mean);
    heading = mean;
    // Feet that stand too far askew are brought beside each other.
    const bool askew = wish.turn == 0.0 && std::abs(yaw[0] - yaw[1]) > kAskew;
    const double farther = std::abs(yaw[0]) > std::abs(yaw[1]) ? yaw[0] : yaw[1];
    goal = askew ? farther : mean + wish.turn;
    turns = askew || wish.turn != 0.0;
    const dvec3 level(wish.missing_W.x, wish.missing_W.y, 0.0);
    const double length = glm::length(level);
    if (length > kStepsFrom && length > kLevelShare * glm::length(wish.missing_W)) along = level / length;
  }

  const FootPlaces& taken;
  const FootPlaces& now;
  std::array<double, 2> yaw{};  ///< rad that each foot has turned since it was taken.
  double heading = 0.0, goal = 0.0;
  bool turns = false;
  dvec3 along{0.0};  ///< Unit, level; zero where nothing is missing.

  /// How a foot stands beside the other one, where both head like `heading`.
  dvec3 stance(std::size_t foot) const { return turnedLeft(heading) * (taken[foot].p - taken[1 - foot].p); }
  double height(std::size_t foot) const { return now[foot].p.z - taken[foot].p.z; }
  /// m that a foot is ahead of the other one, beyond how both stood.
  double ahead(std::size_t foot) const { return glm::dot(now[foot].p - now[1 - foot].p - stance(foot), along); }
  /// m that it may still go.
  double room(std::size_t foot) const {
    if (along == dvec3(0.0)) return 0.0;
    const dvec3 front = turnedLeft(heading) * (taken[0].rotate({1, 0, 0}) + taken[1].rotate({1, 0, 0}));
    const double length = std::hypot(front.x, front.y);
    const double forward = length > 1e-6 ? std::abs(front.x * along.x + front.y * along.y) / length : 1.0;
    const double outward = glm::dot(stance(foot), along) > 0.0 ? kSideStep : 0.0;
    return std::min(kStride * forward + outward * (1.0 - forward) - ahead(foot), roomToOther(foot));
  }
  dvec3 outwardOf(std::size_t foot) const { return turnedLeft(heading) * dvec3(0.0, foot == 0 ? 1.0 : -1.0, 0.0); }
  double apart(std::size_t foot, const dvec3& p) const { return glm::dot(p - now[1 - foot].p, outwardOf(foot)); }
  /// m that it may go until it would be across the other one.
  double roomToOther(std::size_t foot) const {
    const double nearer = -glm::dot(along, outwardOf(foot));
    return nearer > 1e-3 ? std::max(0.0, apart(foot, now[foot].p) - kLeastApart) / nearer : kStride + kSideStep;
  }
  /// rad that it has to turn: as far as the other one allows.
  double lag(std::size_t foot) const {
    if (!turns) return 0.0;
    const double other = yaw[1 - foot];
    return std::clamp(goal, other - kMostApart, other + kMostApart) - yaw[foot];
  }
  /// Where a lifted foot is after `most` (m) along the floor.
  Pose gone(std::size_t foot, double most) const {
    Pose moved = now[foot];
    const bool round = std::abs(lag(foot)) > kTurned;
    if (round) {
      // About the other foot by half: when that has come round as well, both stand beside each other as before.
      const double turn = std::clamp(lag(foot), -most / kTurnLever, most / kTurnLever);
      const dvec3& pivot = now[1 - foot].p;
      dvec3 way = turnedLeft(0.5 * turn) * (moved.p - pivot) + pivot - moved.p;
      way.z = 0.0;
      const double length = glm::length(way);
      moved.p += std::min(1.0, most / std::max(1e-12, length)) * way;
      moved.q = glm::normalize(turnedLeft(turn) * moved.q);
    }
    if (room(foot) > kLeastStride) moved.p += std::min(room(foot), round ? 0.5 * most : most) * along;
    const double close = kLeastApart - apart(foot, moved.p);
    if (close > 0.0) moved.p += std::min(close, most) * outwardOf(foot);
    return moved;
  }
  /// The foot that is in the air, else the one that begins: to turn, behind the other, or on the side that it goes to.
  std::optional<std::size_t> next() const {
    if (std::max(height(0), height(1)) > 0.0) return height(0) > height(1) ? 0 : 1;
    const double lags_more = std::abs(lag(0)) - std::abs(lag(1));
    const bool first_lags = std::abs(lags_more) > kTurned ? lags_more > 0.0 : goal > heading;
    const std::size_t lags = first_lags ? 0 : 1;
    if (std::abs(lag(lags)) > kTurnFrom) return lags;
    if (along == dvec3(0.0)) return std::nullopt;
    const bool first_begins = std::abs(ahead(0)) > kLeastStride ? ahead(0) < 0.0 : glm::dot(stance(0), along) > 0.0;
    const std::size_t foot = first_begins ? 0 : 1;
    for (const std::size_t one : {foot, 1 - foot})
      if (room(one) > kLeastStride) return one;
    return std::nullopt;
  }
};

}  // namespace

double turnedFeet(const FootPlaces& taken, const FootPlaces& now) {
  const double left = wrapped(headingOf(now[0].q) - headingOf(taken[0].q));
  return wrapped(left + 0.5 * wrapped(headingOf(now[1].q) - headingOf(taken[1].q) - left));
}

FootPlaces standingFeet(const FootPlaces& taken, const FootPlaces& now) {
  FootPlaces feet = now;
  const std::size_t lower = now[0].p.z - taken[0].p.z <= now[1].p.z - taken[1].p.z ? 0 : 1;
  for (std::size_t i = 0; i < 2; ++i) {
    const double yaw = wrapped(headingOf(now[i].q) - headingOf(taken[i].q));
    feet[i].q = std::abs(yaw) < kSameHeading ? taken[i].q : glm::normalize(turnedLeft(yaw) * taken[i].q);
    feet[i].p.z = std::min(feet[i].p.z, taken[i].p.z + kLift);
    if (i == lower || feet[i].p.z < taken[i].p.z + kOnFloor) feet[i].p.z = taken[i].p.z;
  }
  return feet;
}

FootPlaces levelled(const FootPlaces& taken, const FootPlaces& now, double ball_x) {
  FootPlaces feet = now;
  for (std::size_t i = 0; i < 2; ++i) {
    const dvec3 ball(ball_x, 0.0, 0.0);
    feet[i].q = glm::normalize(turnedLeft(headingOf(now[i].q) - headingOf(taken[i].q)) * taken[i].q);
    feet[i].p = now[i] * ball - feet[i].q * ball;
  }
  return feet;
}

double headingBeside(const Pose& X_WR, const FootPlaces& feet) {
  const dvec3 ahead = feet[0].rotate({1.0, 0.0, 0.0}) + feet[1].rotate({1.0, 0.0, 0.0});
  return wrapped(headingOf(X_WR.q) - std::atan2(ahead.y, ahead.x));
}

std::optional<std::size_t> footInAir(const FootPlaces& taken, const FootPlaces& now) {
  const FootPlaces feet = standingFeet(taken, now);
  for (std::size_t i = 0; i < 2; ++i)
    if (feet[i].p.z > taken[i].p.z) return i;
  return std::nullopt;
}

std::optional<std::size_t> footToLift(const FootPlaces& taken, const FootPlaces& now, const StepWish& wish) {
  const FootPlaces feet = standingFeet(taken, now);
  return Gait(taken, feet, wish).next();
}

FootPlaces nextFeet(const FootPlaces& taken, const FootPlaces& now, const StepWish& wish, double most) {
  FootPlaces feet = standingFeet(taken, now);
  const Gait gait(taken, feet, wish);
  const std::optional<std::size_t> next = gait.next();
  if (!next) return feet;
  const std::size_t foot = *next;
  const double height = gait.height(foot);
  const bool goes = gait.room(foot) > kLeastStride || std::abs(gait.lag(foot)) > kTurned;
  // Straight up, along, straight down.
  if (!goes || height < kLift - kOnFloor) {
    feet[foot].p.z = taken[foot].p.z + (goes ? std::min(kLift, height + most) : std::max(0.0, height - most));
    return feet;
  }
  feet[foot] = gait.gone(foot, most);
  return feet;
}

FootPlaces puttingDown(const FootPlaces& taken, const FootPlaces& now) {
  FootPlaces feet = standingFeet(taken, now);
  for (std::size_t i = 0; i < 2; ++i) feet[i].p.z = taken[i].p.z;
  return feet;
}

namespace {

/// rad beyond limits of a leg that does not reach: any number that no leg can have.
constexpr double kNoLeg = 1e3;

/// Puts a leg under the pelvis in closed form; where its limits do not let it, what it is beyond them is returned (rad,
/// kNoLeg: it is too short or too long), and the posture is as it was.
double setLeg(const mannequin::Figure& figure, mannequin::Side side, const Pose& foot, mannequin::Posture& posture) {
  using mannequin::Dof;
  const mannequin::SegmentPlace pelvis{glm::mat3_cast(posture.X_WR.q), posture.X_WR.p};
  const auto leg = mannequin::legInverse(figure, side, pelvis, {glm::mat3_cast(foot.q), foot.p});
  if (leg.missing > 1e-9) return kNoLeg;
  if (leg.violation > 0.0) return leg.violation;
  mannequin::setBallRotation(posture, legDof(side, Dof::kLeftHipFlexion), leg.R_PelvisThigh);
  posture[legDof(side, Dof::kLeftKneeFlexion)] = leg.knee;
  posture[legDof(side, Dof::kLeftAnklePlantarFlexion)] = leg.plantar_flexion;
  posture[legDof(side, Dof::kLeftAnkleInversion)] = leg.inversion;
  return 0.0;
}

/// The same; the heel of a lifted foot may rise where the ankle bends no farther, and the foot with it, so that the
/// toes stay above the floor.
double placeLeg(const mannequin::Figure& figure, mannequin::Side side, bool lifted, Pose& foot,
                mannequin::Posture& posture) {
  const Pose flat = foot;
  const dvec3 ball(figure.sole.ball_x, 0.0, 0.0);
  double beyond = 0.0;
  for (int i = 0; i <= (lifted ? kHeelTries : 0); ++i) {
    const double pitch = i * kHeelStep;
    foot.q = flat.q * quaternionFromRotationVector({0.0, pitch, 0.0});
    foot.p = flat * ball - foot.q * ball;
    beyond = setLeg(figure, side, foot, posture);
    if (beyond == 0.0) return 0.0;
  }
  foot = flat;
  return beyond;
}

/// Both legs; what the worse of them is beyond its limits, which leaves the posture half set.
double placeLegs(const mannequin::Figure& figure, FootPlaces& feet, mannequin::Posture& posture) {
  const double floor = std::min(feet[0].p.z, feet[1].p.z);
  double worst = 0.0;
  for (const mannequin::Side side : {mannequin::Side::kLeft, mannequin::Side::kRight}) {
    Pose& foot = feet[static_cast<std::size_t>(side)];
    worst = std::max(worst, placeLeg(figure, side, foot.p.z > floor + kOnFloor, foot, posture));
    if (worst > kLittleBent) break;
  }
  return worst;
}

}  // namespace

std::optional<mannequin::Posture> goneWith(const mannequin::Figure& figure, mannequin::Posture posture,
                                           const FootPlaces& from, FootPlaces& to, double turn) {
  using mannequin::Segment, mannequin::Side;
  const dvec3 way = 0.5 * (to[0].p - from[0].p + to[1].p - from[1].p);
  if (turn != 0.0) {
    const dquat round = turnedLeft(turn);
    const dvec3 middle = 0.5 * (from[0].p + from[1].p);
    posture.X_WR = {middle + round * (posture.X_WR.p - middle), glm::normalize(round * posture.X_WR.q)};
  }
  posture.X_WR.p += dvec3(way.x, way.y, 0.0);
  const double longest = kLongestLeg * (figure.thighLength() + figure.shankLength());
  for (int i = 0; i < kPelvisPasses; ++i) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const dvec3 hip = posture.X_WR * figure.p_PS[indexOf(legSegment(side, Segment::kLeftThigh))];
      const dvec3 down = to[static_cast<std::size_t>(side)].p - hip;
      const double length = glm::length(down);
      if (length > longest) posture.X_WR.p += (1.0 - longest / length) * down;
    }
  }
  if (placeLegs(figure, to, posture) > 0.0) return std::nullopt;
  return posture;
}

mannequin::Posture stoodOn(const mannequin::Figure& figure, const mannequin::Posture& start,
                           const mannequin::Posture& there, const FootPlaces& feet) {
  for (double share = 1.0; share >= kLeastShare; share *= 0.5) {
    mannequin::Posture posture = share < 1.0 ? mannequin::interpolate(start, there, share) : there;
    // The solver has feet where they stand to within a tenth of a micron, and an ankle at its limit is beyond it by as
    // little here: without this it would be stuck there.
    for (int i = 0; i <= kRises; ++i) {
      FootPlaces places = feet;
      const double beyond = placeLegs(figure, places, posture);
      if (beyond == 0.0) return posture;
      if (beyond > kLittleBent) break;
      posture.X_WR.p.z += kRise * beyond;
    }
  }
  return start;
}

}  // namespace hapticell::manipulation
