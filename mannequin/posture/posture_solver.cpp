// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/posture_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mannequin/body/rotations.h"
#include "mannequin/posture/body_solver.h"
#include "mannequin/posture/posture_seeds.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// Cost of closed-form arms below which the present trunk is worth a try; by trial. Half: trunks move where arms would
/// do; twice: tries for nothing.
constexpr double kGoodArms = 0.25;
/// m^2 (55 mm): the start itself is nearly there. By trial. Half: other trunks are tried for small motions; twice:
/// tries for nothing.
constexpr double kNearMerit = 0.003;
// Steps from a seed; by trial. Half: good seeds fail and the next is tried; twice: seeds that fail cost twice the time.
constexpr int kPolishSteps = 20;
/// Steps where all else failed, twice kPolishSteps. Half: goals at the edge are missed; twice: twice the time for what
/// is out of reach.
constexpr int kLastSteps = 40;
// Steps of comfort up to which the short way without going back is taken. Half, twice: no effect on longer requests.
constexpr int kBriefSteps = 2;
/// m^2, 20 mm: what closed-form arms make good again. Half: comfort comes in smaller steps; twice: more steps are taken
/// back.
constexpr double kComfortSlack = 4e-4;
/// rad an iteration; three make a tick, 1.8 deg a joint, so that nothing jumps (docs/dev/mannequin.md). Half: a fast
/// hand leaves the figure behind; twice: jumps are seen.
constexpr double kTickTurn = 0.6 * kDegree;
constexpr double kMostTickTurn = 1.8 * kDegree;
// Of the arm's length: elbows bent by 20 deg, and by 1.6: a bit off the singular pose. Half the rest: swivels are
// sought for nearly straight arms; twice: arms end shorter.
constexpr double kComfortableStretch = 0.985, kStraight = 0.9999;
/// Of the way to the hand that arms alone go in a tick. Half: arms creep where the trunk would help; twice: the whole
/// body moves sooner.
constexpr double kLeastTickShare = 0.05;
// Turn of a step (twice a tick's), regularisation, share of the way to comfort. Half: a figure relaxes half as fast;
// twice: it jumps.
constexpr StepLimits kRelaxing{1.2 * kDegree, 1e-2, 0.5};
// Halvings of a step: to a 64th. Half: it stops relaxing earlier; twice: time for steps that are not seen.
constexpr int kRefusals = 6;

PostureResult resultOf(const BodySolver& solver, const Posture& start, const FigurePose& start_pose,
                       const ResolvedTask& task) {
  PostureResult result;
  const TaskErrors& errors = solver.errors();
  result.posture = postureOf(solver.state(), start.gaze);
  result.status = errors.solved() ? PostureStatus::kSolved : PostureStatus::kOutOfReach;
  result.hand_position_error = errors.hand_position;
  result.hand_orientation_error = errors.hand_orientation;
  if (task.held) {
    // What counts for the user is where the object is: the right hand's error is that of its own wanted pose.
    const SegmentPlace& right = solver.pose()[S::kRightHand];
    result.hand_position_error[1] = glm::length(task.hands[1].p_WS - right.p_WS);
    result.hand_orientation_error[1] =
        glm::length(rotationVector(glm::quat_cast(task.hands[1].R_WS * glm::transpose(right.R_WS))));
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const S foot = legSegment(side, S::kLeftFoot);
    result.foot_displacement =
        std::max(result.foot_displacement, glm::length(solver.pose()[foot].p_WS - start_pose[foot].p_WS));
  }
  result.p_WCom = errors.p_WCom;
  result.balance_margin = task.support.margin(glm::dvec2(errors.p_WCom));
  result.iterations = solver.iterations();
  return result;
}

/// After a solution, where it must be quick: a few steps that hardly leave it, then the hands exactly.
void makeBriefly(const ResolvedTask& task, int steps, BodySolver& solver) {
  const BodyState solved = solver.state();
  for (int i = 0; i < steps; ++i) solver.step({0.4, 1e-5, 0.5});
  solver.finishArms();
  if (task.held) solver.bindHeld();
  if (!solver.errors().solved()) solver.set(solved);
}

/// After a solution: steps towards comfort, the hands put back by their closed form after each; one after which the
/// task is not met is taken back and the next is smaller.
void makeComfortable(const ResolvedTask& task, int steps, BodySolver& solver) {
  if (steps <= kBriefSteps) return makeBriefly(task, steps, solver);
  StepLimits limits{0.4, 1e-5, 1.0, kComfortSlack};
  for (int i = 0; i < steps && limits.comfort > 0.1; ++i) {
    const BodySolver before = solver;
    const bool moved = solver.step(limits);
    solver.finishArms();
    if (task.held) solver.bindHeld();
    if (moved && solver.errors().solved()) continue;
    const int iterations = solver.iterations();
    solver = before;
    solver.count(iterations);
    limits.turn *= 0.5;
    limits.comfort *= 0.5;
  }
}

/// A held object must not slip in the hands: bind them, with more steps where the arm alone cannot.
void closeHeld(BodySolver& solver) {
  for (int i = 0; i < 12 && !solver.bindHeld(); ++i) solver.step({0.2, 1e-2, 0.0});
}

}  // namespace

PostureResult PostureSolver::solve(const PostureTask& task, const Posture& start) const {
  const FigurePose start_pose = forwardKinematics(*figure_, start);
  ResolvedTask resolved = resolve(*figure_, task, start_pose);
  BodySolver solver(*figure_, resolved), best(*figure_, resolved);
  int tries = 0, iterations = 0;
  const auto attempt = [&](const BodyState& state, int steps) {
    ++tries;
    solver.set(state);
    const int before = solver.iterations();
    solver.run(steps, {0.6, 1e-3, 0.0}, true);
    iterations += solver.iterations() - before;
    if (tries == 1 || solver.errors().merit < best.errors().merit) best = solver;
    return best.errors().solved();
  };
  const BodyState present = stateOf(start);
  const SeededState near = withArms(*figure_, resolved, present, 24);
  solver.set(present);
  bool done = solver.errors().merit < kNearMerit && attempt(present, kPolishSteps);
  done = done || (near.cost < kGoodArms && attempt(near.state, kPolishSteps));
  if (!done && !task.trunk_locked) {
    PostureSeeds seeds(*figure_, resolved, present);
    for (const BodyState* seed = seeds.next(); seed && !done; seed = done ? nullptr : seeds.next()) {
      done = attempt(*seed, kPolishSteps);
    }
  }
  if (!done) {
    const bool start_helps = tries == 0 || task.trunk_locked || (resolved.has_hand[0] && resolved.has_hand[1]);
    done = (tries > 0 && attempt(BodyState(best.state()), kLastSteps)) ||
           (start_helps && (attempt(near.state, kLastSteps) || attempt(present, kLastSteps)));
    if (!done) {
      best.setBalanceWeight(BodySolver::kStrictBalance);
      solver = best;
      const int before = solver.iterations();
      solver.run(kLastSteps, {0.3, 1e-3, 0.0}, false);
      iterations += solver.iterations() - before;
      if (solver.errors().merit < best.errors().merit) best = solver;
    }
  }
  if (best.errors().solved()) makeComfortable(resolved, task.comfort_steps, best);
  if (resolved.held) closeHeld(best);
  PostureResult result = resultOf(best, start, start_pose, resolved);
  result.iterations = iterations;
  result.tries = tries;
  if (result.status != PostureStatus::kSolved && task.may_step) {
    PostureTask stepped = task;
    stepped.may_step = false;
    const Posture moved = steppedTowards(*figure_, task, start);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      stepped.feet[static_cast<std::size_t>(side)] = footPose(forwardKinematics(*figure_, moved), side);
    }
    PostureResult after = solve(stepped, moved);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const S foot = legSegment(side, S::kLeftFoot);
      const dvec3 there = forwardKinematics(*figure_, after.posture)[foot].p_WS;
      after.foot_displacement = std::max(after.foot_displacement, glm::length(there - start_pose[foot].p_WS));
    }
    if (after.status == PostureStatus::kSolved) return after;
  }
  return result;
}

namespace {

SegmentPlace between(const SegmentPlace& from, const SegmentPlace& to, double share) {
  const dvec3 turn = rotationVector(glm::quat_cast(to.R_WS * glm::transpose(from.R_WS)));
  return {glm::mat3_cast(quaternionFromRotationVector(share * turn)) * from.R_WS,
          from.p_WS + share * (to.p_WS - from.p_WS)};
}

/// How an arm meets its hand from the present trunk, its elbow going by `swing` (rad) at most towards where it likes to
/// be; nothing where it had to stretch farther than `longest` (of its length), or its limits do not let it.
std::optional<ArmAngles> armTo(const Figure& figure, Side side, const FigurePose& pose, const SegmentPlace& hand,
                               double longest, double swing) {
  const ArmProblem problem(figure, side, pose[S::kThorax], pose[armSegment(side, S::kLeftClavicle)], hand);
  if (problem.stretch() > longest) return std::nullopt;
  double swivel = problem.swivelOf(pose[armSegment(side, S::kLeftForearm)].p_WS);
  if (swing > 0.0) {
    const double wish = std::remainder(problem.preferredSwivelNear(swivel, 0.35) - swivel, 2.0 * std::numbers::pi);
    swivel += std::clamp(wish, -swing, swing);
  }
  const ArmAngles arm = problem.at(swivel);
  if (arm.violation > 0.0 || arm.missing > 1e-9) return std::nullopt;
  return arm;
}

/// Distance from the shoulder to where the wrist is, or would be, over the arm's length.
double stretchTo(const Figure& figure, Side side, const FigurePose& pose, const SegmentPlace& hand) {
  const dvec3 arm = hand.p_WS - pose[armSegment(side, S::kLeftUpperArm)].p_WS;
  return glm::length(arm) / (figure.upperArmLength() + figure.forearmLength());
}

/// The most that a joint of the arm turns, as a share of what a tick allows.
double turnsOfATick(const BodyState& state, Side side, const ArmAngles& arm) {
  const dmat3& R = state.balls[static_cast<std::size_t>(side)];
  const double turned = glm::length(rotationVector(glm::quat_cast(arm.R_ClavicleUpperArm * glm::transpose(R))));
  const double flexed = arm.elbow - state.angles[indexOf(armDof(side, Dof::kLeftElbowFlexion))];
  const double rolled = arm.pronation - state.angles[indexOf(armDof(side, Dof::kLeftPronation))];
  return std::max({turned, std::abs(flexed), std::abs(rolled) / 3.0}) / kMostTickTurn;
}

/// Hands met by the arms alone, each joint turning no more than a tick allows. One that is drawn in may be met in
/// part: a nearly straight arm must bend far for little, and the trunk would else bend for it. False when arms alone do
/// not do.
bool followWithArms(const Figure& figure, const ResolvedTask& task, BodySolver& solver) {
  BodyState state = solver.state();
  const FigurePose& pose = solver.pose();
  for (std::size_t i = 0; i < 2; ++i) {
    if (!task.has_hand[i]) continue;
    if (!task.has_orientation[i]) return false;
    const Side side = static_cast<Side>(i);
    const SegmentPlace& hand = pose[armSegment(side, S::kLeftHand)];
    const double stretch = stretchTo(figure, side, pose, hand);
    const double longest = std::clamp(stretch, kComfortableStretch, kStraight);
    const double wanted_stretch = stretchTo(figure, side, pose, task.hands[i]);
    const bool drawn_in = wanted_stretch < stretch;
    // Hardly bent, an elbow has no swivel worth looking for.
    const double swing = wanted_stretch <= kComfortableStretch ? 0.5 * kDegree : 0.0;
    std::optional<ArmAngles> arm = armTo(figure, side, pose, task.hands[i], longest, swing);
    double share = 1.0;
    while (arm) {
      const double turns = turnsOfATick(state, side, *arm);
      if (turns <= 1.0) break;
      share *= std::min(0.5, 0.9 / turns);
      if (!drawn_in || share < kLeastTickShare) return false;
      arm = armTo(figure, side, pose, between(hand, task.hands[i], share), kStraight, 0.0);
    }
    if (!arm) return false;
    setArm(state, side, *arm);
  }
  BodySolver moved = solver;
  moved.set(state);
  if (moved.errors().balance < -1e-4 && moved.errors().balance < solver.errors().balance) return false;
  if (moved.errors().merit > solver.errors().merit) return false;
  solver = moved;
  return true;
}

}  // namespace

PostureResult PostureSolver::follow(const PostureTask& task, const Posture& from) const {
  const FigurePose start_pose = forwardKinematics(*figure_, from);
  const ResolvedTask resolved = resolve(*figure_, task, start_pose);
  BodySolver solver(*figure_, resolved);
  solver.set(stateOf(from));
  solver.setBalanceWeight(BodySolver::kStrictBalance);
  const BodyState before = solver.state();
  if (resolved.held || !followWithArms(*figure_, resolved, solver)) {
    StepLimits limits{kTickTurn, 1e-4, 0.02};
    for (int i = 0; i < 3; ++i) {
      if (solver.step(limits)) continue;
      limits = {0.5 * limits.turn, 6.0 * limits.lambda, 0.0};
    }
  }
  if (resolved.held && !solver.bindHeld()) {
    for (int i = 0; i < 5 && solver.errors().relative_position > 1e-9; ++i) solver.step({kTickTurn, 1e-1, 0.0});
    const bool slipped = solver.errors().relative_position > 5e-7 || solver.errors().relative_orientation > 5e-7;
    if (slipped) solver.set(before);
  }
  return resultOf(solver, from, start_pose, resolved);
}

PostureResult PostureSolver::relax(const PostureTask& task, const Posture& from) const {
  PostureTask loose = task;
  loose.held.reset();
  loose.hands = {};
  const FigurePose start_pose = forwardKinematics(*figure_, from);
  const ResolvedTask resolved = resolve(*figure_, loose, start_pose);
  BodySolver solver(*figure_, resolved);
  solver.set(stateOf(from));
  StepLimits limits = kRelaxing;
  for (int taken = 0, refused = 0; taken < 3 && refused < kRefusals;) {
    if (solver.step(limits)) {
      ++taken;
      continue;
    }
    ++refused;
    limits.turn *= 0.5;
    limits.comfort *= 0.5;
  }
  return resultOf(solver, from, start_pose, resolved);
}

}  // namespace hapticell::mannequin
