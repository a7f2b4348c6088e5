// SPDX-License-Identifier: Apache-2.0
// The dock "Plan a path" in the whole window under a virtual display: real clicks, through PlanPage.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QListWidget>
#include <memory>

#include "app/kit/dock_front.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/plan_page.h"
#include "workcell/import/entity_source.h"

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

/// One chooses in the scene what is planned for.
TEST(PlanDock, StaysInFrontWhenARobotIsSelected) {
  PlanPage page;
  page.addRobot("ur5e");
  const workcell::EntityId robot = page.window().selection().current();
  page.openDock();
  PlanPage::settle();
  auto* dock = page.find<QDockWidget>("dockPlan");
  ASSERT_TRUE(PlanPage::until([&] { return isInFront(*dock); }, PlanPage::kPatience));
  for (const workcell::EntityId entity : {workcell::EntityId{0}, robot}) {
    page.window().selection().set(entity);
    PlanPage::settle();
    EXPECT_TRUE(isInFront(*dock)) << entity;
  }
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

workcell::Entity loaded(const std::string& what, const std::string& name, const Pose& X_WE) {
  workcell::EntityLoader loader("/");
  Diagnostics notes;
  workcell::Entity entity = *loader.load(what, 0.0, notes);
  entity.name = name;
  entity.X_WE = X_WE;
  return entity;
}

/// A robot on a rail: both move, both motions are played together, one undo step takes both away.
TEST(PlanDock, ARobotMovesWithItsRail) {
  PlanPage page;
  page.openDock();
  const auto bed = page.add(loaded("box:6,0.4,0.1", "bed", Pose::translation({0.0, 0.0, 0.05})));
  const auto plate = page.add(loaded("box:0.8,0.8,0.2", "plate", Pose::translation({0.0, 0.0, 0.21})));
  workcell::MechanismJoint joint;
  joint.name = "drive";
  joint.type = workcell::MechanismJointType::kPrismatic;
  joint.parent = "bed";
  joint.child = "plate";
  joint.axis_M = dvec3(1.0, 0.0, 0.0);
  joint.lower = -2.5;
  joint.upper = 2.5;
  joint.velocity = 1.0;
  ASSERT_TRUE(page.document().execute(workcell::MakeMechanism{"rail", {bed, plate}, {joint}}));
  const auto rail = page.document().document().findByName("rail")->id;
  const auto robot = page.addRobot("kuka_kr16_2");
  ASSERT_NE(robot, 0u);
  const auto joints = page.document().document().find(robot)->joints();
  ASSERT_TRUE(page.document().execute(workcell::SetConfiguration{robot, Pose::translation({0.0, 0.0, 0.311}), joints}));
  const auto* axes = page.find<QAbstractButton>("switchPlanAxes");
  ASSERT_NE(axes, nullptr);
  EXPECT_FALSE(axes->isVisible()) << "it stands on nothing that moves";
  ASSERT_TRUE(page.document().execute(workcell::Attach{robot, rail, "plate"}));
  page.settle();
  ASSERT_TRUE(axes->isVisible());
  EXPECT_TRUE(axes->text().contains("rail")) << axes->text().toStdString();
  page.type("fieldPlanX", QString::number(page.number("fieldPlanX") + 2000.0));
  page.click("switchPlanAxes");
  EXPECT_TRUE(page.planned().contains("reach"));
  EXPECT_EQ(page.motions(), 0u);
  page.click("switchPlanAxes");
  const QString says = page.planned();
  ASSERT_EQ(page.motions(), 2u) << says.toStdString();
  const auto& motions = page.document().document().state().trajectories;
  const auto& of_rail = *motions[0].motion;
  const auto& of_robot = *motions[1].motion;
  EXPECT_EQ(of_rail.entity, "rail");
  EXPECT_EQ(of_robot.entity, page.document().document().find(robot)->name);
  EXPECT_EQ(of_rail.take, of_robot.take);
  EXPECT_GT(std::abs(of_rail.joints(of_rail.size() - 1)[0]), 0.3) << "the rail moves";
  // Joints: the rail's first, in its unit.
  page.chooseGoal("Joints");
  page.click("buttonPlanTake");
  EXPECT_EQ(page.find<QLineEdit>("editPlanJoints")->text().split(';').size(), 7);
  page.click("switchPlanAxes");
  EXPECT_EQ(page.find<QLineEdit>("editPlanJoints")->text().split(';').size(), 6);
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), 0u);
}

TEST(PlanDock, AMannequinIsAskedWhichHandMoves) {
  PlanPage page;
  page.openDock();
  const auto* hand = page.find<QComboBox>("choicePlanHand");
  ASSERT_NE(hand, nullptr);
  ASSERT_NE(page.addRobot("kuka_kr16_2"), 0u);
  EXPECT_FALSE(hand->isVisible());
  ASSERT_NE(page.add(loaded("mannequin:male:50", "worker", Pose::translation({4.0, 0.0, 0.0}))), 0u);
  EXPECT_TRUE(hand->isVisible());
  const auto* choice = page.find<QComboBox>("choicePlanGoal");
  EXPECT_LT(choice->findText("Joints"), 0);
  EXPECT_LT(choice->findText("Out of the cell"), 0);
  // The goal follows the chosen hand until it is edited.
  const double right = page.number("fieldPlanY");
  page.choose("choicePlanHand", "Left hand");
  EXPECT_GT(page.number("fieldPlanY"), right + 100.0);
  page.type("fieldPlanZ", "1100");
  const double left = page.number("fieldPlanY");
  page.choose("choicePlanHand", "Right hand");
  EXPECT_NEAR(page.number("fieldPlanY"), left, 1e-9);
  page.choose("choicePlanHand", "Left hand");
  page.type("fieldPlanX", "4300");
  const QString says = page.planned();
  ASSERT_EQ(page.motions(), 1u) << says.toStdString();
  const auto& motion = page.document().document().state().trajectories.front().motion;
  EXPECT_EQ(motion->moved, "whole");
  EXPECT_EQ(motion->entity, "worker");
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), 0u);
}

TEST(PlanDock, PathsPassTheFramesOfTheListInItsOrder) {
  PlanPage page;
  page.openDock();
  const auto* list = page.find<QListWidget>("listPlanThrough");
  ASSERT_NE(list, nullptr);
  EXPECT_FALSE(page.find<QAbstractButton>("buttonPlanThroughAdd")->isEnabled()) << "the cell has no frames";
  EXPECT_TRUE(page.words("labelPlanThroughEmpty").contains("no frames"));
  ASSERT_NE(page.add(loaded("frame:", "near", Pose::translation({0.0, 0.0, 1.5}))), 0u);
  ASSERT_NE(page.add(loaded("frame:", "far", Pose::translation({1.0, 0.0, 1.5}))), 0u);
  workcell::Entity box;
  box.name = "box";
  box.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({0.1, 0.1, 0.1}))};
  box.X_WE.p = {0.0, 0.0, 0.5};
  ASSERT_NE(page.add(std::move(box)), 0u);
  EXPECT_TRUE(page.words("labelPlanThroughEmpty").contains("by any way"));
  for (const char* frame : {"far", "near", "far"}) {
    page.choose("choicePlanThrough", frame);
    page.click("buttonPlanThroughAdd");
  }
  ASSERT_EQ(list->count(), 3);
  EXPECT_FALSE(page.find<QWidget>("labelPlanThroughEmpty")->isVisible());
  EXPECT_FALSE(page.find<QAbstractButton>("buttonPlanThroughDown")->isEnabled()) << "the last row is chosen";
  page.click("buttonPlanThroughRemove");
  page.click("buttonPlanThroughUp");
  ASSERT_EQ(list->count(), 2);
  EXPECT_EQ(list->item(0)->text() + list->item(1)->text(), "nearfar");
  page.type("fieldPlanX", "2000");
  const QString says = page.planned();
  ASSERT_EQ(page.motions(), 1u) << says.toStdString();
  const auto& motion = *page.document().document().state().trajectories.front().motion;
  std::size_t at[2] = {};
  for (std::size_t k = 0; k < 2; ++k) {
    const dvec3 place(k == 0 ? 0.0 : 1.0, 0.0, 1.5);
    for (std::size_t i = 0; i < motion.size(); ++i)
      if (glm::length(motion[i].X_WT.p - place) < glm::length(motion[at[k]].X_WT.p - place)) at[k] = i;
    EXPECT_LT(glm::length(motion[at[k]].X_WT.p - place), 5e-3);
  }
  EXPECT_LT(at[0], at[1]);
  // A frame that is gone is told, and can be taken out of the list.
  const auto far = page.document().document().findByName("far")->id;
  ASSERT_TRUE(page.document().execute(workcell::RemoveEntity{far}));
  EXPECT_TRUE(page.planned().contains("far"));
  EXPECT_EQ(page.motions(), 1u);
}

}  // namespace
}  // namespace hapticell::app
