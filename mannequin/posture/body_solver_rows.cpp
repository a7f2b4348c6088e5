// SPDX-License-Identifier: Apache-2.0
// What a step of the solver is asked: rows for hands, feet and balance, bounds and weights of the variables.
#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"
#include "mannequin/posture/body_solver.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

// Priorities: held object before feet before balance before hands, a decade apart (docs/dev/mannequin.md). Half, twice:
// the order stays; nearer than that they share what cannot be met.
constexpr double kFootRegularisation = 1e-8, kBalanceRegularisation = 1e-7, kHeldRegularisation = 1e-9;
/// m inside the margin where an edge of the soles is already a row, so that no step jumps over it. By trial. Half: more
/// steps over the edge that the next takes back; twice: rows that are not needed take time.
constexpr double kEdgeZone = 0.004;
// m, rad of the error that a step is asked for: the linear model is good for about so much. Half: more iterations from
// far; twice: steps that are refused.
constexpr double kMostPull = 0.25, kMostTurn = 1.0;

/// Weights of the variables: how unwilling each is to move.
constexpr Variables makeWeights() {
  Variables D{};
  for (std::size_t i = 0; i < kVariables; ++i) {
    D[i] = 0.3;
    if (i < 15) D[i] = 3.0;
    if (i < 6) D[i] = 4.0;
    if (i < 3) D[i] = 14.0;
    if (i >= 15 && i < 33) {
      constexpr double kArm[9] = {3.0, 3.0, 0.8, 0.8, 0.8, 0.8, 0.5, 1.0, 1.0};
      D[i] = kArm[(i - 15) % 9];
    }
  }
  return D;
}
constexpr Variables kWeights = makeWeights();

struct Subtrees {
  std::array<double, kSegmentCount> mass{};
  std::array<dvec3, kSegmentCount> moment{};
};

Subtrees subtreesOf(const Figure& figure, const FigurePose& pose, const std::array<HandLoad, 2>& loads) {
  Subtrees trees;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    trees.mass[i] = figure.mass[i];
    trees.moment[i] = figure.mass[i] * pose.segments[i].point(figure.p_SC[i]);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t hand = indexOf(armSegment(side, S::kLeftHand));
    const HandLoad& load = loads[static_cast<std::size_t>(side)];
    trees.mass[hand] += load.mass;
    trees.moment[hand] += load.mass * pose.segments[hand].point(load.p_HC);
  }
  for (std::size_t i = kSegmentCount - 1; i > 0; --i) {
    const std::size_t parent = indexOf(*segmentInfo(static_cast<Segment>(i)).parent);
    trees.mass[parent] += trees.mass[i];
    trees.moment[parent] += trees.moment[i];
  }
  return trees;
}

/// The segment that each variable turns.
constexpr std::array<Segment, kVariables> makeTurned() {
  std::array<Segment, kVariables> turned{};
  for (std::size_t i = 0; i < 6; ++i) turned[i] = S::kPelvis;
  for (std::size_t i = 6; i < 15; ++i) turned[i] = static_cast<Segment>(1 + (i - 6) / 3);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t a = 15 + 9 * side, l = 33 + 6 * side;
    constexpr std::size_t kArm[9] = {7, 7, 8, 8, 8, 9, 10, 11, 11};
    constexpr std::size_t kLeg[6] = {17, 17, 17, 18, 19, 19};
    for (std::size_t i = 0; i < 9; ++i) turned[a + i] = static_cast<Segment>(kArm[i] + 5 * side);
    for (std::size_t i = 0; i < 6; ++i) turned[l + i] = static_cast<Segment>(kLeg[i] + 4 * side);
  }
  return turned;
}
constexpr std::array<Segment, kVariables> kTurned = makeTurned();

/// Six rows of a point's motion (and its frame's turn, with the lever) from one variable.
void fillRows(const VariableAxes& axes, int variable, const dvec3& point, double* rows) {
  const std::size_t v = static_cast<std::size_t>(variable);
  const dvec3 axis = axes.axis[v];
  const dvec3 velocity = variable < 3 ? axis : glm::cross(axis, point - axes.origin[v]);
  for (int k = 0; k < 3; ++k) rows[k] = velocity[k];
  for (int k = 0; k < 3; ++k) rows[k + 3] = variable < 3 ? 0.0 : kLever * axis[k];
}

}  // namespace

void BodySolver::fillHands(const VariableAxes& axes, double lambda, StepProblem& problem) const {
  for (std::size_t i = 0; i < 2; ++i) {
    const int first = kHandRow + 6 * static_cast<int>(i);
    if (!task_->has_hand[i]) continue;
    const Side side = static_cast<Side>(i);
    const SegmentPlace& hand = pose_[armSegment(side, S::kLeftHand)];
    const bool bound = task_->held && i == 1;
    const dvec3 pull = shortenedTo(errors_.hand[i], kMostPull);
    const dvec3 turn = kLever * shortenedTo(errors_.hand_turn[i], kMostTurn);
    for (int k = 0; k < 6; ++k) {
      const std::size_t row = static_cast<std::size_t>(first + k);
      if (k >= 3 && !task_->has_orientation[i]) continue;
      problem.e[row] = k < 3 ? pull[k] : turn[k - 3];
      problem.R[row] = bound ? kHeldRegularisation : lambda;
    }
    const auto fill = [&](int variable, double sign) {
      double rows[6];
      fillRows(axes, variable, hand.p_WS, rows);
      for (int k = 0; k < (task_->has_orientation[i] ? 6 : 3); ++k) {
        problem.J[static_cast<std::size_t>(variable)][static_cast<std::size_t>(first + k)] = sign * rows[k];
      }
    };
    for (int v = armVariable(side); v < armVariable(side) + 9; ++v) fill(v, 1.0);
    // A bound right hand moves relative to the left: trunk and root move both alike, the left arm takes it along.
    if (bound) {
      for (int v = kArmVariable; v < kArmVariable + 9; ++v) fill(v, -1.0);
    } else {
      for (int v = 0; v < kArmVariable; ++v) fill(v, 1.0);
    }
  }
}

void BodySolver::fillFeet(const VariableAxes& axes, StepProblem& problem) const {
  for (std::size_t i = 0; i < 2; ++i) {
    const Side side = static_cast<Side>(i);
    const int first = kFootRow + 6 * static_cast<int>(i);
    const dvec3 foot = pose_[legSegment(side, S::kLeftFoot)].p_WS;
    for (int k = 0; k < 6; ++k) {
      const std::size_t row = static_cast<std::size_t>(first + k);
      problem.e[row] = k < 3 ? errors_.foot[i][k] : kLever * errors_.foot_turn[i][k - 3];
      problem.R[row] = kFootRegularisation;
    }
    const auto fill = [&](int variable) {
      fillRows(axes, variable, foot, problem.J[static_cast<std::size_t>(variable)].data() + first);
    };
    for (int v = 0; v < kSpineVariable; ++v) fill(v);
    for (int v = legVariable(side); v < legVariable(side) + 6; ++v) fill(v);
  }
}

void BodySolver::fillBalance(const VariableAxes& axes, StepProblem& problem) const {
  if (!task_->balance) return;
  const SupportPolygon& hull = task_->support;
  const glm::dvec2 com(errors_.p_WCom);
  std::array<glm::dvec2, 2> normals{};
  std::array<double, 2> gaps{};
  int count = 0;
  for (std::size_t i = 0; i < hull.count; ++i) {
    const glm::dvec2 edge = hull.points[(i + 1) % hull.count] - hull.points[i];
    const double length = glm::length(edge);
    if (length < 1e-9) continue;
    const glm::dvec2 inward(-edge.y / length, edge.x / length);
    const double gap = glm::dot(inward, com - hull.points[i]) - task_->balance_margin;
    if (gap > kEdgeZone) continue;
    const std::size_t wider = gaps[0] > gaps[1] ? 0 : 1;
    const std::size_t slot = count < 2 ? static_cast<std::size_t>(count) : wider;
    if (count == 2 && gap >= gaps[slot]) continue;
    normals[slot] = inward;
    gaps[slot] = gap;
    count = std::min(2, count + 1);
  }
  if (count == 0) return;
  const Subtrees trees = subtreesOf(*figure_, pose_, task_->loads);
  const double whole = trees.mass[0];
  for (int c = 0; c < count; ++c) {
    const std::size_t row = static_cast<std::size_t>(kBalanceRow + c);
    problem.e[row] = std::max(0.0, -gaps[static_cast<std::size_t>(c)]);
    problem.R[row] = kBalanceRegularisation;
  }
  for (std::size_t v = 0; v < kVariables; ++v) {
    const std::size_t s = indexOf(kTurned[v]);
    const dvec3 moved =
        v < 3 ? axes.axis[v] : glm::cross(axes.axis[v], trees.moment[s] - trees.mass[s] * axes.origin[v]) / whole;
    for (int c = 0; c < count; ++c) {
      problem.J[v][static_cast<std::size_t>(kBalanceRow + c)] =
          glm::dot(normals[static_cast<std::size_t>(c)], glm::dvec2(moved));
    }
  }
}

void BodySolver::fillBounds(const VariableAxes& axes, const StepLimits& limits, StepProblem& problem) const {
  for (int v = 0; v < kVariables; ++v) {
    const std::size_t i = static_cast<std::size_t>(v);
    const double most = v < 3 ? 0.4 * limits.turn : limits.turn;
    problem.lower[i] = -most;
    problem.upper[i] = most;
    if (const std::optional<Dof> dof = dofOfVariable(v)) {
      const DofInfo& info = dofInfo(*dof);
      const double angle = state_.angles[indexOf(*dof)];
      problem.lower[i] = std::clamp(info.lower - angle, -most, 0.0);
      problem.upper[i] = std::clamp(info.upper - angle, 0.0, most);
    }
    const bool locked = (task_->pelvis_locked && v < kSpineVariable) || (task_->trunk_locked && v < kArmVariable);
    if (locked) problem.lower[i] = problem.upper[i] = 0.0;
  }
  constexpr int kBallVariables[4] = {17, 26, 33, 39};
  for (std::size_t b = 0; b < 4; ++b) {
    const BallJoint joint = b < 2 ? BallJoint::kShoulder : BallJoint::kHip;
    const std::size_t v = static_cast<std::size_t>(kBallVariables[b]);
    const BallState& ball = axes.balls[b].state;
    problem.upper[v] = std::clamp(-ball.excess() / axes.balls[b].cone_rate, 0.0, limits.turn);
    problem.lower[v + 2] = std::clamp(twistLower(joint) - ball.twist, -limits.turn, 0.0);
    problem.upper[v + 2] = std::clamp(twistUpper(joint) - ball.twist, 0.0, limits.turn);
  }
}

void BodySolver::fillProblem(const VariableAxes& axes, const StepLimits& limits, StepProblem& problem) const {
  for (double& R : problem.R) R = 1.0;
  problem.D = kWeights;
  problem.arms_coupled = task_->held;
  fillBounds(axes, limits, problem);
  fillFeet(axes, problem);
  fillBalance(axes, problem);
  fillHands(axes, limits.lambda, problem);
  if (limits.comfort > 0.0) wishComfort(*figure_, *task_, state_, pose_, axes, limits.comfort, problem.wish);
  for (std::size_t i = 0; i < kVariables; ++i) {
    problem.wish[i] = std::clamp(problem.wish[i], problem.lower[i], problem.upper[i]);
  }
}

Variables BodySolver::response(Side hand, const Twist& motion, VariableAxes& axes) const {
  findAxes(state_, pose_, axes);
  StepProblem problem;
  fillProblem(axes, {0.1, 1e-7, 0.0}, problem);
  const std::size_t row = static_cast<std::size_t>(kHandRow + (hand == Side::kLeft ? 0 : 6));
  for (double& e : problem.e) e = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    problem.e[row + k] = motion.linear[static_cast<int>(k)];
    problem.e[row + 3 + k] = kLever * motion.angular[static_cast<int>(k)];
  }
  ActiveSet active{};
  Variables step{};
  solveStep(problem, active, step);
  return step;
}

Segment segmentOfVariable(int variable) {
  return kTurned[static_cast<std::size_t>(variable)];
}

}  // namespace hapticell::mannequin
