// SPDX-License-Identifier: Apache-2.0
// The robot's panel in the whole window under a virtual display: real clicks, through RobotPage.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QMenu>
#include <QStandardItemModel>
#include <QToolButton>
#include <cmath>

#include "app/controls/pose_text.h"
#include "app/controls/robot_picture.h"
#include "app/host/hold_choice.h"
#include "app/robot/configuration_model.h"
#include "app/style/proxy_style.h"
#include "app/style/segmented.h"
#include "app/style/theme.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/robot_page.h"
#include "workcell/entity/named_poses.h"

namespace hapticell::app {
namespace {

/// Waits for the list of configurations and the check of every way.
ConfigurationModel* checkedList(RobotPage& page, int rows) {
  auto* table = page.find<QTableView>("tableConfigurations");
  auto* model = dynamic_cast<ConfigurationModel*>(table->model());
  const auto done = [&] {
    if (model->rowCount() < rows) return false;
    if (model->rowOf(page.joints()) < 0) return false;  // Still the list of where the robot was.
    for (int i = 0; i < model->rowCount(); ++i)
      if (model->way(i) == ConfigurationModel::Way::kUnknown) return false;
    return true;
  };
  EXPECT_TRUE(RobotPage::until(done, RobotPage::kPatience));
  return model;
}

/// Beside a picture of nothing: what differs are the robots' pixels.
TEST(RobotPicture, ShowsTheWholeRobot) {
  RobotPage page;  // For its OpenGL.
  const Theme& theme = themeOf(page.window().palette());
  RobotPicture painter;
  for (const QSize size : {QSize(300, 120), QSize(120, 240)}) {
    const QImage empty = painter.draw({}, size, theme);
    for (const char* name : {"ur5e", "kuka_kr16_2"}) {
      Diagnostics notes;
      auto robot = workcell::EntityLoader({}).load(std::string("library:") + name, 0.0, notes);
      ASSERT_TRUE(robot);
      const QImage picture = painter.draw({std::move(*robot)}, size, theme);
      int inside = 0, at_rim = 0;
      for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x) {
          if (picture.pixel(x, y) == empty.pixel(x, y)) continue;
          const bool rim = x < 2 || y < 2 || x >= size.width() - 2 || y >= size.height() - 2;
          ++(rim ? at_rim : inside);
        }
      }
      EXPECT_EQ(at_rim, 0) << name << " is cut at the edge";
      EXPECT_GT(inside, size.width() * size.height() / 20) << name << " is small";
    }
  }
}

/// Zero is the stretched arm, with a straight wrist.
void stretch(RobotPage& page) {
  for (const char* field : {"jogField2", "jogField3", "jogField5"}) ASSERT_TRUE(page.typeForStep(field, "0"));
}

TEST(RobotPanel, ComesByItselfWhenARobotIsChosen) {
  RobotPage page;
  EXPECT_FALSE(page.isShown("dockRobot"));
  page.addRobot("kuka_kr16_2");
  EXPECT_TRUE(page.isShown("dockRobot"));
  EXPECT_EQ(page.words("labelRobot").toStdString(), page.selected()->name);
}

TEST(RobotPanel, TheConfigurationsOfAnotherRobotAreNotListed) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  auto* model = checkedList(page, 4);
  EXPECT_GE(model->rowCount(), 4);
  page.addRobot("ur5e");
  EXPECT_TRUE(model->rowCount() == 0 || model->rowOf(page.joints()) >= 0) << "none until its own are known";
  checkedList(page, 4);
}

/// The list of configurations is computed beside the window; its robot may be gone when it comes. That crashed.
TEST(RobotPanel, ARobotMayBeGoneBeforeItsConfigurationsAreListed) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  checkedList(page, 4);
  for (int rounds = 0; rounds < 12; ++rounds) {
    page.trigger("actionUndo");
    EXPECT_TRUE(page.document().document().state().entities.empty());
    RobotPage::until([] { return false; }, 5);
    page.trigger("actionRedo");
    page.window().selection().set(page.document().document().state().entities.back()->id);
    // Asked after 120 ms: in some round the answer is on its way when the robot goes.
    RobotPage::until([] { return false; }, 100 + 4 * rounds);
  }
  checkedList(page, 4);
}

TEST(RobotPanel, AJointIsSteppedTypedAndStopsAtItsLimit) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  const double before = page.joints()[0];
  ASSERT_TRUE(page.clickForStep("jogMore1"));
  EXPECT_NEAR(page.joints()[0], before + kDegree, 1e-12) << "a step of a degree";
  ASSERT_TRUE(page.typeForStep("jogField5", "31.5"));
  EXPECT_NEAR(page.joints()[4], 31.5 * kDegree, 1e-12);
  ASSERT_TRUE(page.typeForStep("jogField1", "185"));
  EXPECT_NEAR(page.joints()[0], 185 * kDegree, 1e-12);
  EXPECT_TRUE(page.words("labelStop").contains("A1")) << page.words("labelStop").toStdString();
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  EXPECT_NEAR(page.joints()[0], before, 1e-12) << "each was one step of undo";
}

TEST(RobotPanel, ATcpStepGoesStraightInTheChosenAxes) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  const auto tool = [&] { return tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints()); };
  page.find<Segmented>("segmentsJog")->button(1)->click();
  page.settle();
  page.find<Segmented>("segmentsJogFrame")->button(1)->click();
  const Pose before = tool();
  ASSERT_TRUE(page.clickForStep("jogZMore"))
      << page.words("labelStop").toStdString() << page.find<QAbstractButton>("jogZMore")->isEnabled()
      << page.find<QWidget>("jogZMore")->isVisible();
  const Pose after = tool();
  EXPECT_LT(glm::length(after.p - before.p - 0.001 * before.rotate(dvec3(0, 0, 1))), 2e-6)
      << "a millimetre along its z";
  page.find<Segmented>("segmentsJogFrame")->button(2)->click();
  ASSERT_TRUE(page.clickForStep("jogALess")) << page.words("labelStop").toStdString();
  const Pose turned = tool();
  EXPECT_LT(glm::length(turned.p - after.p), 3e-6);
  const dquat expected = glm::normalize(quaternionFromRotationVector(dvec3(0, 0, -kDegree)) * after.q);
  EXPECT_GT(std::abs(glm::dot(turned.q, expected)), 1.0 - 1e-9);
}

TEST(RobotPanel, AStretchedArmSaysThatItsReachEndsHere) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  stretch(page);
  page.find<Segmented>("segmentsJog")->button(1)->click();
  page.settle();
  page.click("jogXMore");
  EXPECT_TRUE(RobotPage::until([&] { return !page.words("labelStop").isEmpty(); }, RobotPage::kPatience));
}

TEST(RobotPanel, AConfigurationIsShownAsAGhostAndTakenAsOneStep) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  ASSERT_TRUE(page.typeForStep("jogField5", "40"));
  ConfigurationModel* model = checkedList(page, 4);
  ASSERT_GE(model->rowCount(), 4);
  EXPECT_EQ(model->headerData(ConfigurationModel::kFlags, Qt::Horizontal, Qt::DisplayRole).toString(), "KUKA");
  auto* table = page.find<QTableView>("tableConfigurations");
  int row = -1;
  for (int i = 0; i < model->rowCount() && row < 0; ++i)
    if (model->way(i) == ConfigurationModel::Way::kFree) row = i;
  ASSERT_GE(row, 0);
  const std::vector<double> wanted = model->solution(row).q;
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(model->index(row, 0)).center());
  page.settle();
  const auto ghosts = page.window().viewport().scene().ghosts();
  ASSERT_EQ(ghosts.size(), 1u);
  EXPECT_EQ(ghosts[0].joints, wanted);
  EXPECT_FALSE(ghosts[0].touches);
  const Pose before = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  ASSERT_TRUE(page.clickForStep("buttonTake"));
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(page.joints()[i], wanted[i], 1e-12);
  const Pose after = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  EXPECT_LT(glm::length(after.p - before.p), 1e-9) << "the tool stays where it is";
  page.trigger("actionUndo");
  EXPECT_NEAR(page.joints()[4], 40 * kDegree, 1e-12);
}

TEST(RobotPanel, WhatStandsInTheWayIsNamedAndNotEntered) {
  RobotPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr16_2");
  const Pose X_WT = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  workcell::Entity wall;
  wall.name = "Wall";
  wall.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(2.0, 0.1, 2.0)))};
  wall.X_WE = Pose::translation({X_WT.p.x, -0.9, X_WT.p.z});
  page.add(wall);
  page.window().selection().set(robot);
  page.settle();
  ASSERT_TRUE(page.typeForStep("jogField1", "90"));
  const double reached = std::abs(page.joints()[0]);
  EXPECT_GT(reached, 1 * kDegree);
  EXPECT_LT(reached, 89 * kDegree);
  EXPECT_TRUE(page.words("labelStop").contains("Wall")) << page.words("labelStop").toStdString();
}

/// What the user left out of the checks is in no jog's way, nor in that of a configuration change.
TEST(RobotPanel, PairsThatARuleLeavesOutStopNoJog) {
  RobotPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr16_2");
  const std::string name = page.selected()->name;
  const Pose X_WT = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  const auto ways = [&] {
    EXPECT_TRUE(page.typeForStep("jogField5", "40"));
    ConfigurationModel* model = checkedList(page, 4);
    std::vector<ConfigurationModel::Way> found;
    for (int row = 0; row < model->rowCount(); ++row) found.push_back(model->way(row));
    EXPECT_TRUE(page.typeForStep("jogField5", "30"));
    return found;
  };
  const auto without = ways();
  workcell::Entity wall;
  wall.name = "Wall";
  wall.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(2.0, 0.1, 2.0)))};
  wall.X_WE = Pose::translation({X_WT.p.x, -0.9, X_WT.p.z});
  page.add(wall);
  const workcell::PairRule left_out{.first = name, .second = "Wall", .checked = false};
  ASSERT_TRUE(page.document().execute(workcell::SetPairRules{{left_out}}));
  page.window().selection().set(robot);
  page.settle();
  ASSERT_TRUE(page.typeForStep("jogField1", "90"));
  EXPECT_NEAR(page.joints()[0], 90 * kDegree, 1e-9) << page.words("labelStop").toStdString();
  ASSERT_TRUE(page.typeForStep("jogField1", "0"));
  EXPECT_EQ(ways(), without) << "the ways to the other configurations";
}

TEST(RobotPanel, NamedPosesAndHome) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  const std::vector<double> home = workcell::findNamedPose(*page.selected(), "home");
  ASSERT_TRUE(page.typeForStep("jogField2", "-60"));
  ASSERT_TRUE(page.clickForStep("buttonHome"));
  EXPECT_EQ(page.joints(), home);
}

TEST(RobotPanel, HeldByIsOneChoiceForAllPanels) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  page.find<Segmented>("segmentsHeldBy")->button(1)->click();
  EXPECT_TRUE(page.window().holdChoice().is<by::Base>());
  page.window().holdChoice().set(by::Tool{});
  page.settle();
  EXPECT_EQ(page.find<Segmented>("segmentsHeldBy")->current(), 0);
  page.find<Segmented>("segmentsHeldBy")->button(2)->click();
  EXPECT_TRUE(page.window().holdChoice().is<by::Base>());
  EXPECT_EQ(page.window().holdChoice().movedBy(), HoldChoice::MovedBy(by::Base{.keeps_tool = true}));
}

TEST(RobotPanel, TheListIsGreyedFromTheJogUntilTheNewOneIsThere) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  auto* table = page.find<QTableView>("tableConfigurations");
  checkedList(page, 4);
  ASSERT_TRUE(table->isEnabled());
  std::vector<double> other = page.joints();
  other[4] += 30 * kDegree;
  ASSERT_TRUE(page.document().execute(workcell::SetJoints{page.selected()->id, other}));
  EXPECT_FALSE(table->isEnabled());
  EXPECT_FALSE(page.find<QAbstractButton>("buttonTake")->isEnabled());
  EXPECT_TRUE(RobotPage::until([&] { return table->isEnabled(); }, RobotPage::kPatience));
  checkedList(page, 4);
}

TEST(RobotPanel, WhatYieldsAtASingularityIsChosenAndGreyedWithoutAWrist) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  auto* choice = page.find<QComboBox>("comboSingularity");
  const auto* items = qobject_cast<QStandardItemModel*>(choice->model());
  EXPECT_EQ(choice->itemText(1), "Keep position, A4 fixed");
  EXPECT_TRUE(items->item(1)->isEnabled());
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  EXPECT_EQ(manipulation::toolOf(page.window().holdChoice().movedBy())->at_singularity, "keep_joint_4");
  page.addRobot("denso_hsr065");
  EXPECT_FALSE(items->item(1)->isEnabled());
  EXPECT_FALSE(items->item(1)->toolTip().isEmpty()) << "it says why";
  EXPECT_NE(choice->currentIndex(), 1);
}

TEST(RobotPanel, TheAxisThatTheRobotStandsOnIsOfferedToGoAlong) {
  RobotPage page;
  page.trigger("actionMechanism");
  ASSERT_TRUE(page.clickForStep("buttonSampleTurntable"));
  const workcell::Entity table = *page.selected();
  const workcell::EntityId robot = page.addRobot("ur5e");
  EXPECT_FALSE(page.find<QAbstractButton>("switchAxes")->isVisible());
  ASSERT_TRUE(page.document().execute(workcell::Attach{robot, table.id, table.robot()->links.back().name}));
  page.settle();
  auto* go_along = page.find<QAbstractButton>("switchAxes");
  ASSERT_TRUE(go_along->isVisible());
  EXPECT_TRUE(go_along->text().contains(QString::fromStdString(table.name))) << go_along->text().toStdString();
  page.click("switchAxes");
  EXPECT_TRUE(manipulation::toolOf(page.window().holdChoice().movedBy())->with_axes);
  page.find<Segmented>("segmentsHeldBy")->button(1)->click();
  EXPECT_FALSE(go_along->isEnabled()) << "the base is held itself";
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
