// SPDX-License-Identifier: Apache-2.0
#include "manipulation/mannequin_steps.h"

#include <algorithm>
#include <cmath>

#include "mannequin/joint_limits.h"
#include "mannequin/limb_inverse.h"

namespace hapticell::manipulation {

namespace {

constexpr double kStepsFrom = 1e-3;    ///< m along the floor that must be missing before a foot is lifted.
constexpr double kLevelShare = 0.2;    ///< Of what is missing: a hand that lacks height alone is no reason to walk.
constexpr double kStride = 0.20;       ///< m
constexpr double kSideStep = 0.18;     ///< m
constexpr double kLift = 0.04;         ///< m
constexpr double kOnFloor = 1e-4;      ///< m
constexpr double kLeastStride = 0.02;  ///< m: a shorter one is not begun.

constexpr double kLongestLeg = 0.995;  ///< Of a straight one.
constexpr int kHeelTries = 5;
constexpr double kHeelStep = 0.15;  ///< rad
constexpr int kPelvisPasses = 6;

struct Gait {
  const FootPlaces& taken;
  const FootPlaces& now;
  dvec3 along{0.0};  ///< Unit, level; zero where nothing is missing.

  dvec3 stance(std::size_t foot) const { return taken[foot].p - taken[1 - foot].p; }
  double height(std::size_t foot) const { return now[foot].p.z - taken[foot].p.z; }
  /// m that a foot is ahead of the other one, beyond how both stood.
  double ahead(std::size_t foot) const { return glm::dot(now[foot].p - now[1 - foot].p - stance(foot), along); }
  /// m that it may still go.
  double room(std::size_t foot) const {
    dvec3 heading = taken[0].rotate({1, 0, 0}) + taken[1].rotate({1, 0, 0});
    heading.z = 0.0;
    const double length = glm::length(heading);
    const double forward = length > 1e-6 ? std::abs(glm::dot(heading, along)) / length : 1.0;
    const double outward = glm::dot(stance(foot), along) > 0.0 ? kSideStep : 0.0;
    return kStride * forward + outward * (1.0 - forward) - ahead(foot);
  }
  /// The foot that is in the air, else the one that begins: behind the other, or on the side that it goes to.
  std::size_t next() const {
    if (std::max(height(0), height(1)) > 0.0) return height(0) > height(1) ? 0 : 1;
    if (std::abs(ahead(0)) > kLeastStride) return ahead(0) < 0.0 ? 0 : 1;
    return glm::dot(stance(0), along) > 0.0 ? 0 : 1;
  }
};

}  // namespace

FootPlaces standingFeet(const FootPlaces& taken, const FootPlaces& now) {
  FootPlaces feet = now;
  const std::size_t lower = now[0].p.z - taken[0].p.z <= now[1].p.z - taken[1].p.z ? 0 : 1;
  for (std::size_t i = 0; i < 2; ++i) {
    feet[i].q = taken[i].q;
    feet[i].p.z = std::min(feet[i].p.z, taken[i].p.z + kLift);
    if (i == lower || feet[i].p.z < taken[i].p.z + kOnFloor) feet[i].p.z = taken[i].p.z;
  }
  return feet;
}

FootPlaces nextFeet(const FootPlaces& taken, const FootPlaces& now, const dvec3& missing_W, double most) {
  FootPlaces feet = standingFeet(taken, now);
  Gait gait{taken, feet};
  const dvec3 level(missing_W.x, missing_W.y, 0.0);
  const double length = glm::length(level);
  const bool wants = length > kStepsFrom && length > kLevelShare * glm::length(missing_W);
  if (wants) gait.along = level / length;
  const std::size_t foot = gait.next();
  const double height = gait.height(foot), room = wants ? gait.room(foot) : 0.0;
  const bool goes_on = room > kLeastStride;
  if (height == 0.0 && !goes_on) return feet;
  const double step = goes_on ? std::min(room, most) : 0.0;
  Pose next = feet[foot];
  next.p += step * gait.along;
  next.p.z = taken[foot].p.z + (goes_on ? std::min(kLift, height + most) : std::max(0.0, height - most));
  feet[foot] = next;
  return feet;
}

FootPlaces homeward(const FootPlaces& taken, const FootPlaces& now, double most) {
  FootPlaces feet = standingFeet(taken, now);
  const std::size_t foot = feet[0].p.z - taken[0].p.z > feet[1].p.z - taken[1].p.z ? 0 : 1;
  dvec3 way = taken[foot].p - taken[1 - foot].p - (feet[foot].p - feet[1 - foot].p);
  way.z = 0.0;
  const double length = glm::length(way);
  if (length > 0.0) feet[foot].p += std::min(1.0, most / length) * way;
  return feet;
}

namespace {

/// Puts a leg under the pelvis in closed form; false where its limits do not let it.
bool setLeg(const mannequin::Figure& figure, mannequin::Side side, const Pose& foot, mannequin::Posture& posture) {
  using mannequin::Dof;
  const mannequin::SegmentPlace pelvis{glm::mat3_cast(posture.X_WR.q), posture.X_WR.p};
  const auto leg = mannequin::legInverse(figure, side, pelvis, {glm::mat3_cast(foot.q), foot.p});
  if (leg.violation > 0.0 || leg.missing > 1e-9) return false;
  mannequin::setBallRotation(posture, legDof(side, Dof::kLeftHipFlexion), leg.R_PelvisThigh);
  posture[legDof(side, Dof::kLeftKneeFlexion)] = leg.knee;
  posture[legDof(side, Dof::kLeftAnklePlantarFlexion)] = leg.plantar_flexion;
  posture[legDof(side, Dof::kLeftAnkleInversion)] = leg.inversion;
  return true;
}

/// The same; the heel of a lifted foot may rise where the ankle bends no farther, and the foot with it, so that the
/// toes stay above the floor.
bool standLeg(const mannequin::Figure& figure, mannequin::Side side, bool lifted, Pose& foot,
              mannequin::Posture& posture) {
  const Pose flat = foot;
  for (int i = 0; i <= (lifted ? kHeelTries : 0); ++i) {
    const double pitch = i * kHeelStep;
    foot.q = flat.q * quaternionFromRotationVector({0.0, pitch, 0.0});
    foot.p.z = flat.p.z + figure.sole.ball_x * std::sin(pitch);
    if (setLeg(figure, side, foot, posture)) return true;
  }
  foot = flat;
  return false;
}

}  // namespace

std::optional<mannequin::Posture> goneWith(const mannequin::Figure& figure, mannequin::Posture posture,
                                           const FootPlaces& from, FootPlaces& to) {
  using mannequin::Segment, mannequin::Side;
  const dvec3 way = 0.5 * (to[0].p - from[0].p + to[1].p - from[1].p);
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
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    const bool lifted = to[i].p.z > std::min(to[0].p.z, to[1].p.z) + kOnFloor;
    if (!standLeg(figure, side, lifted, to[i], posture)) return std::nullopt;
  }
  return posture;
}

}  // namespace hapticell::manipulation
