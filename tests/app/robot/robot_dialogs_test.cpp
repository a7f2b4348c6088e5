// SPDX-License-Identifier: Apache-2.0
// Library, tools, mechanisms and the gizmo in the whole window under a virtual display, through RobotPage.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QListWidget>
#include <QMouseEvent>
#include <numbers>

#include "app/controls/pose_text.h"
#include "app/style/segmented.h"
#include "app/viewport/tools/gizmo.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {
namespace {

workcell::Entity box(const std::string& name, const dvec3& p_W) {
  workcell::Entity entity;
  entity.name = name;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.3)))};
  entity.X_WE = Pose::translation(p_W);
  return entity;
}

TEST(RobotLibrary, AChosenRobotFollowsThePointerAndStandsWhereItIsClicked) {
  RobotPage page;
  page.window().viewport().setMotion(false);
  page.trigger("actionAddRobot");
  auto* list = page.find<QAbstractItemView>("listLibrary");
  page.settle();
  EXPECT_FALSE(page.window().viewport().isPicking()) << "nobody has chosen yet";
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(1, 0)).center());
  page.settle();
  ASSERT_TRUE(page.window().viewport().isPicking());
  const dvec3 place(0.4, -0.2, 0.0);
  page.overScene(page.pixelOfPoint(place), false);
  EXPECT_GT(page.ghosts(), 0u);
  EXPECT_EQ(page.steps(), 0u);
  page.overScene(page.pixelOfPoint(place), true);
  ASSERT_EQ(page.steps(), 1u);
  ASSERT_TRUE(page.selected());
  EXPECT_LT(glm::length(page.selected()->X_WE.p - place), 0.02);
  EXPECT_FALSE(page.window().viewport().isPicking());
  EXPECT_FALSE(page.isShown("dockAddRobot"));
}

TEST(RobotLibrary, IsSearchedAndAddsOneStepAtThePlace) {
  RobotPage page;
  page.trigger("actionAddRobot");
  ASSERT_TRUE(page.isShown("dockAddRobot"));
  auto* list = page.find<QAbstractItemView>("listLibrary");
  EXPECT_GE(list->model()->rowCount(), 40);
  auto* search = page.find<QLineEdit>("searchLibrary");
  search->setFocus();
  QTest::keyClicks(search, "kr16");
  page.settle();
  ASSERT_EQ(list->model()->rowCount(), 1);
  list->setCurrentIndex(list->model()->index(0, 0));
  page.type("placeLibraryX", "1500");
  page.type("placeLibraryA", "90");
  ASSERT_TRUE(page.clickForStep("buttonAddFromLibrary"));
  ASSERT_TRUE(page.selected());
  EXPECT_EQ(page.selected()->name, "KUKA KR 16-2");
  EXPECT_NEAR(page.selected()->X_WE.p.x, 1.5, 1e-12);
  EXPECT_LT(glm::length(page.selected()->X_WE.rotate(dvec3(1, 0, 0)) - dvec3(0, 1, 0)), 1e-9);
  EXPECT_FALSE(page.isShown("dockAddRobot"));
  EXPECT_TRUE(page.isShown("dockRobot"));
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
}

TEST(Tools, SeveralAreKeptEditedUsedAndRemoved) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  page.click("buttonTools");
  ASSERT_TRUE(page.isShown("dockTools"));
  const std::size_t before = page.selected()->jointed().tools.size();
  ASSERT_TRUE(page.clickForStep("buttonNewTool"));
  ASSERT_TRUE(page.clickForStep("buttonNewTool"));
  ASSERT_EQ(page.selected()->jointed().tools.size(), before + 2);
  ASSERT_TRUE(page.typeForStep("toolPoseZ", "235"));
  const workcell::ToolFrame made = page.selected()->jointed().tools.back();
  EXPECT_NEAR(made.X_LT.p.z, 0.235, 1e-12);
  EXPECT_NE(page.selected()->jointed().tool, made.name);
  ASSERT_TRUE(page.clickForStep("buttonUseTool"));
  EXPECT_EQ(page.selected()->jointed().tool, made.name);
  EXPECT_NEAR(page.selected()->jointed().X_LT.p.z, 0.235, 1e-12) << "the tool centre point is that of the tool in use";
  EXPECT_TRUE(page.find<QComboBox>("comboTool")->currentText().contains("235"));
  page.trigger("actionUndo");
  ASSERT_TRUE(page.clickForStep("buttonRemoveTool"));
  EXPECT_EQ(page.selected()->jointed().tools.size(), before + 1);
}

/// Where the frame's axis of this letter begins among what is drawn over the scene; far off where there is none.
dvec3 drawnFrame(RobotPage& page, const char* letter) {
  for (const SceneCurve& curve : page.window().viewport().allCurves())
    if (curve.text == letter && curve.points_W.size() == 2) return curve.points_W.front();
  return dvec3(1e9);
}

TEST(Tools, TheFrameInTheSceneGoesWithTheRobotWhoeverMovesIt) {
  RobotPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr16_2");
  page.click("buttonTools");
  ASSERT_TRUE(page.clickForStep("buttonNewTool"));
  const auto tool = [&](const std::vector<double>& joints) {
    workcell::Entity with = *page.selected();
    with.editJointed().tip_link = with.jointed().tools.back().tip_link;
    with.editJointed().X_LT = with.jointed().tools.back().X_LT;
    return tcpPose_W(with, with.X_WE, joints).p;
  };
  EXPECT_LT(glm::length(drawnFrame(page, "X") - tool(page.joints())), 1e-9);
  std::vector<double> led = page.joints();
  led[1] += 0.3;
  manipulation::SceneSnapshot snapshot;  // As from the stylus that drags it.
  snapshot.stylus.held = robot;
  snapshot.entities.push_back({robot, page.selected()->X_WE, led});
  page.window().setSnapshot(snapshot);
  EXPECT_LT(glm::length(drawnFrame(page, "X") - tool(led)), 1e-9);
  page.window().setSnapshot(std::nullopt);
  EXPECT_LT(glm::length(drawnFrame(page, "X") - tool(page.joints())), 1e-9);
  led[0] -= 0.5;  // A motion that is played.
  page.window().viewport().scene().setPlayed({{robot, page.selected()->X_WE, led}});
  page.window().viewport().refresh();
  EXPECT_LT(glm::length(drawnFrame(page, "X") - tool(led)), 1e-9);
}

TEST(Tools, APartIsAttachedGoesAlongAndIsReleasedWhereItIs) {
  RobotPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr16_2");
  const Pose X_WT = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  const workcell::EntityId part = page.add(box("Part", X_WT.p + dvec3(0.4, 0, 0)));
  page.window().selection().set(robot);
  page.click("buttonTools");
  ASSERT_TRUE(page.clickForStep("buttonAttach"));
  const auto placeOf = [&] { return page.document().document().find(part)->X_WE.p; };
  const dvec3 before = placeOf();
  ASSERT_TRUE(page.typeForStep("jogField1", "20"));
  EXPECT_GT(glm::length(placeOf() - before), 0.1);
  auto* carried = page.find<QListWidget>("listCarried");
  ASSERT_EQ(carried->count(), 1);
  carried->setCurrentRow(0);
  const dvec3 there = placeOf();
  ASSERT_TRUE(page.clickForStep("buttonRelease"));
  EXPECT_EQ(placeOf(), there);
  ASSERT_TRUE(page.typeForStep("jogField1", "0"));
  EXPECT_EQ(placeOf(), there);
}

TEST(Tools, ASelectedPartIsMountedOnTheFlangeInOneStep) {
  RobotPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr16_2");
  const Pose X_WF = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  page.add(box("First", {2.0, 0.0, 0.0}));
  const workcell::EntityId gripper = page.add(box("Gripper", {-2.0, 0.0, 0.5}));
  const Pose before = page.document().document().find(gripper)->X_WE;
  page.window().selection().set(robot);
  page.click("buttonTools");
  page.window().selection().set(gripper);
  page.settle();
  EXPECT_EQ(page.find<QComboBox>("comboPart")->currentText(), "Gripper");
  ASSERT_TRUE(page.clickForStep("buttonMount"));
  const workcell::Entity* mounted = page.document().document().find(gripper);
  EXPECT_LT(glm::length(mounted->X_WE.p - X_WF.p), 1e-9);
  EXPECT_LT(glm::length(mounted->X_WE * dvec3(0, 0, 1) - X_WF * dvec3(0, 0, 1)), 1e-9) << "turned as the flange";
  EXPECT_EQ(mounted->attachment.to, page.document().document().find(robot)->name);
  page.document().undo();
  EXPECT_EQ(page.document().document().find(gripper)->X_WE.p, before.p);
  EXPECT_TRUE(page.document().document().find(gripper)->attachment.to.empty());
}

TEST(Tools, WhatIsAttachedIsWeighedAgainstTheMakersPayload) {
  RobotPage page;
  const workcell::EntityId robot = page.addRobot("kuka_kr16_2");
  const Pose X_WT = tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints());
  const workcell::EntityId part = page.add(box("Casting", X_WT.p));
  page.window().selection().set(robot);
  page.settle();
  EXPECT_EQ(page.words("labelLoad"), "Load: none, payload 16 kg");
  page.click("buttonTools");
  ASSERT_TRUE(page.clickForStep("buttonAttach"));
  EXPECT_TRUE(page.words("labelToolsLoad").startsWith("Load 1 kg of 16 kg allowed"));
  EXPECT_TRUE(page.words("labelToolsLoad").contains("Mass not entered, 1 kg assumed: Casting"));
  ASSERT_TRUE(page.document().execute(workcell::SetProperties{.id = part, .mass = 20.0}));
  page.settle();
  EXPECT_TRUE(page.words("labelToolsLoad").startsWith("Too heavy: 20 kg of 16 kg allowed, centre "));
  EXPECT_FALSE(page.words("labelToolsLoad").contains("not entered"));
  page.document().undo();
  page.document().undo();
  page.settle();
  EXPECT_EQ(page.words("labelToolsLoad"), "Load: none, payload 16 kg");
}

TEST(Mechanisms, ASampleIsOneStepJogsAndStopsAtItsLimit) {
  RobotPage page;
  page.trigger("actionMechanism");
  ASSERT_TRUE(page.isShown("dockMechanism"));
  ASSERT_TRUE(page.clickForStep("buttonSampleDoor"));
  ASSERT_TRUE(page.selected() && page.selected()->kind() == workcell::EntityKind::kMechanism);
  EXPECT_TRUE(page.isShown("dockRobot"));
  ASSERT_TRUE(page.typeForStep("jogField1", "45"));
  EXPECT_NEAR(page.joints()[0], 0.25 * std::numbers::pi, 1e-9);
  // Steps of 15 degrees towards its end stop: the last one ends on it, and there it says so.
  const auto& hinge = page.selected()->robot()->joints[static_cast<std::size_t>(page.selected()->robot()->moving[0])];
  const double end = hinge.upper;
  ASSERT_GT(end, 0.25 * std::numbers::pi);
  auto* step = page.find<QComboBox>("comboStep");
  step->setCurrentIndex(step->count() - 1);
  emit step->activated(step->currentIndex());
  const std::size_t before = page.steps();
  while (page.joints()[0] < end - 1e-9) ASSERT_TRUE(page.clickForStep("jogMore1"));
  EXPECT_NEAR(page.joints()[0], end, 1e-12);
  EXPECT_EQ(
      page.steps() - before,
      static_cast<std::size_t>(std::ceil((end - 0.25 * std::numbers::pi) / (15.0 * std::numbers::pi / 180.0) - 1e-9)));
  EXPECT_TRUE(page.find<QLabel>("labelStop")->text().contains("limit"))
      << page.find<QLabel>("labelStop")->text().toStdString();
  while (page.steps() > 0) page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
}

TEST(Mechanisms, JointsAreLaidBetweenPartsOfTheCellAndTakenApart) {
  RobotPage page;
  page.add(box("Frame", {0, 0, 0.15}));
  page.add(box("Slide", {0, 0, 0.4505}));
  page.trigger("actionMechanism");
  page.click("buttonNewJoint");
  const auto choose = [&](const char* name, const QString& part) {
    auto* combo = page.find<QComboBox>(name);
    combo->setCurrentIndex(combo->findData(part));
    emit combo->activated(combo->currentIndex());
    page.settle();
  };
  page.find<Segmented>("segmentsJointKind")->button(1)->click();
  choose("comboChild", "Slide");
  choose("comboParent", "Frame");
  page.type("fieldUpperSlide", "250");
  // The axis is picked on the top face of the slide: its normal.
  page.click("buttonPickAxis");
  ASSERT_TRUE(page.window().viewport().isPicking());
  page.window().viewport().setMotion(false);
  page.window().viewport().fit(page.window().viewport().scene().bounds_W(), false);
  page.window().viewport().finishedPicture();
  const ViewportWidget& viewport = page.window().viewport();
  const ViewSize view{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  const auto top = viewport.camera().project(dvec3(0.02, 0.01, 0.6005), view);
  ASSERT_TRUE(top.has_value());
  page.clickScene(top->x / view.width, top->y / view.height);
  EXPECT_FALSE(page.window().viewport().isPicking());
  EXPECT_TRUE(page.words("labelAxis").startsWith("Z")) << page.words("labelAxis").toStdString();
  ASSERT_TRUE(page.clickForStep("buttonMakeMechanism")) << page.words("labelMechanismFault").toStdString();
  ASSERT_TRUE(page.selected() && page.selected()->mechanism());
  EXPECT_EQ(page.entities(), 1u);
  const auto& joint = page.selected()->robot()->joints[static_cast<std::size_t>(page.selected()->robot()->moving[0])];
  EXPECT_NEAR(joint.upper, 0.25, 1e-12);
  ASSERT_TRUE(page.typeForStep("jogField1", "100"));
  EXPECT_NEAR(page.joints()[0], 0.1, 1e-9);
  ASSERT_TRUE(page.clickForStep("buttonTakeApart"));
  ASSERT_EQ(page.entities(), 2u);
  EXPECT_NEAR(page.document().document().findByName("Slide")->X_WE.p.z, 0.5505, 1e-9) << "where it stands now";
}

TEST(TcpGizmo, AnArrowDragsTheToolAlongItsAxisAsOneStep) {
  RobotPage page;
  page.addRobot("kuka_kr16_2");
  page.window().viewport().setMotion(false);
  page.window().viewport().fit(page.window().viewport().scene().bounds_W(), false);
  page.find<Segmented>("segmentsJog")->button(1)->click();
  page.find<Segmented>("segmentsJogFrame")->button(2)->click();
  page.settle();
  ViewportWidget& viewport = page.window().viewport();
  const ViewSize view{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  const auto tool = [&] { return tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints()); };
  const Pose before = tool();
  const double size = 96.0 * viewport.camera().metresPerPixel(before.p, view);
  const auto pixel = [&](double along) {
    const auto seen = viewport.camera().project(before.p + dvec3(0, 0, along * size), view);
    return QPoint(static_cast<int>(std::lround(seen->x)), static_cast<int>(std::lround(seen->y)));
  };
  const std::size_t steps = page.steps();
  const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButtons held) {
    QMouseEvent event(type, QPointF(place), viewport.mapToGlobal(QPointF(place)),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
    QApplication::sendEvent(&viewport, &event);
    page.settle();
  };
  send(QEvent::MouseButtonPress, pixel(0.8), Qt::LeftButton);
  for (int i = 1; i <= 6; ++i) send(QEvent::MouseMove, pixel(0.8 + 0.1 * i), Qt::LeftButton);
  send(QEvent::MouseButtonRelease, pixel(1.4), Qt::NoButton);
  ASSERT_TRUE(RobotPage::until([&] { return page.steps() == steps + 1 && !page.document().document().inCompound(); },
                               RobotPage::kPatience));
  const Pose after = tool();
  EXPECT_NEAR(after.p.z - before.p.z, 0.6 * size, 0.05 * size);
  EXPECT_LT(std::hypot(after.p.x - before.p.x, after.p.y - before.p.y), 1e-4);
  EXPECT_GT(std::abs(glm::dot(after.q, before.q)), 1.0 - 1e-8);
  page.trigger("actionUndo");
  EXPECT_LT(glm::length(tool().p - before.p), 1e-9);
}

}  // namespace
}  // namespace hapticell::app
