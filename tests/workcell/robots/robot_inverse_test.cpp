// SPDX-License-Identifier: Apache-2.0
// Inverse kinematics of real robots as their makers describe them: the reader and the solver together.
#include <gtest/gtest.h>

#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/numeric/numeric_inverse.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/support/test_data.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::workcell {
namespace {

using kinematics::InverseStatus;
using kinematics::NumericInverse;
using kinematics::RobotModel;

class RealInverse : public ::testing::TestWithParam<const char*> {};

bool withinLimits(const RobotModel& model, const std::vector<double>& q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    if (q[i] < joint.lower || q[i] > joint.upper) return false;
  }
  return true;
}

TEST_P(RealInverse, SolvesRandomReachablePosesFromRandomStarts) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, std::string("robots/") + GetParam() + "/robot.urdf");
  Diagnostics diagnostics;
  const auto model = readUrdf(file, diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  const int tip = model->defaultTip();
  const auto inverse = NumericInverse::create(*model, tip);
  ASSERT_TRUE(inverse) << inverse.error().message();
  std::mt19937_64 random(11);
  int solved = 0;
  constexpr int kPoses = 150;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_BT = kinematics::test::tipPose(*model, kinematics::test::randomJoints(*model, random), tip);
    const auto solution = (*inverse)->solve(X_BT, kinematics::test::randomJoints(*model, random));
    ASSERT_TRUE(withinLimits(*model, solution.q));
    if (solution.status != InverseStatus::kSolved) continue;
    ++solved;
    // What the solver says of itself is checked by forward kinematics.
    const Twist error = difference(kinematics::test::tipPose(*model, solution.q, tip), X_BT);
    ASSERT_LT(glm::length(error.linear), 1e-8);
    ASSERT_LT(glm::length(error.angular), 1e-8);
  }
  EXPECT_EQ(solved, kPoses);
}

const char* classOf(const std::string& robot) {
  if (robot == "ur5e") return "ur";
  if (robot == "franka_fer") return "panda";
  if (robot == "denso_hsr065_scara") return "scara";
  if (robot == "omnid_delta_tree") return "numeric";  // three joints of one leg; its loops are not in the file
  return "opw";
}

TEST_P(RealInverse, IsRecognisedAndSolvedInClosedForm) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, std::string("robots/") + GetParam() + "/robot.urdf");
  Diagnostics diagnostics;
  const auto model = readUrdf(file, diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  const int tip = model->defaultTip();
  const auto inverse = kinematics::createInverse(*model, tip);
  ASSERT_TRUE(inverse) << inverse.error().message();
  ASSERT_EQ((*inverse)->name(), classOf(GetParam()));
  if ((*inverse)->name() == "numeric") return;
  std::mt19937_64 random(13);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> q = kinematics::test::randomJoints(*model, random);
    const Pose X_BT = kinematics::test::tipPose(*model, q, tip);
    const auto solution = (*inverse)->solve(X_BT, kinematics::test::randomJoints(*model, random));
    ASSERT_EQ(solution.status, InverseStatus::kSolved) << i;
    ASSERT_TRUE(withinLimits(*model, solution.q));
    const Twist error = difference(kinematics::test::tipPose(*model, solution.q, tip), X_BT);
    ASSERT_LT(glm::length(error.linear), 1e-12);
    ASSERT_LT(glm::length(error.angular), 1e-12);
    // The joints that made the pose are in the list (seven joints: their own redundancy is tried first).
    const auto all = (*inverse)->solveAll(X_BT, q);
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const auto& one) {
      double largest = 0.0;
      for (std::size_t k = 0; k < q.size(); ++k) largest = std::max(largest, std::abs(one.q[k] - q[k]));
      return largest < 1e-5;
    })) << i;
  }
}

TEST_P(RealInverse, FollowsAStraightPathWithoutJumps) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, std::string("robots/") + GetParam() + "/robot.urdf");
  Diagnostics diagnostics;
  const auto model = readUrdf(file, diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  const int tip = model->defaultTip();
  const auto inverse = kinematics::createInverse(*model, tip);
  ASSERT_TRUE(inverse);
  std::mt19937_64 random(12);
  kinematics::InverseSolution solution;
  for (int path = 0; path < 50; ++path) {
    // From one reachable pose towards another, 500 mm/s or so, wherever that leads: limits, singularities, outside.
    solution.q = kinematics::test::randomJoints(*model, random);
    const Pose X_0 = kinematics::test::tipPose(*model, solution.q, tip);
    const Pose X_1 = kinematics::test::tipPose(*model, kinematics::test::randomJoints(*model, random), tip);
    for (int i = 1; i <= 500; ++i) {
      const std::vector<double> before = solution.q;
      (*inverse)->solveNearest(interpolate(X_0, X_1, i / 2000.0), before, 1e-3, solution);
      ASSERT_TRUE(withinLimits(*model, solution.q));
      for (std::size_t j = 0; j < before.size(); ++j) {
        const auto& joint = model->joints[static_cast<std::size_t>(model->moving[j])];
        ASSERT_LE(std::abs(solution.q[j] - before[j]), (joint.velocity > 0.0 ? joint.velocity : 3.15) * 1e-3 + 1e-12)
            << joint.name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, RealInverse,
                         ::testing::Values("kuka_kr120r2500pro", "abb_irb4600_60_205", "fanuc_lrmate200id", "ur5e",
                                           "franka_fer", "denso_hsr065_scara", "omnid_delta_tree"),
                         [](const auto& case_info) { return std::string(case_info.param); });

}  // namespace
}  // namespace hapticell::workcell
