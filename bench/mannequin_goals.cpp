// SPDX-License-Identifier: Apache-2.0
#include "bench/mannequin_goals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mannequin/body/joint_limits.h"
#include "mannequin/posture/limb_inverse.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::bench {

namespace {

using namespace mannequin;
double uniform(std::mt19937_64& random, double low, double high) {
  // Not std::uniform_real_distribution: its results differ between libraries.
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1.0p-53);
}

dmat3 randomShoulder(std::mt19937_64& random, Side side, double share) {
  while (true) {
    const double psi = uniform(random, -std::numbers::pi, std::numbers::pi),
                 rho = std::numbers::pi * std::sqrt(uniform(random, 0.0, 1.0));
    const double twist = uniform(random, kShoulderTwistLower, kShoulderTwistUpper);
    const double middle = 0.5 * (kShoulderTwistLower + kShoulderTwistUpper);
    const dmat3 R = ballRotation(BallJoint::kShoulder, side, share * rho, psi, middle + share * (twist - middle));
    if (ballState(BallJoint::kShoulder, side, R).rho <= share * ballState(BallJoint::kShoulder, side, R).rho_max)
      return R;
  }
}

std::array<SegmentPlace, 2> stance(const Figure& figure, bool split) {
  std::array<SegmentPlace, 2> feet;
  for (std::size_t i = 0; i < 2; ++i) {
    const double out = i == 0 ? 1.0 : -1.0;
    const double split_toes = (i == 0 ? 12.0 : 15.0) * kDegree * out;
    const double toes = split ? split_toes : 0.0;
    const double y = out * glm::abs(figure.p_PS[indexOf(Segment::kLeftThigh)].y);
    feet[i].R_WS = rotationYXZ({0.0, 0.0, toes});
    feet[i].p_WS = {split ? 0.15 * out : 0.0, y, -figure.sole.z};
  }
  return feet;
}

bool putLegsBack(const Figure& figure, const std::array<SegmentPlace, 2>& feet, double share, Posture& posture) {
  const SegmentPlace pelvis{glm::mat3_cast(posture.X_WR.q), posture.X_WR.p};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const LegAngles leg = legInverse(figure, side, pelvis, feet[static_cast<std::size_t>(side)]);
    if (leg.violation > 0.0 || leg.missing > 1e-9 || leg.knee > (0.5 + 0.5 * share) * 150.0 * kDegree) return false;
    setBallRotation(posture, legDof(side, Dof::kLeftHipFlexion), leg.R_PelvisThigh);
    posture[legDof(side, Dof::kLeftKneeFlexion)] = leg.knee;
    posture[legDof(side, Dof::kLeftAnklePlantarFlexion)] = leg.plantar_flexion;
    posture[legDof(side, Dof::kLeftAnkleInversion)] = leg.inversion;
  }
  return true;
}

double distanceToSegment(const dvec3& p, const dvec3& a, const dvec3& b) {
  const double s = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::length(p - (a + s * (b - a)));
}

/// Elbows, wrists and fingers outside capsules about trunk, head and thighs.
bool clearOfItself(const FigurePose& pose) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SegmentPlace& hand = pose[armSegment(side, Segment::kLeftHand)];
    for (const dvec3& p : {pose[armSegment(side, Segment::kLeftForearm)].p_WS, hand.p_WS, hand.point({0, 0, -0.12})}) {
      if (distanceToSegment(p, pose[Segment::kPelvis].p_WS, pose[Segment::kLowerNeck].p_WS) < 0.14) return false;
      if (distanceToSegment(p, pose[Segment::kHead].p_WS, pose[Segment::kHead].point({0.02, 0, 0.1})) < 0.11)
        return false;
      for (const Side leg : {Side::kLeft, Side::kRight}) {
        if (distanceToSegment(p, pose[legSegment(leg, Segment::kLeftThigh)].p_WS,
                              pose[legSegment(leg, Segment::kLeftShank)].p_WS) < 0.09) {
          return false;
        }
      }
      if (p.z < 0.03) return false;
    }
  }
  const dvec3 between = pose[Segment::kLeftHand].point({0, 0, -0.08}) - pose[Segment::kRightHand].point({0, 0, -0.08});
  return glm::length(between) > 0.08;
}

Posture randomPosture(const Figure& figure, const std::array<SegmentPlace, 2>& feet, double share,
                      std::mt19937_64& random) {
  Posture posture;
  for (std::size_t i = 0; i < indexOf(Dof::kLeftHipFlexion); ++i) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i));
    const double middle = 0.5 * (info.lower + info.upper);
    posture.angles[i] = middle + share * (uniform(random, info.lower, info.upper) - middle);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    setBallRotation(posture, armDof(side, Dof::kLeftShoulderFlexion), randomShoulder(random, side, share));
    double& elbow = posture[armDof(side, Dof::kLeftElbowFlexion)];
    elbow = std::max(elbow, uniform(random, 12.0, 30.0) * kDegree);
  }
  const double leg = figure.thighLength() + figure.shankLength();
  const double pitch = uniform(random, -15.0, 60.0) * share * kDegree;
  posture.X_WR.q = quaternionFromRotationVector({0, 0, uniform(random, -25.0, 25.0) * share * kDegree}) *
                   quaternionFromRotationVector({0, pitch, 0});
  const dvec3 middle = 0.5 * (feet[0].p_WS + feet[1].p_WS);
  posture.X_WR.p = middle + dvec3(uniform(random, -0.35, 0.15), uniform(random, -0.1, 0.1), 0.0);
  posture.X_WR.p.z = uniform(random, 0.5, middle.z + 0.99 * leg);
  return posture;
}

}  // namespace

ReachableGoal makeGoal(const Figure& figure, const GoalOptions& options, std::mt19937_64& random) {
  const auto feet = stance(figure, options.split_stance);
  const SupportPolygon support = supportPolygon(figure, feet);
  ReachableGoal goal;
  while (true) {
    goal.reached = randomPosture(figure, feet, options.share, random);
    if (!putLegsBack(figure, feet, options.share, goal.reached)) continue;
    const FigurePose pose = forwardKinematics(figure, goal.reached);
    if (support.margin(glm::dvec2(centerOfMass(figure, pose))) < 0.020 || !clearOfItself(pose)) continue;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      goal.task.hands[i] = handPose(pose, side);
      goal.task.feet[i] = feet[i].pose();
    }
    break;
  }
  goal.neutral = *libraryPosture(figure, "standing");
  const dvec3 middle = 0.5 * (feet[0].p_WS + feet[1].p_WS);
  const double leg = figure.thighLength() + figure.shankLength();
  for (double share = 0.99; share > 0.5; share -= 0.01) {
    goal.neutral.X_WR.p = middle + dvec3(0.0, 0.0, share * leg);
    if (putLegsBack(figure, feet, 1.0, goal.neutral)) break;
  }
  return goal;
}

}  // namespace hapticell::bench
