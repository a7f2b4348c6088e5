// SPDX-License-Identifier: Apache-2.0
// The dock "Plan a path" in the whole window under a virtual display: real clicks, through PlanPage.
#include <gtest/gtest.h>

#include <QAction>
#include <memory>

#include "geometry/shapes/shapes.h"
#include "tests/app/pages/plan_page.h"

namespace hapticell::app {
namespace {

TEST(PlanDock, APathOfARobotBecomesAMotionThatCanBeUndone) {
  PlanPage page;
  page.openDock();
  EXPECT_FALSE(page.find<QAbstractButton>("buttonPlanPath")->isEnabled()) << "nothing is selected";
  ASSERT_NE(page.addRobot("kuka_kr16_2"), 0u);
  page.chooseGoal("Joints");
  page.click("buttonPlanTake");
  auto wanted = page.joints();
  ASSERT_FALSE(wanted.empty());
  QStringList words = page.find<QLineEdit>("editPlanJoints")->text().split(';');
  ASSERT_EQ(words.size(), static_cast<qsizetype>(wanted.size()));
  words[0] = QString::number(words[0].toDouble() + 40.0);
  page.typeJoints(words.join(";"));
  const QString says = page.planned();
  EXPECT_TRUE(says.contains("seed 1")) << says.toStdString();
  ASSERT_EQ(page.motions(), 1u) << says.toStdString();
  const auto& motion = page.document().document().state().trajectories.front().motion;
  ASSERT_NE(motion, nullptr);
  ASSERT_FALSE(motion->frames().empty());
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  EXPECT_NEAR(motion->joints(motion->size() - 1).front(), wanted.front() + 40.0 * kDegree, 1e-4);
  EXPECT_NEAR(motion->joints(0).front(), wanted.front(), 1e-4);
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), 0u);
}

TEST(PlanDock, AGoalOutOfReachIsExplained) {
  PlanPage page;
  page.openDock();
  ASSERT_NE(page.addRobot("kuka_kr16_2"), 0u);
  page.type("fieldPlanX", "9000");
  const QString says = page.planned();
  EXPECT_TRUE(says.contains("reach")) << says.toStdString();
  EXPECT_EQ(page.motions(), 0u);
}

TEST(PlanDock, JointsThatAreMissingAreAskedFor) {
  PlanPage page;
  page.openDock();
  ASSERT_NE(page.addRobot("kuka_kr16_2"), 0u);
  page.chooseGoal("Joints");
  page.typeJoints("1; 2");
  EXPECT_TRUE(page.planned().contains("6 numbers"));
  EXPECT_EQ(page.motions(), 0u);
}

TEST(PlanDock, OffersTheGoalsThatTheChosenEntityMayHave) {
  PlanPage page;
  page.openDock();
  const auto* choice = page.find<QComboBox>("choicePlanGoal");
  ASSERT_NE(choice, nullptr);
  ASSERT_NE(page.addRobot("kuka_kr16_2"), 0u);
  EXPECT_GE(choice->findText("Joints"), 0);
  EXPECT_LT(choice->findText("Out of the cell"), 0) << "a robot stands where it stands";
  workcell::Entity box;
  box.name = "box";
  box.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({0.1, 0.1, 0.1}))};
  box.X_WE.p = {3.0, 0.0, 0.5};
  ASSERT_NE(page.add(std::move(box)), 0u);
  EXPECT_LT(choice->findText("Joints"), 0);
  EXPECT_GE(choice->findText("Out of the cell"), 0);
}

}  // namespace
}  // namespace hapticell::app
