// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/body_solver.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// m that a foot may leave its place on the way, a fifth of a mm that the last steps put back. Half: more steps are
/// refused; twice: feet slide visibly while dragging (the target is 0.3 mm).
constexpr double kFootSlack = 2e-4;

dvec3 turnBetween(const dmat3& R_to, const dmat3& R_from) {
  return rotationVector(glm::quat_cast(R_to * glm::transpose(R_from)));
}

double square(const dvec3& v) {
  return glm::dot(v, v);
}

/// Mass and first moment of everything that each segment carries.
SegmentPlace placeOf(const Pose& X) {
  return {glm::mat3_cast(X.q), X.p};
}

}  // namespace

ResolvedTask resolve(const Figure& figure, const PostureTask& task, const FigurePose& start) {
  ResolvedTask r;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    r.feet[i] = task.feet[i] ? placeOf(*task.feet[i]) : start[legSegment(side, S::kLeftFoot)];
    r.has_orientation[i] = task.orientation[i] || task.held.has_value();
    if (task.held) {
      r.has_hand[i] = true;
      r.hands[i] = placeOf(task.held->X_WO * task.held->X_OH[i]);
    } else if (task.hands[i]) {
      r.has_hand[i] = true;
      r.hands[i] = placeOf(*task.hands[i]);
      if (!r.has_orientation[i]) r.hands[i].R_WS = start[armSegment(side, S::kLeftHand)].R_WS;
    }
  }
  r.held = task.held.has_value();
  if (r.held) r.left_to_right = placeOf(task.held->X_OH[0].inverse() * task.held->X_OH[1]);
  r.support = supportPolygon(figure, r.feet);
  r.trunk_locked = task.trunk_locked;
  r.pelvis_locked = task.pelvis_locked || task.trunk_locked;
  r.balance = task.balance;
  r.balance_margin = task.balance_margin;
  r.loads = task.loads;
  return r;
}

bool TaskErrors::solved() const {
  const double degree = kDegree;
  return hand_position[0] < 1e-3 && hand_position[1] < 1e-3 && hand_orientation[0] < 0.5 * degree &&
         hand_orientation[1] < 0.5 * degree && foot_position < 3e-4 && balance > -1e-3;
}

void BodySolver::set(const BodyState& state) {
  state_ = state;
  active_ = {};
  placeSegments(*figure_, state_, pose_);
  measure();
}

void BodySolver::measure() {
  errors_.merit = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Side side = static_cast<Side>(i);
    errors_.hand_position[i] = errors_.hand_orientation[i] = 0.0;
    if (task_->has_hand[i]) {
      const SegmentPlace& hand = pose_[armSegment(side, S::kLeftHand)];
      SegmentPlace wanted = task_->hands[i];
      if (task_->held && i == 1) {
        const SegmentPlace& left = pose_[S::kLeftHand];
        wanted = {left.R_WS * task_->left_to_right.R_WS, left.point(task_->left_to_right.p_WS)};
      }
      errors_.hand[i] = wanted.p_WS - hand.p_WS;
      errors_.hand_turn[i] = task_->has_orientation[i] ? turnBetween(wanted.R_WS, hand.R_WS) : dvec3(0.0);
      errors_.hand_position[i] = glm::length(errors_.hand[i]);
      errors_.hand_orientation[i] = glm::length(errors_.hand_turn[i]);
      const double weight = task_->held && i == 1 ? 1e3 : 1.0;
      errors_.merit += weight * (square(errors_.hand[i]) + kLever * kLever * square(errors_.hand_turn[i]));
    }
    const SegmentPlace& foot = pose_[legSegment(side, S::kLeftFoot)];
    errors_.foot[i] = task_->feet[i].p_WS - foot.p_WS;
    errors_.foot_turn[i] = turnBetween(task_->feet[i].R_WS, foot.R_WS);
    errors_.merit += 1e3 * (square(errors_.foot[i]) + kLever * kLever * square(errors_.foot_turn[i]));
  }
  errors_.relative_position = task_->held ? errors_.hand_position[1] : 0.0;
  errors_.relative_orientation = task_->held ? errors_.hand_orientation[1] : 0.0;
  errors_.foot_position = std::max(glm::length(errors_.foot[0]), glm::length(errors_.foot[1]));
  errors_.p_WCom = centerOfMass(*figure_, pose_, task_->loads);
  errors_.balance = task_->balance ? task_->support.margin(glm::dvec2(errors_.p_WCom)) - task_->balance_margin : 0.0;
  const double outside = std::max(0.0, -errors_.balance);
  errors_.merit += balance_weight_ * outside * outside;
}

void placeFeet(const Figure& figure, const std::array<SegmentPlace, 2>& feet, BodyState& state) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const LegAngles leg = legInverse(figure, side, state.root, feet[static_cast<std::size_t>(side)]);
    if (leg.violation == 0.0 && leg.missing < 1e-9) setLeg(state, side, leg);
  }
}

bool BodySolver::step(const StepLimits& limits) {
  ++iterations_;
  VariableAxes axes;
  findAxes(state_, pose_, axes);
  StepProblem problem;
  fillProblem(axes, limits, problem);
  Variables move{};
  solveStep(problem, active_, move);
  const BodyState before = state_;
  const FigurePose pose_before = pose_;
  const TaskErrors errors_before = errors_;
  applyStep(move, axes, state_);
  placeFeet(*figure_, task_->feet, state_);
  placeSegments(*figure_, state_, pose_);
  // A held object is judged as it will be held: by the right arm's closed form where that can.
  if (!task_->held || !bindHeld()) measure();
  // Comfort may cost what is below any tolerance; a task may not.
  const double allowed = limits.comfort > 0.0 ? limits.slack : 1e-18;
  const bool strict = balance_weight_ == kStrictBalance;
  const bool feet_stand = !strict || errors_.foot_position <= std::max(kFootSlack, errors_before.foot_position);
  if (feet_stand && errors_.merit <= errors_before.merit + allowed) return true;
  state_ = before;
  pose_ = pose_before;
  errors_ = errors_before;
  return false;
}

void BodySolver::run(int most, StepLimits limits, bool impatient) {
  double milestone = errors_.merit;
  const double widest = limits.turn;
  for (int i = 1; i <= most && !errors_.solved(); ++i) {
    const double before = errors_.merit;
    if (step(limits)) {
      limits.lambda = std::max(1e-6, limits.lambda * (errors_.merit < 0.25 * before ? 0.2 : 0.7));
      limits.turn = std::min(widest, 1.5 * limits.turn);
    } else {
      limits.lambda = std::min(1.0, 6.0 * limits.lambda);
      limits.turn *= 0.5;
    }
    if (impatient && (i == 8 || i == 14 || i == 20)) {
      if (errors_.merit > 0.25 * milestone) return;
      milestone = errors_.merit;
    }
  }
}

void BodySolver::finishArms() {
  const BodyState before = state_;
  bool changed = false;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!task_->has_hand[i] || !task_->has_orientation[i]) continue;
    const Side side = static_cast<Side>(i);
    const ArmProblem problem(*figure_, side, pose_[S::kThorax], pose_[armSegment(side, S::kLeftClavicle)],
                             task_->hands[i]);
    const ArmAngles arm = problem.at(problem.swivelOf(pose_[armSegment(side, S::kLeftForearm)].p_WS));
    if (arm.violation > 0.0 || arm.missing > 1e-9) continue;
    setArm(state_, side, arm);
    changed = true;
  }
  if (!changed) return;
  const FigurePose pose_before = pose_;
  const TaskErrors errors_before = errors_;
  placeSegments(*figure_, state_, pose_);
  measure();
  if (errors_.merit <= errors_before.merit + 1e-12) return;
  state_ = before;
  pose_ = pose_before;
  errors_ = errors_before;
}

bool BodySolver::bindHeld() {
  const SegmentPlace& left = pose_[S::kLeftHand];
  const SegmentPlace wanted{left.R_WS * task_->left_to_right.R_WS, left.point(task_->left_to_right.p_WS)};
  const ArmProblem problem(*figure_, Side::kRight, pose_[S::kThorax], pose_[S::kRightClavicle], wanted);
  const ArmAngles arm = problem.at(problem.swivelOf(pose_[S::kRightForearm].p_WS));
  if (arm.violation > 0.0 || arm.missing > 1e-9) return false;
  setArm(state_, Side::kRight, arm);
  placeSegments(*figure_, state_, pose_);
  measure();
  return true;
}

}  // namespace hapticell::mannequin
