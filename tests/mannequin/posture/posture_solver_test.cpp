// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/posture_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/mannequin_goals.h"
#include "mannequin/posture/limb_inverse.h"
#include "mannequin/posture/support_polygon.h"
#include "tests/mannequin/body/median_man.h"
#include "tests/support/same_bits.h"

namespace hapticell::mannequin {
namespace {

double errorOf(const Figure& figure, const Posture& posture, Side side, const Pose& wanted) {
  const Twist off = difference(wanted, handPose(forwardKinematics(figure, posture), side));
  return std::max(glm::length(off.linear), 0.1 * glm::length(off.angular));
}

bool sameBits(const Posture& a, const Posture& b) {
  return test::sameBits(a.angles, b.angles) && test::sameBits(a.X_WR, b.X_WR);
}

dvec3 elbow(const FigurePose& pose, Side side) {
  return pose[armSegment(side, Segment::kLeftForearm)].p_WS;
}

/// Angle between two directions, rad.
double angleBetween(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Largest change of elbow flexion or upper-arm direction from one pose to the next, rad.
double armStep(const FigurePose& a, const FigurePose& b, const Posture& from, const Posture& to, Side side) {
  const Segment upper = armSegment(side, Segment::kLeftUpperArm);
  const dvec3 before = elbow(a, side) - a[upper].p_WS, after = elbow(b, side) - b[upper].p_WS;
  const Dof flexion = armDof(side, Dof::kLeftElbowFlexion);
  return std::max(angleBetween(before, after), std::abs(to[flexion] - from[flexion]));
}

TEST(LimbInverse, LegsAndArmsComeBackFromTheirOwnPoses) {
  const Figure figure = medianMan();
  std::mt19937_64 random(21);
  for (int n = 0; n < 100; ++n) {
    const Posture posture = bench::makeGoal(figure, {}, random).reached;
    const FigurePose pose = forwardKinematics(figure, posture);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const LegAngles leg =
          legInverse(figure, side, pose[Segment::kPelvis], pose[legSegment(side, Segment::kLeftFoot)]);
      EXPECT_NEAR(leg.knee, posture[legDof(side, Dof::kLeftKneeFlexion)], 1e-7);
      EXPECT_NEAR(leg.inversion, posture[legDof(side, Dof::kLeftAnkleInversion)], 1e-7);
      const ArmProblem arm(figure, side, pose[Segment::kThorax], pose[armSegment(side, Segment::kLeftClavicle)],
                           pose[armSegment(side, Segment::kLeftHand)]);
      const ArmAngles angles = arm.at(arm.swivelOf(elbow(pose, side)));
      EXPECT_NEAR(angles.elbow, posture[armDof(side, Dof::kLeftElbowFlexion)], 1e-6);
      EXPECT_NEAR(angles.pronation, posture[armDof(side, Dof::kLeftPronation)], 1e-6);
      EXPECT_NEAR(angles.wrist_flexion, posture[armDof(side, Dof::kLeftWristFlexion)], 1e-6);
      EXPECT_NEAR(angles.violation, 0.0, 1e-6);
    }
  }
}

TEST(PostureSolver, SolvesReachableGoalsFromStanding) {
  const Figure figure = medianMan();
  const PostureSolver solver(figure);
  for (const bool split : {false, true}) {
    std::mt19937_64 random(split ? 31 : 32);
    int solved = 0;
    constexpr int kGoals = 150;
    for (int n = 0; n < kGoals; ++n) {
      const bench::ReachableGoal goal = bench::makeGoal(figure, {1.0, split}, random);
      const PostureResult result = solver.solve(goal.task, goal.neutral);
      EXPECT_TRUE(limitViolations(result.posture).empty());
      if (result.status != PostureStatus::kSolved) continue;
      ++solved;
      for (const Side side : {Side::kLeft, Side::kRight}) {
        EXPECT_LT(errorOf(figure, result.posture, side, *goal.task.hands[static_cast<std::size_t>(side)]), 1.1e-3);
      }
      EXPECT_LT(result.foot_displacement, 3e-4);
      EXPECT_GT(result.balance_margin, 0.019 - 1e-4);
      const FigurePose pose = forwardKinematics(figure, result.posture);
      EXPECT_LT(glm::length(centerOfMass(figure, pose) - result.p_WCom), 1e-9);
    }
    EXPECT_GE(solved, kGoals - 2);
  }
}

TEST(PostureSolver, TheOrderOfCallsDoesNotMatter) {
  const Figure figure = medianMan();
  const PostureSolver solver(figure);
  std::mt19937_64 random(41);
  std::vector<bench::ReachableGoal> goals;
  for (int n = 0; n < 30; ++n) goals.push_back(bench::makeGoal(figure, {1.0, n % 2 == 0}, random));
  std::vector<Posture> forward(goals.size()), backward(goals.size());
  for (std::size_t i = 0; i < goals.size(); ++i) forward[i] = solver.solve(goals[i].task, goals[i].neutral).posture;
  for (std::size_t i = goals.size(); i-- > 0;) backward[i] = solver.solve(goals[i].task, goals[i].neutral).posture;
  for (std::size_t i = 0; i < goals.size(); ++i) EXPECT_TRUE(sameBits(forward[i], backward[i]));
}

struct Drag {
  double biggest_step = 0.0, foot = 0.0;
  int lagging = 0, steps = 0;
};

/// Drags one hand along straight lines and turns, 1 mm or 0.25 deg a tick.
Drag drag(const Figure& figure, PostureTask task, bool two_hands, int paths, std::uint64_t seed) {
  const PostureSolver solver(figure);
  std::mt19937_64 random(seed);
  Drag report;
  for (int p = 0; p < paths; ++p) {
    const bench::ReachableGoal a = bench::makeGoal(figure, {0.6, false}, random);
    const bench::ReachableGoal b = bench::makeGoal(figure, {0.6, false}, random);
    Posture posture = a.reached;
    const FigurePose first = forwardKinematics(figure, posture);
    const std::array<Pose, 2> feet = {footPose(first, Side::kLeft), footPose(first, Side::kRight)};
    const double way = glm::length(b.task.hands[1]->p - a.task.hands[1]->p);
    const int ticks = std::min(600, static_cast<int>(way / 1e-3) + 1);
    task.feet = {feet[0], feet[1]};
    FigurePose before = first;
    for (int t = 1; t <= ticks; ++t) {
      const double s = std::min(1.0, t * 1e-3 / std::max(1e-3, way));
      for (std::size_t i = two_hands ? 0 : 1; i < 2; ++i) {
        task.hands[i] = interpolate(*a.task.hands[i], *b.task.hands[i], s);
        // The turn at most 0.25 deg a tick, so that a short way does not spin the hand.
        const Twist whole = difference(*b.task.hands[i], *a.task.hands[i]);
        const double angle = glm::length(whole.angular);
        const double turn = angle > 0.0 ? std::min(1.0, t * 0.25 * kDegree / angle) : 0.0;
        task.hands[i]->q = displaced(*a.task.hands[i], {dvec3(0.0), turn * whole.angular}).q;
      }
      const PostureResult result = solver.follow(task, posture);
      const FigurePose after = forwardKinematics(figure, result.posture);
      for (const Side side : {Side::kLeft, Side::kRight}) {
        report.biggest_step = std::max(report.biggest_step, armStep(before, after, posture, result.posture, side));
        const Pose foot = footPose(after, side);
        report.foot = std::max(report.foot, glm::length(foot.p - feet[static_cast<std::size_t>(side)].p));
      }
      EXPECT_TRUE(limitViolations(result.posture).empty());
      report.lagging += result.status == PostureStatus::kSolved ? 0 : 1;
      ++report.steps;
      posture = result.posture;
      before = after;
    }
  }
  return report;
}

TEST(PostureSolver, ADraggedHandSwingsTheElbowAndNeverThrowsIt) {
  PostureTask whole, locked;
  locked.trunk_locked = true;
  const Figure figure = medianMan();
  const Drag free = drag(figure, whole, false, 8, 51);
  EXPECT_LT(free.biggest_step, 2.1 * kDegree);
  EXPECT_LT(free.foot, 3e-4 + 1e-9);
  EXPECT_LT(free.lagging, free.steps / 10);
  const Drag trunk = drag(figure, locked, false, 6, 52);
  EXPECT_LT(trunk.biggest_step, 2.1 * kDegree);
  EXPECT_LT(trunk.foot, 3e-4);
  const Drag both = drag(figure, whole, true, 6, 53);
  EXPECT_LT(both.biggest_step, 2.1 * kDegree);
  EXPECT_LT(both.foot, 3e-4);
}

/// A hanging hand drawn straight up, its turn kept: a nearly straight arm bends far for little, and must do that.
TEST(PostureSolver, AHangingHandDrawnUpBendsItsArmAndNotTheTrunk) {
  const Figure figure = medianMan();
  const PostureSolver solver(figure);
  Posture posture = *libraryPosture(figure, "standing");
  const FigurePose first = forwardKinematics(figure, posture);
  const Pose hanging = handPose(first, Side::kRight);
  PostureTask task;
  task.hands[1] = hanging;
  constexpr double kUp = 0.10;
  double biggest_step = 0.0;
  for (int t = 1; t <= 150; ++t) {
    task.hands[1]->p.z = hanging.p.z + std::min(kUp, 1e-3 * t);
    const Posture before = std::exchange(posture, solver.follow(task, posture).posture);
    biggest_step = std::max(biggest_step, armStep(forwardKinematics(figure, before), forwardKinematics(figure, posture),
                                                  before, posture, Side::kRight));
  }
  const FigurePose pose = forwardKinematics(figure, posture);
  EXPECT_LT(errorOf(figure, posture, Side::kRight, *task.hands[1]), 1e-4);
  EXPECT_LT(angleBetween(pose[Segment::kThorax].R_WS[2], first[Segment::kThorax].R_WS[2]), 2.0 * kDegree);
  EXPECT_LT(biggest_step, 2.1 * kDegree);
  // By the cosine rule, from a shoulder that stays.
  const double a = figure.upperArmLength(), b = figure.forearmLength();
  const double reach = glm::distance(task.hands[1]->p, first[Segment::kRightUpperArm].p_WS);
  EXPECT_NEAR(posture[armDof(Side::kRight, Dof::kLeftElbowFlexion)],
              std::acos((reach * reach - a * a - b * b) / (2.0 * a * b)), 2.0 * kDegree);
}

TEST(PostureSolver, OutOfReachItStopsAtFullReachAndSaysWhatIsMissing) {
  const Figure figure = medianMan();
  const PostureSolver solver(figure);
  const Posture standing = *libraryPosture(figure, "standing");
  PostureTask task;
  Pose far = handPose(forwardKinematics(figure, *libraryPosture(figure, "reaching")), Side::kRight);
  far.p.x += 2.0;
  task.hands[1] = far;
  const PostureResult result = solver.solve(task, standing);
  EXPECT_EQ(result.status, PostureStatus::kOutOfReach);
  const double missing = glm::length(far.p - handPose(forwardKinematics(figure, result.posture), Side::kRight).p);
  EXPECT_NEAR(result.hand_position_error[1], missing, 1e-9);
  EXPECT_GT(missing, 1.0);
  EXPECT_LT(missing, 2.0);
  EXPECT_GT(result.balance_margin, 0.015);
  EXPECT_TRUE(limitViolations(result.posture).empty());
  // With the trunk locked only the arm can go: no more than its length from the shoulder, pelvis where it was.
  task.trunk_locked = true;
  const PostureResult arm = solver.solve(task, standing);
  EXPECT_EQ(arm.posture.X_WR.p, standing.X_WR.p);
  EXPECT_EQ(arm.posture[Dof::kVt6LeftTurn], standing[Dof::kVt6LeftTurn]);
  EXPECT_GE(arm.hand_position_error[1], result.hand_position_error[1] - 1e-3);
  // A step brings it near.
  task.trunk_locked = false;
  task.may_step = true;
  EXPECT_EQ(solver.solve(task, standing).status, PostureStatus::kSolved);
}

TEST(PostureSolver, WhileOutOfReachADragNeverGetsWorse) {
  const Figure figure = medianMan();
  const PostureSolver solver(figure);
  Posture posture = *libraryPosture(figure, "reaching");
  PostureTask task;
  const Pose start = handPose(forwardKinematics(figure, posture), Side::kRight);
  for (int t = 0; t < 100; ++t) {
    task.hands[1] = start;
    task.hands[1]->p.x += 0.01 * t;
    double before = errorOf(figure, posture, Side::kRight, *task.hands[1]);
    for (int k = 0; k < 3; ++k) {
      posture = solver.follow(task, posture).posture;
      const double after = errorOf(figure, posture, Side::kRight, *task.hands[1]);
      EXPECT_LE(after, before + 1e-4);
      before = after;
    }
  }
}

TEST(PostureSolver, AHeldObjectDoesNotSlipInTheHands) {
  const Figure figure = medianMan();
  const PostureSolver solver(figure);
  Posture posture = *libraryPosture(figure, "both_hands_forward");
  const FigurePose pose = forwardKinematics(figure, posture);
  const Pose left = handPose(pose, Side::kLeft), right = handPose(pose, Side::kRight);
  const Pose X_WO{0.5 * (left.p + right.p), dquat(1, 0, 0, 0)};
  HeldObject held{X_WO, {X_WO.inverse() * left, X_WO.inverse() * right}};
  const Pose X_LR = left.inverse() * right;
  PostureTask task;
  double worst = 0.0, worst_turn = 0.0;
  for (int t = 0; t < 700; ++t) {
    held.X_WO = X_WO;
    held.X_WO.p += dvec3(0.0012 * t, 0.05 * std::sin(0.01 * t), 0.15 * std::sin(0.006 * t));  // leaves the reach
    task.held = held;
    posture = solver.follow(task, posture).posture;
    const FigurePose now = forwardKinematics(figure, posture);
    const Twist slip = difference(handPose(now, Side::kLeft).inverse() * handPose(now, Side::kRight), X_LR);
    worst = std::max(worst, glm::length(slip.linear));
    worst_turn = std::max(worst_turn, glm::length(slip.angular));
    EXPECT_TRUE(limitViolations(posture).empty());
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(worst_turn, 1e-6);
}

TEST(SupportPolygon, MarginsAreDistancesToTheHull) {
  const Figure figure = medianMan();
  const FigurePose pose = forwardKinematics(figure, *libraryPosture(figure, "standing"));
  const std::array<SegmentPlace, 2> feet = {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]};
  const SupportPolygon hull = supportPolygon(figure, feet);
  EXPECT_GE(hull.count, 4u);
  const glm::dvec2 middle(0.5 * (feet[0].p_WS + feet[1].p_WS));
  EXPECT_GT(hull.margin(middle), 0.05);
  // Back over the heels' line.
  EXPECT_NEAR(hull.margin(middle + glm::dvec2(figure.sole.heel_x, 0.0)), 0.0, 1e-9);
  EXPECT_NEAR(hull.margin(middle + glm::dvec2(figure.sole.heel_x - 0.1, 0.0)), -0.1, 1e-9);
  const SupportPolygon one = supportPolygon(figure, feet, {true, false});
  EXPECT_LT(one.margin(middle), 0.0);
}

}  // namespace
}  // namespace hapticell::mannequin
