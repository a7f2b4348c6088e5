// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/configuration_flags.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/solution_list.h"
#include "kinematics/model/start_posture.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

std::array<double, 6> degrees(const std::array<double, 6>& angles) {
  std::array<double, 6> q = angles;
  for (double& angle : q) angle *= kDegree;
  return q;
}

ArmShape shapeOf(const RobotModel& model, const std::array<double, 6>& q) {
  ChainPositions x{};
  std::copy(q.begin(), q.end(), x.begin());
  const auto shape = armShape(*Chain::create(model, model.defaultTip(), Pose::identity()), x);
  EXPECT_TRUE(shape);
  return shape.value_or(ArmShape{});
}

TEST(ConfigurationFlags, KukaHomeIsStatusTwoTurnTwo) {
  const auto q = degrees({0, -90, 90, 0, 0, 0});
  const ArmShape shape = shapeOf(test::kr120(), q);
  EXPECT_EQ(makerFlags(Maker::kKuka, shape, q), "S 2, T 2");
  EXPECT_EQ(toString(shape), "front, elbow up, wrist not flipped");
}

TEST(ConfigurationFlags, OfAStraightWristRoundingDoesNotChooseTheName) {
  const RobotModel model = test::kr120();
  for (const double rest : {-1e-8, 0.0, 1e-8}) {
    const std::array<double, 6> q{0.0, -std::numbers::pi / 2.0, std::numbers::pi / 2.0, 0.0, rest, 0.0};
    EXPECT_EQ(toString(shapeOf(model, q)), "front, elbow up, wrist not flipped") << rest;
  }
}

TEST(StartPosture, OfARobotThatIsSingularAtRestOneOrTwoJointsAreBent) {
  const RobotModel model = test::kr120();
  const int tip = model.defaultTip();
  const auto start = bentStart(model, tip);
  ASSERT_TRUE(start) << "its wrist is straight at zero";
  EXPECT_GE(start->bent_joints.size(), 1u);
  EXPECT_LE(start->bent_joints.size(), 2u);
  RobotModel at_home = model;
  at_home.home = start->q;
  EXPECT_FALSE(bentStart(at_home, tip)) << "from there nothing needs to be bent";
}

TEST(ConfigurationFlags, KukaBitsFollowTheirJoints) {
  const auto overhead = degrees({0, -150, 40, 0, 30, 0});
  EXPECT_EQ(kukaFlags(shapeOf(test::kr120(), overhead), overhead).status & 1, 1);
  const auto flipped = degrees({-10, -90, 90, -20, -30, 40});
  const KukaFlags flags = kukaFlags(shapeOf(test::kr120(), flipped), flipped);
  EXPECT_EQ(flags.status, 2 + 4);
  EXPECT_EQ(flags.turn, 1 + 2 + 8 + 16);
  // The bit of axis 3 changes where the wrist centre stands in line with axes 2 and 3: -2.35 deg for 41 mm on 1 m.
  EXPECT_EQ(kukaFlags(shapeOf(test::kr120(), degrees({0, -90, -5, 0, 0, 0})), {}).status & 2, 0);
  EXPECT_EQ(kukaFlags(shapeOf(test::kr120(), degrees({0, -90, -1, 0, 0, 0})), {}).status & 2, 2);
}

TEST(ConfigurationFlags, AbbQuadrants) {
  const AbbFlags flags = abbFlags(ArmShape{}, degrees({10, 0, 0, -10, -5, 190}));
  EXPECT_EQ(flags.cf1, 0);
  EXPECT_EQ(flags.cf4, -1);
  EXPECT_EQ(flags.cf6, 2);
  EXPECT_EQ(flags.cfx, 1);
  EXPECT_EQ(abbFlags(ArmShape{}, degrees({-95, 0, 0, 90, 5, -180})).cf1, -2);
}

TEST(ConfigurationFlags, FanucPublishedPair) {
  // R-2000iB/165F: the same point as N U T and F U T, turns zero.
  EXPECT_EQ(makerFlags(Maker::kFanuc, ArmShape{}, degrees({7.962, -5.284, -36.25, 77.661, -51.975, -79.273})),
            "N U T, 0, 0, 0");
  EXPECT_EQ(makerFlags(Maker::kFanuc, ArmShape{}, degrees({7.962, -5.284, -36.25, -102.339, 51.975, 100.727})),
            "F U T, 0, 0, 0");
}

TEST(ConfigurationFlags, EightSolutionsHaveEightNames) {
  for (const auto& make : {test::kr120, test::ur5e}) {
    RobotModel model = make();
    const auto inverse = createInverse(model, model.defaultTip());
    std::mt19937_64 random(3);
    int eights = 0;
    for (int i = 0; i < 50; ++i) {
      const std::vector<double> q = test::randomJoints(model, random);
      const auto list = listSolutions(model, **inverse, test::tipPose(model, q, model.defaultTip()), q);
      std::set<std::string> names;
      for (const ListedSolution& one : list) names.insert(one.configuration);
      EXPECT_EQ(names.size(), list.size()) << i;
      eights += list.size() == 8 ? 1 : 0;
    }
    EXPECT_GT(eights, 20);
  }
}

TEST(SolutionList, IsSortedAndSaysWhatIsInTheWay) {
  RobotModel model = test::kr120();
  model.links[0].name = "kuka_base";
  const auto inverse = createInverse(model, model.defaultTip());
  EXPECT_EQ(listSolutions(model, **inverse, test::tipPose(model, {0.3, -1.2, 1.4, 0.5, 0.8, -0.2}, 7),
                          {0.3, -1.2, 1.4, 0.5, 0.8, -0.2})[0]
                .maker_flags,
            "S 2, T 34");
  std::mt19937_64 random(9);
  int out = 0;
  for (int k = 0; k < 30; ++k) {
    const std::vector<double> q = test::randomJoints(model, random);
    const auto list = listSolutions(model, **inverse, test::tipPose(model, q, model.defaultTip()), q);
    ASSERT_FALSE(list.empty());
    EXPECT_TRUE(list[0].is_now);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const ListedSolution& one = list[i];
      EXPECT_EQ(one.within_limits, one.reason.empty());
      EXPECT_EQ(one.within_limits, one.limiting_joint < 0);
      EXPECT_TRUE(one.within_limits || i + 1 == list.size() || !list[i + 1].within_limits);
      if (one.within_limits) continue;
      ++out;
      const std::string& joint = model.joints[static_cast<std::size_t>(one.limiting_joint)].name;
      EXPECT_EQ(english(one.reason).find(joint + " would be "), 0U) << english(one.reason);
    }
  }
  EXPECT_GT(out, 10);
}

TEST(SolutionList, FullTurnsWithinLimitsAreListedWhenAskedFor) {
  const RobotModel model = test::kr120();
  const auto inverse = createInverse(model, model.defaultTip());
  std::mt19937_64 random(5);
  SolutionListOptions with_turns;
  with_turns.with_turns = true;
  for (int i = 0; i < 50; ++i) {
    const std::vector<double> q = test::randomJoints(model, random), q_now(6, 0.1);
    const Pose X_BT = test::tipPose(model, q, model.defaultTip());
    const auto list = listSolutions(model, **inverse, X_BT, q_now, with_turns);
    bool own = false;
    for (const ListedSolution& one : list) {
      double largest = 0.0;
      for (std::size_t k = 0; k < 6; ++k) largest = std::max(largest, std::abs(one.q[k] - q[k]));
      own = own || largest < 1e-6;
      const Pose X = test::tipPose(model, one.q, model.defaultTip());
      EXPECT_LT(glm::length(X.p - X_BT.p), 1e-9);
    }
    EXPECT_TRUE(own) << i;  // with its own turns of axes 4 and 6
    EXPECT_GT(list.size(), listSolutions(model, **inverse, X_BT, q_now).size());
  }
}

}  // namespace
}  // namespace hapticell::kinematics
