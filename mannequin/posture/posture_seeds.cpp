// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/posture_seeds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

double armCost(const ArmProblem& problem, const ArmAngles& arm) {
  const double away = std::remainder(arm.swivel - 45.0 * kDegree, 2.0 * std::numbers::pi);
  return 10.0 * (arm.violation + 4.0 * arm.missing) + 0.1 * away * away + (problem.stretch() > 1.0 ? 1.0 : 0.0);
}

/// Crouch and lean of one trunk of the lattice.
struct Lean {
  double crouch, pitch, yaw;
};
Lean leanOf(std::size_t i) {
  constexpr double kCrouch[4] = {0.96, 0.84, 0.70, 0.56};
  constexpr double kPitch[4] = {2.0, 24.0, 46.0, -12.0};
  constexpr double kYaw[3] = {0.0, 32.0, -32.0};
  return {kCrouch[i / 12], kPitch[(i / 3) % 4] * kDegree, kYaw[i % 3] * kDegree};
}

/// Where the feet stand: middle, heading.
struct Stance {
  dvec3 middle{0.0};
  dvec3 forward{1.0, 0.0, 0.0};
};
Stance stanceOf(const std::array<SegmentPlace, 2>& feet) {
  Stance stance;
  stance.middle = 0.5 * (feet[0].p_WS + feet[1].p_WS);
  dvec3 forward = feet[0].R_WS[0] + feet[1].R_WS[0];
  forward.z = 0.0;
  if (glm::length(forward) > 1e-6) stance.forward = glm::normalize(forward);
  return stance;
}

/// A trunk over the feet; the pelvis stands back from a lean roughly as balance wants it.
BodyState trunkFor(const Figure& figure, const ResolvedTask& task, const BodyState& present, const Lean& lean) {
  const Stance stance = stanceOf(task.feet);
  const double leg = figure.thighLength() + figure.shankLength();
  const double pelvis_pitch = 0.5 * lean.pitch, spine = lean.pitch - pelvis_pitch;
  const double pelvis_yaw = 0.5 * lean.yaw, spine_yaw = lean.yaw - pelvis_yaw;
  BodyState state = present;
  for (std::size_t i = 0; i < 9; ++i) state.angles[i] = 0.0;
  state.angles[indexOf(Dof::kVl5Flexion)] = std::clamp(0.42 * spine, -11.0 * kDegree, 34.0 * kDegree);
  state.angles[indexOf(Dof::kVl1Flexion)] = std::clamp(0.38 * spine, -7.0 * kDegree, 29.0 * kDegree);
  state.angles[indexOf(Dof::kVt6Flexion)] = std::clamp(0.20 * spine, -4.0 * kDegree, 14.0 * kDegree);
  state.angles[indexOf(Dof::kVl1LeftTurn)] = std::clamp(0.3 * spine_yaw, -9.0 * kDegree, 9.0 * kDegree);
  state.angles[indexOf(Dof::kVt6LeftTurn)] = std::clamp(0.7 * spine_yaw, -28.0 * kDegree, 28.0 * kDegree);
  const double heading = std::atan2(stance.forward.y, stance.forward.x) + pelvis_yaw;
  state.root.R_WS = aboutZ(heading) * aboutY(pelvis_pitch);
  const dvec3 between = task.feet[0].p_WS - task.feet[1].p_WS;
  const double spread = 0.25 * glm::dot(between, between);
  const double height = std::sqrt(std::max(0.05 * leg * leg, lean.crouch * lean.crouch * leg * leg - 0.6 * spread));
  const double back = 0.02 - 0.25 * std::sin(lean.pitch) * leg / 0.85;
  state.root.p_WS = stance.middle + back * stance.forward + dvec3(0.0, 0.0, height);
  return state;
}

double clamped(Dof dof, double angle) {
  return std::clamp(angle, dofInfo(dof).lower, dofInfo(dof).upper);
}

LegAngles insideLimits(Side side, LegAngles leg) {
  leg.R_PelvisThigh = clampBall(BallJoint::kHip, side, leg.R_PelvisThigh);
  leg.knee = clamped(Dof::kLeftKneeFlexion, leg.knee);
  leg.plantar_flexion = clamped(Dof::kLeftAnklePlantarFlexion, leg.plantar_flexion);
  leg.inversion = clamped(Dof::kLeftAnkleInversion, leg.inversion);
  return leg;
}

/// Puts legs under the trunk and the centre of mass over the feet: twice, because the legs follow. Returns what the
/// legs break.
double placeTrunk(const Figure& figure, const ResolvedTask& task, BodyState& state) {
  const Stance stance = stanceOf(task.feet);
  FigurePose pose;
  double cost = 0.0;
  for (int i = 0; i < 3; ++i) {
    cost = 0.0;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const LegAngles leg = legInverse(figure, side, state.root, task.feet[static_cast<std::size_t>(side)]);
      cost += 20.0 * leg.violation + 80.0 * leg.missing;
      setLeg(state, side, insideLimits(side, leg));
    }
    if (i == 2) break;
    placeSegments(figure, state, pose);
    const dvec3 off = stance.middle + 0.04 * stance.forward - centerOfMass(figure, pose, task.loads);
    state.root.p_WS += 1.1 * dvec3(off.x, off.y, 0.0);
  }
  return cost;
}

/// How badly a shoulder stands to where its hand should be: too near, too far, behind, across.
double reachCost(const Figure& figure, const ResolvedTask& task, const FigurePose& pose) {
  const double arm = figure.upperArmLength() + figure.forearmLength();
  double cost = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!task.has_hand[i]) continue;
    const Side side = static_cast<Side>(i);
    const SegmentPlace& thorax = pose[S::kThorax];
    const dvec3 shoulder = pose[armSegment(side, S::kLeftUpperArm)].p_WS;
    const dvec3 reach = glm::transpose(thorax.R_WS) * (task.hands[i].p_WS - shoulder);
    const double distance = glm::length(reach);
    const double outward = outwardSign(side) * reach.y;
    cost += 4.0 * std::max(0.0, distance - 0.92 * arm) / arm + 2.0 * std::max(0.0, 0.44 * arm - distance) / arm;
    cost += 2.0 * std::max(0.0, -reach.x + 0.05) / arm + 1.5 * std::max(0.0, -outward - 0.45 * arm) / arm;
    cost += 0.8 * std::max(0.0, reach.z - 0.5 * arm) / arm;
  }
  return cost;
}

/// The girdle as its rhythm has it for an arm that points at its target.
void setGirdles(const Figure& figure, const ResolvedTask& task, BodyState& state) {
  FigurePose pose;
  placeSegments(figure, state, pose);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!task.has_hand[i]) continue;
    const Side side = static_cast<Side>(i);
    const dvec3 shoulder = pose[armSegment(side, S::kLeftUpperArm)].p_WS;
    const dvec3 reach = glm::transpose(pose[S::kThorax].R_WS) * (task.hands[i].p_WS - shoulder);
    const double distance = std::max(1e-6, glm::length(reach));
    const double elevation = std::acos(std::clamp(-reach.z / distance, -1.0, 1.0));
    state.angles[indexOf(armDof(side, Dof::kLeftClavicleElevation))] = girdleElevation(elevation);
    state.angles[indexOf(armDof(side, Dof::kLeftClavicleProtraction))] = girdleProtraction(reach.x / distance);
  }
}

}  // namespace

SeededState withArms(const Figure& figure, const ResolvedTask& task, const BodyState& from, int swivels) {
  SeededState seeded{from, 0.0};
  FigurePose pose;
  placeSegments(figure, seeded.state, pose);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!task.has_hand[i]) continue;
    const Side side = static_cast<Side>(i);
    const ArmProblem problem(figure, side, pose[S::kThorax], pose[armSegment(side, S::kLeftClavicle)], task.hands[i]);
    ArmAngles best;
    double least = 1e9;
    for (int k = 0; k < swivels; ++k) {
      const ArmAngles arm = problem.at((-170.0 + 360.0 * k / swivels) * kDegree);
      const double cost = armCost(problem, arm);
      if (cost >= least) continue;
      least = cost;
      best = arm;
    }
    seeded.cost += least;
    best.R_ClavicleUpperArm = clampBall(BallJoint::kShoulder, side, best.R_ClavicleUpperArm);
    best.pronation = clamped(Dof::kLeftPronation, best.pronation);
    best.wrist_flexion = clamped(Dof::kLeftWristFlexion, best.wrist_flexion);
    best.wrist_ulnar = clamped(Dof::kLeftWristUlnarDeviation, best.wrist_ulnar);
    setArm(seeded.state, side, best);
  }
  return seeded;
}

PostureSeeds::PostureSeeds(const Figure& figure, const ResolvedTask& task, const BodyState& present)
    : figure_(figure), task_(task), present_(present) {
  FigurePose pose;
  for (std::size_t i = 0; i < kTrunks; ++i) {
    placeSegments(figure, trunkFor(figure, task, present, leanOf(i)), pose);
    ranked_[i] = {reachCost(figure, task, pose), i};
  }
  std::sort(ranked_.begin(), ranked_.end(), [](const Ranked& a, const Ranked& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.index < b.index);
  });
}

void PostureSeeds::makeBatch() {
  std::array<double, kBatch> costs{};
  for (std::size_t k = 0; k < kBatch; ++k) {
    const Ranked& entry = ranked_[given_ + k];
    BodyState trunk = trunkFor(figure_, task_, present_, leanOf(entry.index));
    costs[k] = placeTrunk(figure_, task_, trunk) + 0.5 * entry.cost;
    setGirdles(figure_, task_, trunk);
    const SeededState armed = withArms(figure_, task_, trunk, 10);
    batch_[k] = armed.state;
    costs[k] += armed.cost;
    order_[k] = k;
  }
  for (std::size_t i = 1; i < kBatch; ++i) {
    for (std::size_t k = i; k > 0 && costs[order_[k]] < costs[order_[k - 1]]; --k) std::swap(order_[k], order_[k - 1]);
  }
}

const BodyState* PostureSeeds::next() {
  const bool both = task_.has_hand[0] && task_.has_hand[1];
  if (given_ >= (both ? kMost : kBatch)) return nullptr;
  if (given_ % kBatch == 0) makeBatch();
  return &batch_[order_[given_++ % kBatch]];
}

Posture steppedTowards(const Figure& figure, const PostureTask& task, const Posture& start) {
  dvec3 aim(0.0);
  double count = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (task.held) {
      aim += (task.held->X_WO * task.held->X_OH[i]).p;
      count += 1.0;
    } else if (task.hands[i]) {
      aim += task.hands[i]->p;
      count += 1.0;
    }
  }
  if (count == 0.0) return start;
  aim /= count;
  const double arm = figure.upperArmLength() + figure.forearmLength();
  dvec3 towards = aim - start.X_WR.p;
  towards.z = 0.0;
  const double distance = glm::length(towards);
  const dvec3 forward = distance > 0.05 ? towards / distance : start.X_WR.rotate({1, 0, 0});
  Posture moved = *libraryPosture(figure, "standing");
  moved.X_WR.q = quaternionFromRotationVector({0.0, 0.0, std::atan2(forward.y, forward.x)});
  moved.X_WR.p = dvec3(aim.x, aim.y, moved.X_WR.p.z) - 0.75 * arm * dvec3(forward.x, forward.y, 0.0);
  return moved;
}

}  // namespace hapticell::mannequin
