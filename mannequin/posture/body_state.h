// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mannequin/body/joint_limits.h"
#include "mannequin/posture/limb_inverse.h"
#include "mannequin/posture/segment_places.h"

namespace hapticell::mannequin {

/// The solver's representation of a posture: ball joints as matrices, so that no posture is singular. The three angles
/// of a ball joint in `angles` are not up to date.
struct BodyState {
  SegmentPlace root;
  JointAngles angles{};
  BallRotations balls{};
};

BodyState stateOf(const Posture& posture);
Posture postureOf(const BodyState& state, const Gaze& gaze);
void placeSegments(const Figure& figure, const BodyState& state, FigurePose& pose);

void setLeg(BodyState& state, Side side, const LegAngles& leg);
void setArm(BodyState& state, Side side, const ArmAngles& arm);

/// The variables of the whole-body solve: root 6, spine 9, arms 2 x 9, legs 2 x 6. Neck, fingers and toes follow rules
/// of their own.
inline constexpr int kVariables = 45;
inline constexpr int kRootVariable = 0, kSpineVariable = 6, kArmVariable = 15, kLegVariable = 33;
constexpr int armVariable(Side side) {
  return side == Side::kLeft ? kArmVariable : kArmVariable + 9;
}
constexpr int legVariable(Side side) {
  return side == Side::kLeft ? kLegVariable : kLegVariable + 6;
}

using Variables = std::array<double, kVariables>;

/// The joint angle of a variable; empty for the root and the rotations of ball joints.
std::optional<Dof> dofOfVariable(int variable);

/// Axes that the variables turn about (or, for the first three, move along), in the world.
struct VariableAxes {
  std::array<dvec3, kVariables> axis{};
  std::array<dvec3, kVariables> origin{};
  std::array<BallAxes, 4> balls{};
};
void findAxes(const BodyState& state, const FigurePose& pose, VariableAxes& axes);

/// Moves the state by `step` and brings every joint exactly inside its hard limits.
void applyStep(const Variables& step, const VariableAxes& axes, BodyState& state);

}  // namespace hapticell::mannequin
