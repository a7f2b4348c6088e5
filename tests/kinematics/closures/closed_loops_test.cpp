// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/closures/arm_builder.h"
#include "kinematics/closures/delta_robot.h"
#include "kinematics/closures/hexapod_robot.h"
#include "kinematics/closures/joint_graph.h"
#include "kinematics/closures/loop_closure.h"

namespace hapticell::kinematics {
namespace {

DeltaGeometry dr3() {
  DeltaGeometry g;
  g.base_radius = 0.140;
  g.upper_arm = 0.565;
  g.lower_arm = 1.260;
  g.platform_radius = 0.075;
  g.rod_spacing = 0.1668;
  return g;
}

std::vector<JointData> joints(std::size_t n, double lower, double upper) {
  std::vector<JointData> data;
  for (std::size_t k = 0; k < n; ++k) data.push_back({"joint_" + std::to_string(k + 1), lower, upper, 3.0});
  return data;
}

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

TEST(Delta, RodsKeepTheirLengthOnAllEightBranches) {
  const DeltaKinematics delta(dr3());
  std::mt19937 random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const dvec3 p(between(random, -0.4, 0.4), between(random, -0.4, 0.4), between(random, -1.3, -0.9));
    DeltaBranches branches{};
    ASSERT_TRUE(delta.inverseAll(p, branches));
    for (const auto& theta : branches) {
      for (int k = 0; k < 3; ++k) {
        const dvec3 rod = delta.platformJoint(k, p) - delta.knee(k, theta[static_cast<std::size_t>(k)]);
        EXPECT_NEAR(glm::length(rod), 1.260, 1e-13);
      }
    }
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::size_t>(k);
      EXPECT_GT(glm::dot(delta.knee(k, branches[0][place]), delta.outward(k)),
                glm::dot(delta.knee(k, branches[7][place]), delta.outward(k)));
    }
    dvec3 back(0.0);
    ASSERT_TRUE(delta.forward(branches[0], back));
    EXPECT_NEAR(glm::length(back - p), 0.0, 1e-12);
  }
}

TEST(Delta, SaysWhenItDoesNotReach) {
  const DeltaKinematics delta(dr3());
  std::array<double, 3> outer{}, inner{};
  EXPECT_FALSE(delta.inverse({0, 0, -3.0}, outer, inner));
  dvec3 p(0.0);
  EXPECT_FALSE(delta.forward({-1.5, 3.1, 3.1}, p) && delta.forward({3.1, 3.1, 3.1}, p) && !std::isfinite(p.z));
}

RobotModel deltaRobot(std::size_t axes) {
  DeltaOptions options;
  options.tool_length = 0.06;
  return buildDelta("delta", dr3(), options, joints(axes, -0.7, 1.4), std::vector<double>(axes, 0.1)).value();
}

TEST(Delta, FollowsPosesByItsInverseModelAndTurnsItsTool) {
  const RobotModel model = deltaRobot(4);
  const auto inverse = createInverse(model, model.defaultTip());
  ASSERT_TRUE(inverse);
  EXPECT_EQ((*inverse)->name(), "delta");
  std::mt19937 random(2);
  std::vector<Pose> X_BL;
  std::vector<double> previous = restPositions(model);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<double> q{between(random, -0.2, 0.8), between(random, -0.2, 0.8), between(random, -0.2, 0.8),
                                between(random, -0.6, 1.3)};
    forwardKinematics(model, q, X_BL);
    const Pose X_BT = X_BL[static_cast<std::size_t>(model.defaultTip())];
    const InverseSolution solution = (*inverse)->solve(X_BT, previous);
    ASSERT_EQ(solution.status, InverseStatus::kSolved);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(solution.q[k], q[k], 1e-9);
    const auto all = (*inverse)->solveAll(X_BT, q);
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.front().configuration, "arm 1 out, arm 2 out, arm 3 out");
    previous = solution.q;
  }
  const InverseSolution tilted =
      (*inverse)->solve({{0, 0, -1.1}, glm::angleAxis(0.5, dvec3(1, 0, 0))}, restPositions(model));
  EXPECT_NE(tilted.status, InverseStatus::kSolved) << "a Delta does not tilt";
}

TEST(Delta, RestsAtTheEdgeOfItsReachWithoutJumping) {
  const RobotModel model = deltaRobot(3);
  const auto inverse = createInverse(model, model.defaultTip()).value();
  std::vector<double> q = restPositions(model);
  std::vector<Pose> X_BL;
  forwardKinematics(model, q, X_BL);
  Pose X = X_BL[static_cast<std::size_t>(model.defaultTip())];
  InverseSolution solution;
  for (int step = 0; step < 400; ++step) {
    X.p.x += 0.005;
    inverse->solveNearest(X, q, kUnboundedDuration, solution);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT(std::abs(solution.q[k] - q[k]), 0.2);
      EXPECT_GE(solution.q[k], -0.7 - 1e-12);
      EXPECT_LE(solution.q[k], 1.4 + 1e-12);
    }
    q = solution.q;
  }
  EXPECT_NE(solution.status, InverseStatus::kSolved);
  EXPECT_GT(solution.position_error, 0.1);
}

HexapodGeometry platform() {
  HexapodGeometry g;
  const double low[] = {50, 70, 170, 190, 290, 310}, high[] = {10, 110, 130, 230, 250, 350};
  for (std::size_t i = 0; i < 6; ++i) {
    g.p_BA[i] = 0.8 * dvec3(std::cos(low[i] * std::numbers::pi / 180), std::sin(low[i] * std::numbers::pi / 180), 0);
    g.p_PC[i] = 0.5 * dvec3(std::cos(high[i] * std::numbers::pi / 180), std::sin(high[i] * std::numbers::pi / 180), 0);
  }
  return g;
}

Pose randomPose(std::mt19937& random) {
  const dvec3 turn(between(random, -0.25, 0.25), between(random, -0.25, 0.25), between(random, -0.25, 0.25));
  return {{between(random, -0.15, 0.15), between(random, -0.15, 0.15), between(random, 0.8, 1.05)},
          quaternionFromRotationVector(turn)};
}

TEST(Hexapod, NewtonFindsThePoseThatMadeTheLegsAndProvesIt) {
  const HexapodKinematics hexapod(platform());
  const Pose home = Pose::translation({0, 0, 0.9});
  const int handedness = hexapod.regularity(home) > 0.0 ? 1 : -1;
  std::mt19937 random(3);
  int checked = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Pose X = randomPose(random);
    if (hexapod.regularity(X) * handedness <= 0.0) continue;  // Beyond a singular surface: another assembly.
    const HexapodForward forward = hexapod.forward(hexapod.lengths(X), home);
    ASSERT_TRUE(forward.converged);
    EXPECT_NEAR(glm::length(forward.X_BP.p - X.p), 0.0, 1e-10);
    EXPECT_NEAR(glm::length(difference(forward.X_BP, X).angular), 0.0, 1e-10);
    const HexapodCertificate certificate = hexapod.certify(hexapod.lengths(X), forward.X_BP);
    EXPECT_EQ(forward.handedness, handedness);
    EXPECT_TRUE(certificate.holds);
    EXPECT_LT(certificate.exists_within, 1e-10);
    EXPECT_GT(certificate.unique_within, 1e-4);
    ++checked;
  }
  EXPECT_GT(checked, 450);
  LegLengths far = hexapod.lengths(home);
  far[0] += 0.2;
  EXPECT_FALSE(hexapod.certify(far, home).holds);
}

TEST(LoopKernels, BothBuildsAgree) {
  const kernels::LoopTable* fast = kernels::avx2LoopTable();
  if (fast == nullptr) GTEST_SKIP() << "no AVX2 here";
  const kernels::LoopTable& plain = *kernels::plainLoopTable();
  kernels::DeltaArms arms{{1, -0.5, -0.5, -0.5}, {0, 0.866, -0.866, -0.866}, 0.14, 0.565, 1.26, 0.075, -1.0};
  kernels::HexapodHinges hinges{};
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 8; ++i) {
      hinges.base[axis][i] = platform().p_BA[std::min<std::size_t>(i, 5)][axis];
      hinges.top[axis][i] = platform().p_PC[std::min<std::size_t>(i, 5)][axis];
    }
  }
  std::mt19937 random(5);
  alignas(32) double a[2][8], b[2][8];
  for (int trial = 0; trial < 200; ++trial) {
    const dvec3 p(between(random, -0.9, 0.9), between(random, -0.9, 0.9), between(random, -1.5, -0.5));
    const unsigned reached = plain.deltaInverse(arms, &p.x, a[0], a[1]);
    EXPECT_EQ(fast->deltaInverse(arms, &p.x, b[0], b[1]), reached);
    for (int k = 0; k < 4; ++k) {
      if (reached >> k & 1U) {
        EXPECT_NEAR(a[0][k], b[0][k], 1e-9);
      } else {
        EXPECT_TRUE(std::isnan(a[0][k]) && std::isnan(b[0][k]));
      }
    }
    const Pose X = randomPose(random);
    const dmat3 rows = glm::transpose(X.R());
    double step[2][6], determinant[2];
    const double wanted[8] = {1.0, 1.01, 0.99, 1.0, 1.02, 1.0, 1.0, 1.0};
    const double error = plain.hexapodStep(hinges, &rows[0][0], &X.p.x, wanted, step[0], &determinant[0]);
    EXPECT_NEAR(fast->hexapodStep(hinges, &rows[0][0], &X.p.x, wanted, step[1], &determinant[1]), error, 1e-12);
    EXPECT_NEAR(determinant[0], determinant[1], 1e-9);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(step[0][k], step[1][k], 1e-8 * (1.0 + std::abs(step[0][k])));
  }
}

TEST(Hexapod, IsDraggedWithinItsLegsAndToldWhereTheyEnd) {
  HexapodOptions options;
  options.X_BPHome = Pose::translation({0, 0, 0.9});
  options.tool_length = 0.1;
  const RobotModel model = buildHexapod("hexapod", platform(), options, joints(6, 0.8, 1.3)).value();
  const auto inverse = createInverse(model, model.defaultTip()).value();
  EXPECT_EQ(inverse->name(), "hexapod");
  std::mt19937 random(4);
  std::vector<Pose> X_BL;
  int solved = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Pose X_BT = randomPose(random) * Pose::translation({0, 0, 0.1});
    const InverseSolution solution = inverse->solve(X_BT, model.home);
    if (solution.status != InverseStatus::kSolved) continue;
    ++solved;
    forwardKinematics(model, solution.q, X_BL);
    const Twist left = difference(X_BL[static_cast<std::size_t>(model.defaultTip())], X_BT);
    EXPECT_NEAR(glm::length(left.linear) + glm::length(left.angular), 0.0, 1e-9);
  }
  EXPECT_GT(solved, 60);
  InverseSolution slow;
  inverse->solveNearest(Pose::translation({0.05, 0, 1.05}), model.home, 1e-3, slow);  // 3 m/s: 3 mm in that time.
  for (std::size_t k = 0; k < 6; ++k) EXPECT_LE(std::abs(slow.q[k] - model.home[k]), 3e-3 + 1e-12);
  EXPECT_NE(slow.status, InverseStatus::kSolved);
  InverseSolution far;
  inverse->solveNearest(Pose::translation({0, 0, 3.0}), model.home, kUnboundedDuration, far);
  EXPECT_EQ(far.status, InverseStatus::kLimit);
  for (const double length : far.q) EXPECT_LE(length, 1.3 + 1e-12);
}

TEST(Hexapod, RefusesAHomeThatIsSingularOrOutOfItsLegs) {
  HexapodOptions options;
  options.X_BPHome = Pose::translation({0, 0, 3.0});
  const auto too_far = buildHexapod("h", platform(), options, joints(6, 0.8, 1.3));
  ASSERT_FALSE(too_far);
  EXPECT_NE(too_far.error().message().find("leg_1"), std::string::npos);
  HexapodGeometry same = platform();
  same.p_PC = same.p_BA;
  for (dvec3& p : same.p_PC) p *= 0.5;  // Similar hexagons: Fichter's singular case.
  options.X_BPHome = Pose::translation({0, 0, 0.9});
  const auto singular = buildHexapod("h", same, options, joints(6, 0.1, 3.0));
  ASSERT_FALSE(singular);
  EXPECT_NE(singular.error().message().find("singular"), std::string::npos);
}

/// The hexapod again, as bodies and joints: the general solver must agree with the closed form.
JointGraph hexapodGraph(const HexapodGeometry& g, const Pose& X_BP) {
  JointGraph graph;
  graph.name = "graph";
  const auto add = [&](const std::string& name, const Pose& X) {
    Link link;
    link.name = name;
    graph.links.push_back({link, X});
    return static_cast<int>(graph.links.size()) - 1;
  };
  const int base = add("base", {}), top = add("platform", X_BP);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string leg = "leg_" + std::to_string(i + 1);
    const dvec3 a = g.p_BA[i], b = X_BP * g.p_PC[i];
    const int lower = add(leg + "_lower", Pose::translation(a)), upper = add(leg + "_upper", Pose::translation(b));
    const auto joint = [&](const std::string& name, int from, int to, const dvec3& p, JointType type) {
      GraphJoint made;
      made.joint.name = leg + name;
      made.joint.type = type;
      made.joint.parent_link = from;
      made.joint.child_link = to;
      made.joint.lower = -2.0;
      made.joint.upper = 2.0;
      made.X_MJ = Pose::translation(p);
      return made;
    };
    addCompoundJoint(graph, joint(" hinge", base, lower, a, JointType::kRevolute), {{1, 0, 0}, {0, 1, 0}});
    addCompoundJoint(graph, joint("", lower, upper, b, JointType::kPrismatic), {glm::normalize(b - a)});
    addCompoundJoint(graph, joint(" ball", top, upper, b, JointType::kRevolute), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  }
  return graph;
}

TEST(Loops, AHexapodOfJointsAgreesWithTheClosedForm) {
  const Pose home = Pose::translation({0, 0, 0.9});
  const auto model = modelOfGraph(hexapodGraph(platform(), home));
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(model->dof(), 6u);
  const HexapodKinematics hexapod(platform());
  const LegLengths at_home = hexapod.lengths(home);
  std::vector<Pose> X_BL;
  for (const dvec3& p : {dvec3(0.05, 0, 0.95), dvec3(-0.1, 0.08, 0.85), dvec3(0, 0, 1.0)}) {
    const Pose X{p, glm::angleAxis(0.15, glm::normalize(dvec3(1, 2, -1)))};
    const LegLengths wanted = hexapod.lengths(X);
    std::vector<double> q;
    for (const int index : model->moving) {
      const std::string& name = model->joints[static_cast<std::size_t>(index)].name;
      ASSERT_EQ(name.size(), 5u) << name << " should be a leg";
      const auto leg = static_cast<std::size_t>(name.back() - '1');
      q.push_back(wanted[leg] - at_home[leg]);
    }
    forwardKinematics(*model, q, X_BL);
    const Twist left = difference(X_BL[static_cast<std::size_t>(model->findLink("platform"))], X);
    EXPECT_NEAR(glm::length(left.linear) + glm::length(left.angular), 0.0, 1e-9);
    const auto inverse = createInverse(*model, model->findLink("platform")).value();
    EXPECT_EQ(inverse->name(), "loops");
    const InverseSolution solution = inverse->solve(X, restPositions(*model));
    ASSERT_EQ(solution.status, InverseStatus::kSolved);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(solution.q[k], q[k], 1e-7);
  }
}

TEST(ArmBuilder, OpwStandsStraightUpAtItsZeroAndDhConventionsAgree) {
  OpwParameters p{0.05, -0.035, 0.0, 0.33, 0.33, 0.335, 0.08, {}, {1, 1, -1, -1, -1, -1}};
  const RobotModel arm = buildOpw("arm", p, joints(6, -3, 3));
  std::vector<Pose> X_BL;
  forwardKinematics(arm, std::vector<double>(6, 0.0), X_BL);
  EXPECT_NEAR(glm::length(X_BL.back().p - dvec3(0.015, 0.0, 1.075)), 0.0, 1e-12);
  const auto inverse = createInverse(arm, arm.defaultTip()).value();
  EXPECT_EQ(inverse->name(), "opw");
  // A planar arm of two links, said in both conventions.
  const RobotModel standard =
      buildDh("standard", DhConvention::kStandard, {{0.1, 0.2, 0.5, 0.0}, {0.3, 0.0, 0.4, std::numbers::pi / 2}},
              joints(2, -3, 3), {});
  const RobotModel modified =
      buildDh("modified", DhConvention::kModified, {{0.1, 0.2, 0.0, 0.0}, {0.3, 0.0, 0.5, 0.0}}, joints(2, -3, 3),
              {{0.4, 0, 0}, glm::angleAxis(std::numbers::pi / 2, dvec3(1, 0, 0))});
  std::vector<Pose> X_Other;
  forwardKinematics(standard, {0.4, -0.9}, X_BL);
  forwardKinematics(modified, {0.4, -0.9}, X_Other);
  const Twist left = difference(X_BL.back(), X_Other.back());
  EXPECT_NEAR(glm::length(left.linear) + glm::length(left.angular), 0.0, 1e-12);
}

}  // namespace
}  // namespace hapticell::kinematics
