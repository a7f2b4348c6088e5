// SPDX-License-Identifier: Apache-2.0
// What PostureSolver is made of: one state on its way, its linear model, the starting postures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "mannequin/posture/body_solver.h"
#include "mannequin/posture/hand_differential.h"
#include "mannequin/posture/posture_seeds.h"
#include "tests/mannequin/body/median_man.h"
#include "tests/mannequin/posture/random_postures.h"

namespace hapticell::mannequin {
namespace {

constexpr std::array kBothSides = {Side::kLeft, Side::kRight};

std::size_t at(Side side) {
  return static_cast<std::size_t>(side);
}

/// A task that asks both hands to where they are in `reached`, moved by `moved` (m and rad, in the world).
PostureTask handsOf(const Figure& figure, const Posture& reached, const Twist& moved = {}) {
  const FigurePose pose = forwardKinematics(figure, reached);
  PostureTask task;
  for (const Side side : kBothSides) task.hands[at(side)] = displaced(handPose(pose, side), moved);
  return task;
}

/// The worse hand of a posture, m.
double missingOf(const Figure& figure, const Posture& posture, const PostureTask& task) {
  const FigurePose pose = forwardKinematics(figure, posture);
  double worst = 0.0;
  for (const Side side : kBothSides) {
    if (task.hands[at(side)]) worst = std::max(worst, glm::length(task.hands[at(side)]->p - handPose(pose, side).p));
  }
  return worst;
}

TEST(BodySolver, TellsWhatIsMissingAndWhatItCosts) {
  const Figure figure = medianMan();
  const Posture standing = *libraryPosture(figure, "standing");
  const Twist moved{{0.10, 0.02, -0.03}, {0.0, 0.1, 0.3}};
  PostureTask task = handsOf(figure, standing, moved);
  const FigurePose pose = forwardKinematics(figure, standing);
  const ResolvedTask resolved = resolve(figure, task, pose);
  BodySolver solver(figure, resolved);
  solver.set(stateOf(standing));
  double merit = 0.0;
  for (const Side side : kBothSides) {
    EXPECT_LT(glm::length(solver.errors().hand[at(side)] - moved.linear), 1e-9);
    EXPECT_LT(glm::length(solver.errors().hand_turn[at(side)] - moved.angular), 1e-9);
    merit += glm::dot(moved.linear, moved.linear) + 0.2 * 0.2 * glm::dot(moved.angular, moved.angular);
  }
  EXPECT_LT(solver.errors().foot_position, 1e-12) << "the feet are asked to where they are";
  EXPECT_NEAR(solver.errors().merit, merit, 1e-9) << "standing is balanced, which costs nothing";
  EXPECT_FALSE(solver.errors().solved());

  // A heavy load held to the side: out of balance by as much as its moment says, and that costs its weight squared.
  task.loads[0] = {60.0, {0.0, 0.5, 0.0}};
  const ResolvedTask loaded = resolve(figure, task, pose);
  BodySolver tipping(figure, loaded);
  tipping.set(stateOf(standing));
  const dvec3 p_WLoad = pose[Segment::kLeftHand].point(task.loads[0].p_HC);
  const double mass = figure.totalMass();
  const dvec3 p_WCom = (mass * centerOfMass(figure, pose) + 60.0 * p_WLoad) / (mass + 60.0);
  const double outside =
      task.balance_margin -
      supportPolygon(figure, {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]}).margin(glm::dvec2(p_WCom));
  ASSERT_GT(outside, 0.0);
  EXPECT_NEAR(tipping.errors().balance, -outside, 1e-9);
  for (const double weight : {1.0, 50.0, BodySolver::kStrictBalance}) {
    tipping.setBalanceWeight(weight);
    EXPECT_NEAR(tipping.errors().merit, merit + weight * outside * outside, 1e-9 * weight);
  }
}

TEST(BodySolver, StepsDownToThePostureThatIsAsked) {
  const Figure figure = medianMan();
  const Posture standing = *libraryPosture(figure, "standing");
  for (const char* name : {"both_hands_forward", "reaching"}) {
    const PostureTask task = handsOf(figure, *libraryPosture(figure, name));
    const ResolvedTask resolved = resolve(figure, task, forwardKinematics(figure, standing));
    BodySolver solver(figure, resolved);
    solver.set(stateOf(standing));
    double before = solver.errors().merit;
    for (int i = 0; i < 6 && !solver.errors().solved(); ++i) {
      const bool is_taken = solver.step({});
      EXPECT_LE(solver.errors().merit, before + 1e-15) << name;
      EXPECT_TRUE(is_taken || solver.errors().merit == before) << "a step that is refused changes nothing";
      before = solver.errors().merit;
    }
    EXPECT_EQ(solver.iterations(), 6);
    solver.run(200, {}, false);
    EXPECT_GT(solver.iterations(), 6);
    ASSERT_TRUE(solver.errors().solved()) << name;
    const Posture found = postureOf(solver.state(), {});
    EXPECT_LT(missingOf(figure, found, task), 1e-3);
    EXPECT_TRUE(limitViolations(found).empty());
    const FigurePose pose = forwardKinematics(figure, found), start = forwardKinematics(figure, standing);
    for (const Side side : kBothSides) EXPECT_LT(glm::length(footPose(pose, side).p - footPose(start, side).p), 3e-4);
    for (std::size_t i = 0; i < kSegmentCount; ++i)
      EXPECT_LT(glm::length(pose.segments[i].p_WS - solver.pose().segments[i].p_WS), 1e-9);
  }
}

TEST(BodySolver, EachVariableTurnsItsSegmentAndWhatHangsOnIt) {
  const Figure figure = medianMan();
  std::mt19937_64 random(17);
  for (int n = 0; n < 5; ++n) {
    const BodyState state = stateOf(randomPosture(random, 0.5));
    FigurePose pose, moved;
    placeSegments(figure, state, pose);
    VariableAxes axes;
    findAxes(state, pose, axes);
    for (int v = 0; v < kVariables; ++v) {
      Variables step{};
      step[static_cast<std::size_t>(v)] = 1e-3;
      BodyState next = state;
      applyStep(step, axes, next);
      placeSegments(figure, next, moved);
      for (std::size_t i = 0; i < kSegmentCount; ++i) {
        bool hangs = false;
        for (std::optional<Segment> s = static_cast<Segment>(i); s; s = segmentInfo(*s).parent)
          hangs = hangs || *s == segmentOfVariable(v);
        double change = glm::length(moved.segments[i].p_WS - pose.segments[i].p_WS);
        for (int c = 0; c < 3; ++c)
          change = std::max(change, glm::length(moved.segments[i].R_WS[c] - pose.segments[i].R_WS[c]));
        // A turn of 1 mrad moves the ends of at least two axes by 0.7 mm or more.
        EXPECT_EQ(change > 5e-4, hangs) << v << " " << segmentInfo(static_cast<Segment>(i)).name;
        EXPECT_TRUE(hangs || change < 1e-12) << v << " " << segmentInfo(static_cast<Segment>(i)).name;
      }
    }
  }
}

TEST(BodySolver, ItsResponseMovesTheHandAsAskedAndLeavesTheFeet) {
  const Figure figure = medianMan();
  const Posture posture = *libraryPosture(figure, "both_hands_forward");
  const PostureTask task = handsOf(figure, posture);
  const ResolvedTask resolved = resolve(figure, task, forwardKinematics(figure, posture));
  BodySolver solver(figure, resolved);
  solver.set(stateOf(posture));
  const Twist asked{{1e-4, -2e-4, 1.5e-4}, {2e-4, 1e-4, -3e-4}};
  for (const Side side : kBothSides) {
    VariableAxes axes;
    const Variables step = solver.response(side, asked, axes);
    BodyState next = solver.state();
    applyStep(step, axes, next);
    FigurePose moved;
    placeSegments(figure, next, moved);
    const Twist got = difference(handPose(moved, side), handPose(solver.pose(), side));
    EXPECT_LT(glm::length(got.linear - asked.linear), 1e-6);
    EXPECT_LT(glm::length(got.angular - asked.angular), 1e-6);
    const Twist rest = difference(handPose(moved, other(side)), handPose(solver.pose(), other(side)));
    EXPECT_LT(glm::length(rest.linear), 1e-6) << "the other hand has its own target";
    for (const Side foot : kBothSides)
      EXPECT_LT(glm::length(footPose(moved, foot).p - footPose(solver.pose(), foot).p), 1e-6);
  }
}

TEST(BodySolver, ArmsAndLegsAreClosedExactly) {
  const Figure figure = medianMan();
  const Posture posture = *libraryPosture(figure, "both_hands_forward");
  const FigurePose pose = forwardKinematics(figure, posture);
  const ResolvedTask near = resolve(figure, handsOf(figure, posture, {{0.004, 0.003, -0.005}, {0.0, 0.02, 0.0}}), pose);
  BodySolver solver(figure, near);
  solver.set(stateOf(posture));
  solver.finishArms();
  for (const Side side : kBothSides) EXPECT_LT(solver.errors().hand_position[at(side)], 1e-9);
  const Posture finished = postureOf(solver.state(), {});
  for (const Dof dof : {Dof::kVl5Flexion, Dof::kVt6LeftTurn, Dof::kLeftHipFlexion, Dof::kRightKneeFlexion})
    EXPECT_NEAR(finished[dof], posture[dof], 1e-12) << "only the arms have moved";

  PostureTask holding;
  holding.held = HeldObject{handPose(pose, Side::kLeft),
                            {Pose::identity(), handPose(pose, Side::kLeft).inverse() * handPose(pose, Side::kRight)}};
  const ResolvedTask held = resolve(figure, holding, pose);
  BodySolver binding(figure, held);
  Posture bent = posture;
  bent[Dof::kLeftElbowFlexion] += 0.03;
  binding.set(stateOf(bent));
  EXPECT_GT(binding.errors().relative_position, 1e-3);
  ASSERT_TRUE(binding.bindHeld());
  const FigurePose bound = forwardKinematics(figure, postureOf(binding.state(), {}));
  const Twist slip =
      difference(handPose(bound, Side::kLeft).inverse() * handPose(bound, Side::kRight), holding.held->X_OH[1]);
  EXPECT_LT(glm::length(slip.linear), 1e-9);
  EXPECT_LT(glm::length(slip.angular), 1e-7);

  const std::array<SegmentPlace, 2> feet{pose[Segment::kLeftFoot], pose[Segment::kRightFoot]};
  BodyState crouched = stateOf(posture);
  crouched.root.p_WS += dvec3(0.0, 0.0, -0.02);
  placeFeet(figure, feet, crouched);
  const FigurePose placed = forwardKinematics(figure, postureOf(crouched, {}));
  for (const Side side : kBothSides) {
    EXPECT_LT(glm::length(footPose(placed, side).p - footPose(pose, side).p), 1e-9);
    EXPECT_LT(glm::length(difference(footPose(placed, side), footPose(pose, side)).angular), 1e-7);
  }
  BodyState lifted = stateOf(posture);
  lifted.root.p_WS.z += 1.0;
  const BodyState before = lifted;
  placeFeet(figure, feet, lifted);
  EXPECT_EQ(lifted.angles, before.angles) << "legs that are too short are left as they are";
}

/// Each joint belongs to two segments: its velocity is the same by both.
TEST(HandDifferential, MovesTheHandWithItsFrameAndKeepsTheJointsTogether) {
  const Figure figure = medianMan();
  const Posture posture = *libraryPosture(figure, "both_hands_forward");
  const FigurePose pose = forwardKinematics(figure, posture);
  for (const bool is_locked : {false, true}) {
    PostureTask task = handsOf(figure, posture);
    task.trunk_locked = is_locked;
    for (const Side side : kBothSides) {
      const Segment hand = armSegment(side, Segment::kLeftHand);
      const Pose X_WM = handPose(pose, side) * Pose::translation({0.02, 0.01, -0.15});
      const HandDifferential moves = differentiateHand(figure, posture, task, side, X_WM);
      for (std::size_t k = 0; k < 6; ++k) {
        dvec3 unit(0.0);
        unit[static_cast<int>(k % 3)] = 1.0;
        const Twist wanted = k < 3 ? Twist{unit, dvec3(0.0)} : Twist{glm::cross(unit, pose[hand].p_WS - X_WM.p), unit};
        const auto of = [&](Segment segment) -> const Twist& { return moves[indexOf(segment)][k]; };
        EXPECT_LT(glm::length(of(hand).linear - wanted.linear), 1e-3) << k;
        EXPECT_LT(glm::length(of(hand).angular - wanted.angular), 5e-3) << k;
        for (const Side foot : kBothSides) {
          EXPECT_LT(glm::length(of(legSegment(foot, Segment::kLeftFoot)).linear), 1e-5);
          EXPECT_LT(glm::length(of(legSegment(foot, Segment::kLeftFoot)).angular), 1e-4);
        }
        if (is_locked) {
          EXPECT_EQ(glm::length(of(Segment::kPelvis).linear), 0.0);
          EXPECT_EQ(glm::length(of(Segment::kThorax).angular), 0.0);
        }
        for (std::size_t i = 0; i < kSegmentCount; ++i) {
          const Segment segment = static_cast<Segment>(i);
          if (!segmentInfo(segment).parent) continue;
          const Segment parent = *segmentInfo(segment).parent;
          const dvec3 by_parent =
              of(parent).linear + glm::cross(of(parent).angular, pose[segment].p_WS - pose[parent].p_WS);
          EXPECT_LT(glm::length(of(segment).linear - by_parent), 1e-9) << segmentInfo(segment).name;
        }
      }
    }
  }
}

TEST(PostureSeeds, AreDifferentPosturesWithinTheLimitsOnTheSameFeet) {
  const Figure figure = medianMan();
  const Posture standing = *libraryPosture(figure, "standing");
  const FigurePose start = forwardKinematics(figure, standing);
  for (const bool both : {true, false}) {
    PostureTask task = handsOf(figure, *libraryPosture(figure, "both_hands_forward"), {{0.1, 0.0, -0.4}, dvec3(0.0)});
    if (!both) task.hands[0].reset();
    const ResolvedTask resolved = resolve(figure, task, start);
    const BodyState present = stateOf(standing);
    PostureSeeds seeds(figure, resolved, present);
    std::vector<Posture> found;
    double nearest = 1e9;
    while (const BodyState* seed = seeds.next()) {
      found.push_back(postureOf(*seed, {}));
      EXPECT_TRUE(limitViolations(found.back()).empty());
      nearest = std::min(nearest, missingOf(figure, found.back(), task));
    }
    EXPECT_EQ(found.size(), both ? PostureSeeds::kMost : PostureSeeds::kBatch);
    EXPECT_EQ(seeds.next(), nullptr);
    EXPECT_LT(nearest, 0.05) << "from upright they are " << missingOf(figure, standing, task) << " m away";
    double worst_foot = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const FigurePose pose = forwardKinematics(figure, found[i]);
      for (const Side side : kBothSides)
        worst_foot = std::max(worst_foot, glm::length(footPose(pose, side).p - footPose(start, side).p));
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_GT(glm::length(found[i].X_WR.p - found[k].X_WR.p) +
                      glm::length(difference(found[i].X_WR, found[k].X_WR).angular),
                  1e-3);
    }
    EXPECT_LT(worst_foot, 0.05);
  }
}

TEST(PostureSeeds, ArmsThatCanReachDoSoExactly) {
  const Figure figure = medianMan();
  const Posture standing = *libraryPosture(figure, "standing");
  Posture raised = standing;
  for (const Side side : kBothSides) {
    raised[armDof(side, Dof::kLeftShoulderFlexion)] = 0.5;
    raised[armDof(side, Dof::kLeftElbowFlexion)] = 1.2;
  }
  const PostureTask task = handsOf(figure, raised);
  const ResolvedTask resolved = resolve(figure, task, forwardKinematics(figure, standing));
  const SeededState few = withArms(figure, resolved, stateOf(standing), 12),
                    many = withArms(figure, resolved, stateOf(standing), 48);
  EXPECT_LT(missingOf(figure, postureOf(many.state, {}), task), 1e-9);
  EXPECT_LE(many.cost, few.cost) << "the swivels of the few are among the many";
  EXPECT_LT(many.cost, 1.0) << "within the limits";
  const ResolvedTask far =
      resolve(figure, handsOf(figure, raised, {{1.0, 0.0, 0.0}, dvec3(0.0)}), forwardKinematics(figure, standing));
  EXPECT_GT(withArms(figure, far, stateOf(standing), 12).cost, 2.0 * 10.0 * 4.0 * 0.5)
      << "each hand more than 0.5 m short";
}

TEST(PostureSeeds, StepsToWhereTheHandsAreInFront) {
  const Figure figure = medianMan();
  const Posture standing = *libraryPosture(figure, "standing");
  PostureTask task;
  EXPECT_EQ(steppedTowards(figure, task, standing).X_WR.p, standing.X_WR.p) << "no hand, no step";
  task.hands[0] = Pose::translation({-2.0, 1.5, 1.0});
  task.hands[1] = Pose::translation({-2.4, 2.1, 1.2});
  const Posture stepped = steppedTowards(figure, task, standing);
  const FigurePose pose = forwardKinematics(figure, stepped);
  const dvec3 ahead = glm::transpose(pose[Segment::kPelvis].R_WS) * (dvec3(-2.2, 1.8, 1.1) - middleOfHips(pose));
  EXPECT_NEAR(ahead.x, 0.75 * (figure.upperArmLength() + figure.forearmLength()), 0.05);
  EXPECT_NEAR(ahead.y, 0.0, 1e-6);
  for (const Side side : kBothSides)
    EXPECT_NEAR(footPose(pose, side).p.z, footPose(forwardKinematics(figure, standing), side).p.z, 1e-9);
  PostureTask holding;
  holding.held = HeldObject{Pose::translation({-2.2, 1.8, 1.1}),
                            {Pose::translation({0.2, -0.3, -0.1}), Pose::translation({-0.2, 0.3, 0.1})}};
  EXPECT_LT(glm::length(steppedTowards(figure, holding, standing).X_WR.p - stepped.X_WR.p), 1e-9);
}

}  // namespace
}  // namespace hapticell::mannequin
