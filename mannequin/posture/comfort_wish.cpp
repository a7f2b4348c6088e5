// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mannequin/body/rotations.h"
#include "mannequin/posture/body_solver.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// Of the leg's length that the hip stands above the ankle; our choice (docs/dev/mannequin.md): knees bent by 28 deg.
/// Half the rest: nearly straight, where knees lock; twice: 40 deg.
constexpr double kStandingShare = 0.97;
/// m: where the centre of mass likes to be, near the middle of the soles; our choice. Half: near the heels; twice: near
/// the toes.
constexpr double kForwardOfAnkle = 0.050;
/// Of the spine's flexion that the pelvis takes over; our choice. Half: round backs; above 1: the pelvis bends farther
/// than it has to.
constexpr double kPitchShare = 0.8;

/// The turn w as a combination of the ball joint's axes (which are not orthogonal).
dvec3 alongAxes(const BallAxes& axes, const dvec3& bone, const dvec3& w) {
  const dvec3 cone = axes.cone - glm::dot(axes.cone, bone) * bone, free = axes.free - glm::dot(axes.free, bone) * bone;
  const double a = glm::dot(w, cone), b = glm::dot(w, free);
  const double along = glm::dot(w - a * axes.cone - b * axes.free, bone);
  return {a, b, along * glm::dot(axes.bone, bone)};
}

/// Swings the elbow towards its preferred swivel without moving the hand.
void wishArm(const Figure& figure, Side side, const BodyState& state, const FigurePose& pose, const VariableAxes& axes,
             double share, Variables& wish) {
  const ArmProblem problem(figure, side, pose[S::kThorax], pose[armSegment(side, S::kLeftClavicle)],
                           pose[armSegment(side, S::kLeftHand)]);
  if (problem.stretch() > 0.999) return;
  const double swivel = problem.swivelOf(pose[armSegment(side, S::kLeftForearm)].p_WS);
  const double change = std::remainder(problem.preferredSwivelNear(swivel, 0.35) - swivel, 2.0 * std::numbers::pi);
  const ArmAngles now = problem.at(swivel), then = problem.at(swivel + share * change);
  const std::size_t v = static_cast<std::size_t>(armVariable(side));
  const dmat3& R = state.balls[side == Side::kLeft ? 0 : 1];
  const dvec3 turn = rotationVector(glm::quat_cast(then.R_ClavicleUpperArm * glm::transpose(now.R_ClavicleUpperArm)));
  const dvec3 parts = alongAxes(axes.balls[side == Side::kLeft ? 0 : 1], -R[2], turn);
  for (int k = 0; k < 3; ++k) wish[v + 2 + static_cast<std::size_t>(k)] = parts[k];
  wish[v + 6] = std::remainder(then.pronation - now.pronation, 2.0 * std::numbers::pi);
  wish[v + 7] = then.wrist_flexion - now.wrist_flexion;
  wish[v + 8] = then.wrist_ulnar - now.wrist_ulnar;
}

void wishGirdle(const Figure&, Side side, const BodyState& state, const FigurePose& pose, double share,
                Variables& wish) {
  const SegmentPlace& thorax = pose[S::kThorax];
  const dvec3 bone = glm::transpose(thorax.R_WS) * -pose[armSegment(side, S::kLeftUpperArm)].R_WS[2];
  const double elevation = std::acos(std::clamp(-bone.z, -1.0, 1.0));
  const std::size_t v = static_cast<std::size_t>(armVariable(side));
  wish[v] = share * (girdleElevation(elevation) - state.angles[indexOf(armDof(side, Dof::kLeftClavicleElevation))]);
  wish[v + 1] =
      share * (girdleProtraction(bone.x) - state.angles[indexOf(armDof(side, Dof::kLeftClavicleProtraction))]);
}

/// Stands the pelvis up, over the feet, facing as they do, pitched with the spine.
void wishPelvis(const Figure& figure, const ResolvedTask& task, const BodyState& state, const FigurePose& pose,
                double share, Variables& wish) {
  const dvec3 middle = 0.5 * (task.feet[0].p_WS + task.feet[1].p_WS);
  dvec3 forward = task.feet[0].R_WS[0] + task.feet[1].R_WS[0];
  forward.z = 0.0;
  if (glm::length(forward) < 1e-6) return;
  forward = glm::normalize(forward);
  const double leg = figure.thighLength() + figure.shankLength();
  const dvec3 com = centerOfMass(figure, pose, task.loads);
  const dvec3 balance = middle + kForwardOfAnkle * forward - com;
  const double spread = 0.5 * glm::length(task.feet[0].p_WS - task.feet[1].p_WS);
  const double standing =
      std::sqrt(std::max(0.1 * leg * leg, kStandingShare * kStandingShare * leg * leg - 0.5 * spread * spread));
  wish[0] = share * balance.x;
  wish[1] = share * balance.y;
  wish[2] = share * (middle.z + standing - state.root.p_WS.z);
  double flexion = 0.0;
  for (const Dof dof : {Dof::kVl5Flexion, Dof::kVl1Flexion, Dof::kVt6Flexion}) flexion += state.angles[indexOf(dof)];
  const double pitch = kPitchShare * flexion;
  const dvec3 lateral = glm::cross(dvec3(0, 0, 1), forward);
  const dvec3 x = std::cos(pitch) * forward - std::sin(pitch) * dvec3(0, 0, 1);
  const dmat3 wanted(x, lateral, glm::cross(x, lateral));
  const dvec3 turn = rotationVector(glm::quat_cast(wanted * glm::transpose(state.root.R_WS)));
  for (std::size_t k = 0; k < 3; ++k) wish[3 + k] = share * turn[static_cast<int>(k)];
}

}  // namespace

void wishComfort(const Figure& figure, const ResolvedTask& task, const BodyState& state, const FigurePose& pose,
                 const VariableAxes& axes, double share, Variables& wish) {
  if (!task.pelvis_locked) wishPelvis(figure, task, state, pose, share, wish);
  for (std::size_t i = 0; i < 9; ++i) wish[kSpineVariable + i] = -share * state.angles[i];
  for (const Side side : {Side::kLeft, Side::kRight}) {
    wishGirdle(figure, side, state, pose, share, wish);
    if (task.has_hand[static_cast<std::size_t>(side)]) wishArm(figure, side, state, pose, axes, share, wish);
  }
}

}  // namespace hapticell::mannequin
