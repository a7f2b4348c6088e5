// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/analytic_inverse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/model/turns.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

struct Robot {
  RobotModel model;
  int tip;
  std::unique_ptr<InverseModel> inverse;

  explicit Robot(RobotModel m, const InverseOptions& options = {})
      : model(std::move(m)), tip(model.defaultTip()), inverse(std::move(*createInverse(model, tip, {}, options))) {}
  Pose pose(const std::vector<double>& q) const { return test::tipPose(model, q, tip); }
  ChainPositions chainPositions(const std::vector<double>& q) const {
    ChainPositions x{};
    for (std::size_t i = 0; i < inverse->variables().size(); ++i) {
      x[i] = q[static_cast<std::size_t>(inverse->variables()[i])];
    }
    return x;
  }
  bool same(const std::vector<double>& a, const std::vector<double>& b, double tolerance) const {
    return sameButForTurns(*inverse->chain(), chainPositions(a), chainPositions(b), tolerance);
  }
};

double worstError(const InverseSolution& solution) {
  return std::max(solution.position_error, solution.orientation_error);
}

TEST(AnalyticInverse, SolvesEveryReachablePoseOfEveryClass) {
  for (const auto& make : {test::kr120, test::ur5e, test::iiwa, test::panda, test::scara, test::sphericalWrist,
                           test::sphericalBase, test::offsetWrist, test::offsetWristWithShoulder}) {
    const Robot robot(make());
    std::mt19937_64 random(17);
    std::vector<double> q = test::randomJoints(robot.model, random);
    const int poses = robot.model.dof() > 6 ? 30 : 200;
    for (int i = 0; i < poses; ++i) {
      const InverseSolution solution = robot.inverse->solve(robot.pose(test::randomJoints(robot.model, random)), q);
      ASSERT_EQ(solution.status, InverseStatus::kSolved) << robot.inverse->name() << " " << i;
      ASSERT_LT(worstError(solution), 1e-12) << robot.inverse->name() << " " << i;
      q = solution.q;
    }
  }
}

// solveAll() proves most poses out of reach by intervals; solve() searches, by samples and by descent, and knows
// nothing of the proof.
TEST(AnalyticInverse, ProvesNoPoseOfSevenAxesOutOfReachThatASearchReaches) {
  for (const auto& make : {test::panda, test::iiwa}) {
    const Robot robot(make());
    std::mt19937_64 random(47);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    std::normal_distribution<double> normal;
    const std::vector<double> start = restPositions(robot.model);
    int reached = 0;
    for (int i = 0; i < 250; ++i) {
      Pose X_BT;
      for (int k = 0; k < 3; ++k) X_BT.p[k] = robot.inverse->chain()->reach() * place(random);
      X_BT.q = glm::normalize(dquat(normal(random), normal(random), normal(random), normal(random)));
      const auto all = robot.inverse->solveAll(X_BT, start);
      const bool listed = std::any_of(all.begin(), all.end(), [](const auto& one) { return one.within_limits; });
      const bool solved = robot.inverse->solve(X_BT, start).status == InverseStatus::kSolved;
      ASSERT_EQ(listed, solved) << robot.inverse->name() << " " << i;
      reached += solved ? 1 : 0;
    }
    EXPECT_GT(reached, 10);
    EXPECT_LT(reached, 125);
  }
}

// A narrow way within the limits passes between 16 places of the seventh joint (0.66 % of these poses). The way through
// all of them is known: the joints that made the pose.
TEST(AnalyticInverse, ListsASolutionWithinLimitsOfEveryReachablePoseOfSevenAxes) {
  for (const auto& make : {test::panda, test::iiwa}) {
    const Robot robot(make());
    std::mt19937_64 random(41);
    const std::vector<double> start = restPositions(robot.model);
    for (int i = 0; i < 20000; ++i) {
      const Pose X_BT = robot.pose(test::randomJoints(robot.model, random));
      int within = 0;
      for (const AlternativeSolution& one : robot.inverse->solveAll(X_BT, start)) {
        if (!one.within_limits) continue;
        ++within;
        for (std::size_t k = 0; k < one.q.size(); ++k) {
          const Joint& joint = robot.model.joints[static_cast<std::size_t>(robot.model.moving[k])];
          ASSERT_GE(one.q[k], joint.lower - 1e-9) << i;
          ASSERT_LE(one.q[k], joint.upper + 1e-9) << i;
        }
        const Twist error = difference(robot.pose(one.q), X_BT);
        ASSERT_LT(glm::length(error.linear) + glm::length(error.angular), 4e-9) << i;
      }
      ASSERT_GT(within, 0) << robot.inverse->name() << " " << i;
    }
  }
}

TEST(AnalyticInverse, ListsWhatARandomSearchFinds) {
  for (const auto& make : {test::kr120, test::ur5e, test::sphericalWrist, test::sphericalBase, test::offsetWrist}) {
    const Robot robot(make());
    const auto numeric = NumericInverse::create(robot.model, robot.tip);
    std::mt19937_64 random(23);
    for (int i = 0; i < 6; ++i) {
      const std::vector<double> q = test::randomJoints(robot.model, random);
      const Pose X_BT = robot.pose(q);
      const auto all = robot.inverse->solveAll(X_BT, q);
      const auto searched = (*numeric)->solveAll(X_BT, q);
      EXPECT_GE(all.size(), searched.size());
      for (const AlternativeSolution& one : searched) {
        EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                                [&](const AlternativeSolution& other) { return robot.same(one.q, other.q, 1e-4); }))
            << robot.inverse->name() << " " << i;
      }
    }
  }
}

TEST(AnalyticInverse, NearestSolutionIsTheNearestOfTheList) {
  const Robot robot(test::kr120());
  std::mt19937_64 random(29);
  for (int i = 0; i < 100; ++i) {
    const Pose X_BT = robot.pose(test::randomJoints(robot.model, random));
    const std::vector<double> q = test::randomJoints(robot.model, random);
    const InverseSolution solution = robot.inverse->solve(X_BT, q);
    for (const AlternativeSolution& one : robot.inverse->solveAll(X_BT, q)) {
      if (!one.within_limits) continue;
      EXPECT_LE(distanceSquared(*robot.inverse->chain(), robot.chainPositions(solution.q), robot.chainPositions(q)),
                distanceSquared(*robot.inverse->chain(), robot.chainPositions(one.q), robot.chainPositions(q)) + 1e-9);
      break;  // the list is sorted
    }
  }
}

// Joint `joint` at `angle` from the singular place: the previous joints are answered again.
void expectKept(const Robot& robot, std::vector<double> q, std::size_t singular, double at, std::size_t kept) {
  for (const double off : {0.0, 1e-12, -1e-12, 1e-10, 1e-8, -1e-6, 1e-4, 1e-3}) {
    q[singular] = at + off;
    const InverseSolution solution = robot.inverse->solve(robot.pose(q), q);
    ASSERT_EQ(solution.status, InverseStatus::kSolved) << off;
    EXPECT_LT(worstError(solution), 1e-12) << off;
    EXPECT_NEAR(solution.q[kept], q[kept], 5e-3) << robot.inverse->name() << " " << off;
  }
}

TEST(AnalyticInverse, KeepsTheJointThatASingularPoseLeavesFree) {
  std::mt19937_64 random(31);
  const Robot opw(test::kr120()), ur(test::ur5e());
  for (int i = 0; i < 20; ++i) {
    expectKept(opw, test::randomJoints(opw.model, random), 4, 0.0, 3);
    expectKept(ur, test::randomJoints(ur.model, random), 4, 0.0, 5);
  }
}

TEST(AnalyticInverse, KeepsJointOneWithTheWristOverAxisOne) {
  // Joint 3 so that the wrist centre comes to stand on axis 1, found by halving.
  const Robot robot(test::kr120());
  const auto radius = [&](double a3) {
    ChainState state;
    robot.inverse->chain()->evaluate({0.4, -2.2, a3, 0.3, 0.5, 0.1}, state);
    const dvec3 p = state.origin_B[5];
    return p.x * std::cos(0.4) - p.y * std::sin(0.4);  // axis 1 points down
  };
  double a = -0.5, b = 1.5;
  ASSERT_LT(radius(a) * radius(b), 0.0);
  for (int i = 0; i < 200; ++i) (radius(0.5 * (a + b)) * radius(a) > 0.0 ? a : b) = 0.5 * (a + b);
  const std::vector<double> q = {0.4, -2.2, a, 0.3, 0.5, 0.1};
  const InverseSolution solution = robot.inverse->solve(robot.pose(q), q);
  ASSERT_EQ(solution.status, InverseStatus::kSolved);
  EXPECT_LT(worstError(solution), 1e-12);
  EXPECT_NEAR(solution.q[0], 0.4, 1e-2);
}

TEST(AnalyticInverse, TellsALimitFromThatWhichIsOutOfReach) {
  RobotModel model = test::kr120();
  const Robot wide(model);
  const std::vector<double> q = {0.5, -1.2, 1.5, 0.3, 0.7, 0.2};
  const Pose X_BT = wide.pose(q);
  model.joints[0].lower = -0.1;
  model.joints[0].upper = 0.1;
  const Robot narrow(model);
  const InverseSolution limited = narrow.inverse->solve(X_BT, std::vector<double>(6, 0.0));
  EXPECT_EQ(limited.status, InverseStatus::kLimit);
  EXPECT_GT(limited.position_error + limited.orientation_error, 1e-3);
  const InverseSolution far = wide.inverse->solve({X_BT.p + dvec3(5, 0, 0), X_BT.q}, q);
  EXPECT_EQ(far.status, InverseStatus::kUnreachable);
  EXPECT_GT(far.position_error, 1.0);
}

TEST(AnalyticInverse, MovesARailOnlyAsFarAsItHelps) {
  const Robot robot(test::onSlides(test::kr120(), 1));
  EXPECT_EQ(robot.inverse->name(), "rail+opw");
  std::mt19937_64 random(37);
  for (int i = 0; i < 40; ++i) {
    const std::vector<double> q = test::randomJoints(robot.model, random),
                              q_start = test::randomJoints(robot.model, random);
    const InverseSolution solution = robot.inverse->solve(robot.pose(q), q_start);
    ASSERT_EQ(solution.status, InverseStatus::kSolved) << i;
    EXPECT_LT(worstError(solution), 1e-12);
    // No farther than the joints that made the pose.
    EXPECT_LE(distanceSquared(*robot.inverse->chain(), robot.chainPositions(solution.q), robot.chainPositions(q_start)),
              distanceSquared(*robot.inverse->chain(), robot.chainPositions(q), robot.chainPositions(q_start)) + 1e-3);
  }
}

TEST(AnalyticInverse, SevenJointsComeNearerThanTheOnesThatMadeThePose) {
  for (const auto& make : {test::iiwa, test::panda}) {
    const Robot robot(make());
    std::mt19937_64 random(41);
    for (int i = 0; i < 20; ++i) {
      const std::vector<double> q = test::randomJoints(robot.model, random),
                                q_start = test::randomJoints(robot.model, random);
      const InverseSolution solution = robot.inverse->solve(robot.pose(q), q_start);
      ASSERT_EQ(solution.status, InverseStatus::kSolved);
      const Chain& chain = *robot.inverse->chain();
      EXPECT_LE(distanceSquared(chain, robot.chainPositions(solution.q), robot.chainPositions(q_start)),
                distanceSquared(chain, robot.chainPositions(q), robot.chainPositions(q_start)) + 0.05);
    }
  }
}

TEST(AnalyticInverse, PolishesACalibratedArm) {
  for (const auto& make : {test::kr120, test::ur5e}) {
    const Robot robot(test::calibrated(make()));
    EXPECT_NE(robot.inverse->name().find("calibrated"), std::string::npos);
    std::mt19937_64 random(43);
    int own = 0;
    constexpr int kPoses = 200;
    for (int i = 0; i < kPoses; ++i) {
      const std::vector<double> q = test::randomJoints(robot.model, random);
      const InverseSolution solution = robot.inverse->solve(robot.pose(q), std::vector<double>(6, 0.1));
      ASSERT_EQ(solution.status, InverseStatus::kSolved) << i;
      EXPECT_LT(worstError(solution), 1e-9);
      const auto all = robot.inverse->solveAll(robot.pose(q), q);
      own += std::any_of(all.begin(), all.end(), [&](const auto& one) { return robot.same(one.q, q, 1e-4); }) ? 1 : 0;
    }
    EXPECT_GE(own, kPoses * 96 / 100);
  }
}

TEST(AnalyticInverse, FollowsAPathWithoutAJump) {
  for (const auto& make : {test::kr120, test::ur5e, test::offsetWrist, test::iiwa}) {
    const Robot robot(make());
    std::vector<double> q(robot.model.dof(), 0.6);
    if (robot.model.joints[1].upper < 0.7) q[1] = -0.9;
    const Pose X_0 = robot.pose(q);
    InverseSolution solution;
    solution.q = q;
    for (int i = 0; i <= 500; ++i) {
      const double t = i * 1e-3;
      const Pose X_BT =
          displaced(X_0, {dvec3(0.04 * std::sin(6 * t), 0.03 * t, -0.03 * t), dvec3(0.2 * t, 0, 0.1 * t)});
      const std::vector<double> before = solution.q;
      robot.inverse->solveNearest(X_BT, before, 1e-3, solution);
      ASSERT_EQ(solution.status, InverseStatus::kSolved) << robot.inverse->name() << " " << i;
      ASSERT_LT(worstError(solution), 1e-9);
      ASSERT_LE(test::largestStep(before, solution.q), 3.2e-3);
    }
  }
}

// The tool is turned about a line that makes joint 5 pass zero sideways: joints 4 and 6 would have to swing by half a
// turn at once.
TEST(AnalyticInverse, PassesTheWristSingularityAtTheJointsSpeed) {
  for (const SingularityChoice choice :
       {SingularityChoice::kKeepPosition, SingularityChoice::kKeepJoint4, SingularityChoice::kKeepOrientation}) {
    InverseOptions options;
    options.at_singularity = choice;
    const Robot robot(test::kr120(), options);
    const std::vector<double> q = {0.0, -1.3, 1.4, 0.0, 0.1, 0.0};
    const Pose X_0 = robot.pose(q);
    ChainState state;
    robot.inverse->chain()->evaluate(robot.chainPositions(q), state);
    // First past j5 = 0 with a little sideways, then back.
    InverseSolution solution;
    solution.q = q;
    double worst_position = 0.0, joint_4 = 0.0;
    for (int i = 0; i <= 2000; ++i) {
      const double s = std::sin(std::numbers::pi * i / 1000.0);
      const Pose X_BT = displaced(X_0, {dvec3(0.0), -0.2 * s * state.axis_B[4] + 0.003 * s * state.axis_B[2] +
                                                        0.004 * s * glm::cross(state.axis_B[4], state.axis_B[5])});
      const std::vector<double> before = solution.q;
      robot.inverse->solveNearest(X_BT, before, 1e-3, solution);
      worst_position = std::max(worst_position, solution.position_error);
      joint_4 = std::max(joint_4, std::abs(solution.q[3]));
      for (std::size_t k = 0; k < 6; ++k) {
        ASSERT_LE(std::abs(solution.q[k] - before[k]), 3.0e-3 + 1e-12) << i;
        ASSERT_GE(solution.q[k], robot.model.joints[k].lower);
        ASSERT_LE(solution.q[k], robot.model.joints[k].upper);
      }
    }
    if (choice != SingularityChoice::kKeepOrientation) {
      EXPECT_LT(worst_position, 2e-4);
    }
    EXPECT_LT(worstError(solution), 1e-6);  // back where it began
  }
}

/// The way of the wrist's first joint (rad in all) while the tool turns through the wrist's straight position and a
/// little past its side, and how far the position is off at most.
struct ThroughTheWrist {
  double travel = 0.0;
  double off = 0.0;
};

ThroughTheWrist throughTheWrist(const RobotModel& model, const std::vector<double>& q_start, SingularityChoice choice) {
  InverseOptions options;
  options.at_singularity = choice;
  const Robot robot(model, options);
  const auto wrist = static_cast<std::size_t>(wristJoint(*robot.inverse->chain()));
  ChainState state;
  robot.inverse->chain()->evaluate(robot.chainPositions(q_start), state);
  const Pose X_0 = robot.pose(q_start);
  InverseSolution solution;
  solution.q = q_start;
  ThroughTheWrist result;
  for (int i = 0; i <= 500; ++i) {
    const double s = std::sin(std::numbers::pi * i / 1000.0);
    const dvec3 &middle = state.axis_B[wrist + 1], &last = state.axis_B[wrist + 2];
    const Pose X_BT = displaced(X_0, {dvec3(0.0), -0.2 * s * middle + 0.004 * s * glm::cross(middle, last)});
    const std::vector<double> before = solution.q;
    robot.inverse->solveNearest(X_BT, before, 1e-3, solution);
    result.off = std::max(result.off, solution.position_error);
    result.travel += std::abs(solution.q[wrist] - before[wrist]);
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_LE(std::abs(solution.q[k] - before[k]), greatestSpeed(robot.model.joints[k]) * 1e-3 + 1e-12) << i;
    }
  }
  return result;
}

TEST(AnalyticInverse, TheFirstJointOfAnyWristCanBeKeptAtRest) {
  struct Case {
    RobotModel model;
    std::vector<double> q;
    int wrist;
    bool swings;  ///< Else it gets round: by its seventh joint, or by the offset of its wrist.
  };
  const Case cases[] = {{test::kr120(), {0.0, -1.3, 1.4, 0.0, 0.1, 0.0}, 3, true},
                        {test::ur5e(), {0.2, -1.2, 1.4, 0.3, 0.1, 0.2}, 3, true},
                        {test::offsetWrist(), {0.2, -0.9, 0.8, 0.3, 0.1, 0.2}, 3, false},
                        {test::sphericalWrist(), {0.2, -0.9, 0.8, 0.3, 0.1, 0.2}, 3, true},
                        {test::iiwa(), {0.2, 0.6, 0.1, -1.2, 0.3, 0.1, 0.2}, 4, false}};
  for (const Case& one : cases) {
    const Robot robot(one.model);
    ASSERT_EQ(wristJoint(*robot.inverse->chain()), one.wrist) << robot.inverse->name();
    const ThroughTheWrist swinging = throughTheWrist(one.model, one.q, SingularityChoice::kKeepPosition);
    const ThroughTheWrist resting = throughTheWrist(one.model, one.q, SingularityChoice::kKeepJoint4);
    EXPECT_LT(resting.off, 2e-4) << robot.inverse->name();
    EXPECT_LE(resting.travel, (one.swings ? 0.9 : 1.001) * swinging.travel)
        << robot.inverse->name() << " " << resting.travel << " of " << swinging.travel;
  }
  EXPECT_EQ(wristJoint(*Robot(test::scara()).inverse->chain()), -1);
}

TEST(AnalyticInverse, GoesOutOfReachAndComesBackTheSameWay) {
  for (const auto& make : {test::kr120, test::ur5e, test::offsetWrist}) {
    const Robot robot(make());
    std::vector<double> q = {0.2, -0.9, 0.8, 0.3, 0.7, 0.2};
    const Pose X_0 = robot.pose(q);
    const dvec3 out = glm::normalize(X_0.p - dvec3(0, 0, 0.5));
    InverseSolution solution;
    solution.q = q;
    bool was_out = false;
    for (int i = 0; i <= 9000; ++i) {  // and a second at rest
      const double s = i > 8000 ? 0.0 : 1.5 * std::sin(std::numbers::pi * i / 8000.0);
      const std::vector<double> before = solution.q;
      robot.inverse->solveNearest({X_0.p + s * out, X_0.q}, before, 1e-3, solution);
      was_out = was_out || solution.position_error > 0.3;
      ASSERT_LE(test::largestStep(before, solution.q), 7e-3);
    }
    EXPECT_TRUE(was_out);
    EXPECT_LT(test::largestStep(solution.q, q), 1e-3) << robot.inverse->name();
  }
}

}  // namespace
}  // namespace hapticell::kinematics
