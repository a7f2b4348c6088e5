// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/body_state.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

constexpr std::array<Dof, 4> kBallDofs = {Dof::kLeftShoulderFlexion, Dof::kRightShoulderFlexion, Dof::kLeftHipFlexion,
                                          Dof::kRightHipFlexion};

struct BallPlace {
  BallJoint joint;
  Side side;
  Segment segment, parent;
  int variable;
};
constexpr std::array<BallPlace, 4> kBalls = {{
    {BallJoint::kShoulder, Side::kLeft, S::kLeftUpperArm, S::kLeftClavicle, 17},
    {BallJoint::kShoulder, Side::kRight, S::kRightUpperArm, S::kRightClavicle, 26},
    {BallJoint::kHip, Side::kLeft, S::kLeftThigh, S::kPelvis, 33},
    {BallJoint::kHip, Side::kRight, S::kRightThigh, S::kPelvis, 39},
}};

/// Which joint angle a variable is; -1 for the root and the ball joints.
constexpr std::array<int, kVariables> makeDofs() {
  std::array<int, kVariables> dofs{};
  for (int& d : dofs) d = -1;
  for (int i = 0; i < 9; ++i) dofs[static_cast<std::size_t>(kSpineVariable + i)] = i;
  constexpr int kArm[9] = {0, 1, -1, -1, -1, 5, 6, 7, 8};
  constexpr int kLeg[6] = {-1, -1, -1, 3, 4, 5};
  for (int side = 0; side < 2; ++side) {
    for (int i = 0; i < 9; ++i) {
      if (kArm[i] >= 0) dofs[static_cast<std::size_t>(kArmVariable + 9 * side + i)] = 18 + 12 * side + kArm[i];
    }
    for (int i = 0; i < 6; ++i) {
      if (kLeg[i] >= 0) dofs[static_cast<std::size_t>(kLegVariable + 6 * side + i)] = 42 + 7 * side + kLeg[i];
    }
  }
  return dofs;
}
constexpr std::array<int, kVariables> kDofOfVariable = makeDofs();

/// R after a turn of the rotation vector w (in the frame that R maps to), kept orthonormal.
dmat3 turned(const dvec3& w, const dmat3& R) {
  return glm::mat3_cast(glm::normalize(quaternionFromRotationVector(w) * glm::quat_cast(R)));
}

void findSpineAxes(const BodyState& state, const FigurePose& pose, VariableAxes& axes) {
  constexpr std::array<Segment, 4> kChain = {S::kPelvis, S::kLowerBack, S::kUpperBack, S::kThorax};
  for (std::size_t j = 0; j < 3; ++j) {
    const SegmentPlace &parent = pose[kChain[j]], &segment = pose[kChain[j + 1]];
    const double flexion = state.angles[3 * j];
    const std::size_t v = static_cast<std::size_t>(kSpineVariable) + 3 * j;
    axes.axis[v] = parent.R_WS[1];
    axes.axis[v + 1] = std::cos(flexion) * parent.R_WS[0] - std::sin(flexion) * parent.R_WS[2];
    axes.axis[v + 2] = segment.R_WS[2];
    for (std::size_t k = 0; k < 3; ++k) axes.origin[v + k] = segment.p_WS;
  }
}

void findArmAxes(const FigurePose& pose, Side side, VariableAxes& axes) {
  const double out = outwardSign(side);
  const std::size_t v = static_cast<std::size_t>(armVariable(side));
  const auto place = [&](Segment left) -> const SegmentPlace& { return pose[armSegment(side, left)]; };
  const auto set = [&](std::size_t k, const dvec3& axis, const dvec3& origin) {
    axes.axis[v + k] = axis;
    axes.origin[v + k] = origin;
  };
  set(0, out * pose[S::kThorax].R_WS[0], place(S::kLeftClavicle).p_WS);
  set(1, -out * place(S::kLeftClavicle).R_WS[2], place(S::kLeftClavicle).p_WS);
  set(5, -place(S::kLeftUpperArm).R_WS[1], place(S::kLeftForearm).p_WS);
  set(6, -out * place(S::kLeftForearm).R_WS[2], place(S::kLeftWrist).p_WS);
  set(7, -out * place(S::kLeftHand).R_WS[0], place(S::kLeftHand).p_WS);
  set(8, place(S::kLeftWrist).R_WS[1], place(S::kLeftHand).p_WS);
}

void findLegAxes(const FigurePose& pose, Side side, VariableAxes& axes) {
  const double out = outwardSign(side);
  const std::size_t v = static_cast<std::size_t>(legVariable(side));
  const auto place = [&](Segment left) -> const SegmentPlace& { return pose[legSegment(side, left)]; };
  axes.axis[v + 3] = place(S::kLeftThigh).R_WS[1];
  axes.origin[v + 3] = place(S::kLeftShank).p_WS;
  axes.axis[v + 4] = place(S::kLeftShank).R_WS[1];
  axes.axis[v + 5] = -out * place(S::kLeftFoot).R_WS[0];
  axes.origin[v + 4] = axes.origin[v + 5] = place(S::kLeftFoot).p_WS;
}

}  // namespace

BodyState stateOf(const Posture& posture) {
  BodyState state;
  state.root = {glm::mat3_cast(posture.X_WR.q), posture.X_WR.p};
  state.angles = posture.angles;
  for (std::size_t i = 0; i < 4; ++i) state.balls[i] = ballRotationOf(posture, kBallDofs[i]);
  return state;
}

Posture postureOf(const BodyState& state, const Gaze& gaze) {
  Posture posture;
  posture.X_WR = state.root.pose();
  posture.angles = state.angles;
  posture.gaze = gaze;
  for (std::size_t i = 0; i < 4; ++i) setBallRotation(posture, kBallDofs[i], state.balls[i]);
  return posture;
}

void placeSegments(const Figure& figure, const BodyState& state, FigurePose& pose) {
  SineCosine sc;
  sinesAndCosines(state.angles, sc);
  pose[S::kPelvis] = state.root;
  placeSegments(figure, sc, state.balls, pose);
}

void setLeg(BodyState& state, Side side, const LegAngles& leg) {
  state.balls[side == Side::kLeft ? 2 : 3] = leg.R_PelvisThigh;
  state.angles[indexOf(legDof(side, Dof::kLeftKneeFlexion))] = leg.knee;
  state.angles[indexOf(legDof(side, Dof::kLeftAnklePlantarFlexion))] = leg.plantar_flexion;
  state.angles[indexOf(legDof(side, Dof::kLeftAnkleInversion))] = leg.inversion;
}

void setArm(BodyState& state, Side side, const ArmAngles& arm) {
  state.balls[side == Side::kLeft ? 0 : 1] = arm.R_ClavicleUpperArm;
  state.angles[indexOf(armDof(side, Dof::kLeftElbowFlexion))] = arm.elbow;
  state.angles[indexOf(armDof(side, Dof::kLeftPronation))] = arm.pronation;
  state.angles[indexOf(armDof(side, Dof::kLeftWristFlexion))] = arm.wrist_flexion;
  state.angles[indexOf(armDof(side, Dof::kLeftWristUlnarDeviation))] = arm.wrist_ulnar;
}

std::optional<Dof> dofOfVariable(int variable) {
  const int dof = kDofOfVariable[static_cast<std::size_t>(variable)];
  return dof < 0 ? std::nullopt : std::optional(static_cast<Dof>(dof));
}

void findAxes(const BodyState& state, const FigurePose& pose, VariableAxes& axes) {
  for (std::size_t k = 0; k < 3; ++k) {
    dvec3 unit(0.0);
    unit[static_cast<int>(k)] = 1.0;
    axes.axis[k] = axes.axis[k + 3] = unit;
    axes.origin[k + 3] = pose[S::kPelvis].p_WS;
  }
  findSpineAxes(state, pose, axes);
  for (std::size_t i = 0; i < 4; ++i) {
    const BallPlace& ball = kBalls[i];
    axes.balls[i] = ballAxes(ball.joint, ball.side, state.balls[i]);
    const dmat3& R = pose[ball.parent].R_WS;
    const std::size_t v = static_cast<std::size_t>(ball.variable);
    axes.axis[v] = R * axes.balls[i].cone;
    axes.axis[v + 1] = R * axes.balls[i].free;
    axes.axis[v + 2] = R * axes.balls[i].bone;
    for (std::size_t k = 0; k < 3; ++k) axes.origin[v + k] = pose[ball.segment].p_WS;
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    findArmAxes(pose, side, axes);
    findLegAxes(pose, side, axes);
  }
}

void applyStep(const Variables& step, const VariableAxes& axes, BodyState& state) {
  state.root.p_WS += dvec3(step[0], step[1], step[2]);
  state.root.R_WS = turned({step[3], step[4], step[5]}, state.root.R_WS);
  for (std::size_t v = 0; v < kVariables; ++v) {
    if (kDofOfVariable[v] < 0) continue;
    const DofInfo& info = dofInfo(static_cast<Dof>(kDofOfVariable[v]));
    double& angle = state.angles[static_cast<std::size_t>(kDofOfVariable[v])];
    angle = std::clamp(angle + step[v], info.lower, info.upper);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t v = static_cast<std::size_t>(kBalls[i].variable);
    if (step[v] == 0.0 && step[v + 1] == 0.0 && step[v + 2] == 0.0) continue;
    const BallAxes& ball = axes.balls[i];
    // Bone's turn counts internal positive, which is about the bone on the left and against it on the right; the axes
    // are mirrored already, so a plain sum is right on both sides.
    state.balls[i] = turned(step[v] * ball.cone + step[v + 1] * ball.free + step[v + 2] * ball.bone, state.balls[i]);
    state.balls[i] = clampBall(kBalls[i].joint, kBalls[i].side, state.balls[i]);
  }
}

}  // namespace hapticell::mannequin
