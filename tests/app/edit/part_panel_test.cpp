// SPDX-License-Identifier: Apache-2.0
// Inserting built-in parts in the whole window, through RobotPage.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDockWidget>
#include <QListWidget>

#include "app/controls/pose_text.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {
namespace {

class PartPage : public RobotPage {
 public:
  PartPage() { trigger("actionInsertPart"); }
  void choose(const QString& name) {
    auto* list = find<QListWidget>("listParts");
    const auto found = list->findItems(name, Qt::MatchExactly);
    ASSERT_EQ(found.size(), 1) << name.toStdString();
    list->scrollToItem(found.front());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(found.front()).center());
    settle();
  }
  bool insert() { return clickForStep("buttonInsertPart"); }
};

TEST(InsertPart, ATableStandsOnTheFloorAsLargeAsTypedAndIsOneStep) {
  PartPage page;
  ASSERT_TRUE(page.isShown("dockInsertPart"));
  page.choose("Table");
  page.type("sizePart1", "1500");
  page.type("placePartX", "700");
  page.type("placePartY", "0");
  ASSERT_TRUE(page.insert());
  ASSERT_TRUE(page.selected());
  EXPECT_EQ(page.selected()->name, "Table");
  EXPECT_EQ(page.selected()->source.path, "table:1.5,0.8,0.75") << "it is saved as what it is made from";
  geometry::Bounds bounds = geometry::transformed(page.selected()->X_WE, page.selected()->mesh()->bounds());
  EXPECT_NEAR(bounds.min.z, 0.0, 1e-9);
  EXPECT_NEAR(bounds.max.x, 0.7 + 0.75, 1e-9);
  page.choose("Box");
  ASSERT_TRUE(page.insert());
  bounds = geometry::transformed(page.selected()->X_WE, page.selected()->mesh()->bounds());
  EXPECT_NEAR(bounds.min.z, 0.0, 1e-9) << "plain shapes stand on the floor too";
  ASSERT_TRUE(page.insert());
  EXPECT_EQ(page.selected()->name, "Box 2");
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
}

TEST(InsertPart, AChosenPartFollowsThePointerAndStandsWhereItIsClicked) {
  PartPage page;
  page.window().viewport().setMotion(false);
  page.choose("Table");
  ASSERT_TRUE(page.window().viewport().isPicking());
  EXPECT_EQ(page.ghosts(), 0u) << "the pointer is not over the scene yet";
  const dvec3 place(0.3, 0.2, 0.0);
  const QPoint pixel = page.pixelOfPoint(place);
  ASSERT_TRUE(page.window().viewport().rect().contains(pixel));
  page.overScene(pixel, false);
  EXPECT_GT(page.ghosts(), 0u);
  EXPECT_EQ(page.entities(), 0u);
  page.overScene(pixel, true);
  ASSERT_EQ(page.entities(), 1u);
  EXPECT_EQ(page.ghosts(), 0u);
  EXPECT_FALSE(page.window().viewport().isPicking());
  const auto boundsOf = [&] { return geometry::transformed(page.selected()->X_WE, page.selected()->mesh()->bounds()); };
  EXPECT_LT(glm::length(boundsOf().center() - (place + dvec3(0, 0, 0.375))), 0.02) << "a pixel is some millimetres";
  EXPECT_NEAR(boundsOf().min.z, 0.0, 1e-9);
  EXPECT_EQ(page.steps(), 1u);
  page.choose("Box");
  ViewportWidget& scene = page.window().viewport();
  ASSERT_TRUE(PartPage::until([&] { return scene.hasWhole(scene.scene().revision()); }, PartPage::kPatience));
  page.overScene(page.pixelOfPoint(place + dvec3(0, 0, 0.75)), true);
  ASSERT_EQ(page.entities(), 2u);
  EXPECT_NEAR(boundsOf().min.z, 0.75, 1e-6) << "on the table";
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
}

TEST(InsertPart, TheFirstPageMakesRoomForWhatIsPlaced) {
  PartPage page;
  page.trigger("actionFirstPage");
  auto* start = page.find<QWidget>("startPage");
  ASSERT_TRUE(start->isVisible());
  page.choose("Box");
  EXPECT_FALSE(start->isVisible());
  EXPECT_TRUE(page.window().viewport().isPicking());
}

TEST(InsertPart, EscapeAndTheButtonEndTheGhost) {
  PartPage page;
  page.choose("Box");
  const QPoint pixel = page.pixelOfPoint(dvec3(0.0));
  page.overScene(pixel, false);
  EXPECT_GT(page.ghosts(), 0u);
  QTest::keyClick(&page.window().viewport(), Qt::Key_Escape);
  page.settle();
  EXPECT_EQ(page.ghosts(), 0u);
  EXPECT_FALSE(page.window().viewport().isPicking());
  page.overScene(pixel, true);
  EXPECT_EQ(page.entities(), 0u);
  page.choose("Cylinder");
  page.overScene(pixel, false);
  ASSERT_TRUE(page.insert());
  EXPECT_EQ(page.ghosts(), 0u);
  EXPECT_FALSE(page.window().viewport().isPicking());
  EXPECT_EQ(page.entities(), 1u);
}

TEST(InsertPart, ABenchIsSetToAnotherHeightAfterwardsInOneStep) {
  PartPage page;
  page.choose("Adjustable bench");
  ASSERT_TRUE(page.insert());
  auto* solid = page.window().findChild<QDockWidget*>("dockSolid");
  solid->show();
  solid->raise();
  page.settle();
  ASSERT_TRUE(page.typeForStep("fieldPartSize3", "1050"));
  EXPECT_EQ(page.selected()->source.path, "bench:1.2,0.8,1.05");
  EXPECT_NEAR(page.selected()->mesh()->bounds().max.z, 1.05, 1e-9);
  page.trigger("actionUndo");
  EXPECT_EQ(page.selected()->source.path, "bench:1.2,0.8,0.95");
}

TEST(InsertPart, SizesThatDoNotGoAreSaidAndNothingIsInserted) {
  PartPage page;
  page.choose("Pipe");
  page.type("sizePart2", "100");
  EXPECT_FALSE(page.words("labelPartProblem").isEmpty());
  EXPECT_FALSE(page.find<QAbstractButton>("buttonInsertPart")->isEnabled());
  page.type("sizePart2", "90");
  EXPECT_TRUE(page.words("labelPartProblem").isEmpty());
  EXPECT_TRUE(page.insert());
  page.choose("Table");
  page.type("sizePart3", "20");
  EXPECT_TRUE(page.words("labelPartProblem").contains("100 mm")) << page.words("labelPartProblem").toStdString();
}

TEST(InsertPart, NothingMovesFromPartToPart) {
  PartPage page;
  page.choose("Box");
  auto* button = page.find<QAbstractButton>("buttonInsertPart");
  const QPoint before = button->mapTo(&page.window(), QPoint());
  for (const char* name : {"Sphere", "Gripper", "Fence", "Pipe"}) {
    page.choose(name);
    EXPECT_EQ(button->mapTo(&page.window(), QPoint()), before) << name;
  }
}

TEST(InsertPart, AGripperIsMountedOnTheRobotWithItsTcpInOneStep) {
  PartPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr6_r900");
  const auto robotNow = [&] { return page.document().document().find(robot); };
  const Pose X_WFlange = tcpPose_W(*robotNow(), robotNow()->X_WE, robotNow()->joints());
  page.choose("Gripper");
  ASSERT_EQ(page.find<QComboBox>("comboMountOn")->currentText().toStdString(), robotNow()->name) << "the only robot";
  ASSERT_TRUE(page.insert());
  const workcell::Entity gripper = *page.selected();
  EXPECT_EQ(gripper.attachment.to, robotNow()->name);
  EXPECT_LT(glm::length(gripper.X_WE.p - X_WFlange.p), 1e-9);
  EXPECT_NEAR(robotNow()->jointed().X_LT.p.z, gripper.mesh()->bounds().max.z, 1e-9)
      << "the TCP is between the finger tips";
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 1u);
  EXPECT_EQ(robotNow()->jointed().X_LT.p, dvec3(0.0));
}

}  // namespace
}  // namespace hapticell::app
