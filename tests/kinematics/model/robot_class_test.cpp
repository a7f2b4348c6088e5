// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/robot_class.h"

#include <gtest/gtest.h>

#include "kinematics/closed_form/inverse_factory.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

Chain chainOf(const RobotModel& model) {
  return *Chain::create(model, model.defaultTip(), Pose::identity());
}

TEST(RobotClass, IsToldFromTheAxesAlone) {
  const std::pair<RobotModel, RobotClass> robots[] = {{test::kr120(), RobotClass::kOpw},
                                                      {test::ur5e(), RobotClass::kUr},
                                                      {test::iiwa(), RobotClass::kSrs},
                                                      {test::panda(), RobotClass::kPanda},
                                                      {test::scara(), RobotClass::kScara},
                                                      {test::sphericalWrist(), RobotClass::kSphericalWrist},
                                                      {test::sphericalBase(), RobotClass::kSphericalBase},
                                                      {test::offsetWrist(), RobotClass::kOffsetWrist}};
  for (const auto& [model, robot_class] : robots) {
    const Classification found = classify(chainOf(model));
    EXPECT_EQ(found.robot_class, robot_class) << toString(robot_class);
    EXPECT_FALSE(found.calibrated);
    EXPECT_EQ(found.rails, 0u);
  }
}

TEST(RobotClass, DoesNotDependOnWhereTheArmStands) {
  RobotModel model = test::kr120();
  model.joints[0].X_PJ =
      Pose{{1.0, -2.0, 0.3}, glm::angleAxis(1.1, glm::normalize(dvec3(1, 2, 3)))} * model.joints[0].X_PJ;
  EXPECT_EQ(classify(chainOf(model)).robot_class, RobotClass::kOpw);
}

TEST(RobotClass, SlidesInFrontAreCounted) {
  EXPECT_EQ(describe(classify(chainOf(test::onSlides(test::kr120(), 1)))), "rail+opw");
  EXPECT_EQ(describe(classify(chainOf(test::onSlides(test::ur5e(), 3)))), "gantry+ur");
}

TEST(RobotClass, ToleranceDecidesBetweenExactCalibratedAndNumeric) {
  RobotModel model = test::ur5e();
  model.joints[2].X_PJ.q = glm::normalize(model.joints[2].X_PJ.q * glm::angleAxis(1e-3, dvec3(1, 0, 0)));
  const Chain chain = chainOf(model);
  EXPECT_EQ(describe(classify(chain)), "ur (calibrated)");
  ClassTolerance loose;
  loose.exact = 2e-3;
  EXPECT_EQ(describe(classify(chain, loose)), "ur");
  ClassTolerance strict;
  strict.near_angle = 1e-5;
  EXPECT_EQ(describe(classify(chain, strict)), "numeric");
}

TEST(RobotClass, MimicJointsAndShortChainsAreNumeric) {
  RobotModel model = test::kr120();
  model.joints[3].mimic = Mimic{2, 1.0, 0.0};
  model.joints[3].variable = -1;
  model.moving = {0, 1, 2, 4, 5};
  for (std::size_t i = 0; i < model.moving.size(); ++i) {
    model.joints[static_cast<std::size_t>(model.moving[i])].variable = static_cast<int>(i);
  }
  EXPECT_EQ(classify(chainOf(model)).robot_class, RobotClass::kNumeric);
  const auto inverse = createInverse(model, model.defaultTip());
  ASSERT_TRUE(inverse);
  EXPECT_EQ((*inverse)->name(), "numeric");
}

}  // namespace
}  // namespace hapticell::kinematics
