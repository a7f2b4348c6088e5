// SPDX-License-Identifier: Apache-2.0
// The robotics engineer's first hour by real events: CAD, robot, gripper, pair set, forces, contact, recording, edit,
// check, export, all of it taken back, and the cell opened again.
#include <gtest/gtest.h>

#include <QFileInfo>

#include "app/trajectory/docks/time_bar.h"
#include "tests/app/pages/walk_page.h"

namespace hapticell::app {
namespace {

struct EngineerWalk : WalkPage {
  const workcell::Entity* named(const char* begins) {
    for (const auto& entity : state().entities)
      if (entity->name.rfind(begins, 0) == 0) return entity.get();
    return nullptr;
  }
  /// A plate of 0.4 m: the small one of the importer's tests, said to be in centimetres.
  QString stepFile() {
    QFile small(QStringLiteral(HAPTICELL_TEST_STEP)), large(folder.filePath("plate.step"));
    EXPECT_TRUE(small.open(QIODevice::ReadOnly) && large.open(QIODevice::WriteOnly));
    large.write(small.readAll().replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.CENTI.,.METRE.)"));
    return large.fileName();
  }
  /// CAD, a robot beside it, a gripper at its flange.
  void buildCell() {
    withFile(stepFile(), [this] { clickOn("start_actionImport"); });
    ASSERT_TRUE(until([this] { return find<QAbstractButton>("importAccept")->isEnabled(); }, kPatience));
    picture("engineer-1-import");
    clickOn("importAccept");
    ASSERT_TRUE(until([this] { return entities() > 0 && !window().files().isBusy(); }, kPatience));
    press(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    typeText("kr6");
    clickOn("placeLibraryX");
    typeText("-620");
    picture("engineer-2-robot");
    clickOn("buttonAddFromLibrary");
    ASSERT_TRUE(until([this] { return named("KUKA") || named("KR") || named("kuka"); }, kPatience));
    robot = selected();
    choose("menuInsert", "actionInsertPart");
    clickText("listParts", "Gripper");
    clickOn("buttonInsertPart");
    ASSERT_TRUE(until([this] { return named("gripper") || named("Gripper"); }, kPatience));
    gripper = selected();
    EXPECT_EQ(document().find(gripper)->attachment.to, document().find(robot)->name);
    picture("engineer-3-gripper");
  }
  workcell::EntityId selected() { return window().selection().current(); }
  /// A set of robot and gripper against the part.
  void makeSet() {
    clickTab("dockCollisions");
    clickOn("buttonAddSet");
    clickSegment("segmentsCollisions", 1);
    clickOn("buttonAddFirst");
    clickText("treeWorkcell", QString::fromStdString(state().entities.front()->name));
    clickOn("buttonAddSecond");
    ASSERT_FALSE(state().pair_sets.empty());
    picture("engineer-4-set");
  }
  bool gripperTouches() {
    const workcell::EntityId part = state().entities.front()->id;
    const auto is_it = [&](const auto& pair) { return pair.contact && pair.moved == gripper && pair.other == part; };
    return std::any_of(now().pairs.begin(), now().pairs.end(), is_it);
  }
  QPointF pixelOf(const dvec3& p_W) {
    ViewportWidget& viewport = window().viewport();
    const auto pixel =
        viewport.camera().project(p_W, {static_cast<double>(viewport.width()), static_cast<double>(viewport.height())});
    EXPECT_TRUE(pixel.has_value());
    return pixel ? QPointF(pixel->x, pixel->y) : QPointF();
  }
  /// As the eye leads the hand: always on towards the part; at the edge of the stylus's room the clutch.
  void lead(const std::function<bool()>& is_there) {
    for (int i = 0; i < 100 && !is_there(); ++i) {
      const geometry::Bounds tool = window().viewport().scene().boundsOf_W(gripper);
      const geometry::Bounds part = window().viewport().scene().boundsOf_W(state().entities.front()->id);
      const QPointF way = pixelOf(part.center()) - pixelOf({tool.center().x, tool.center().y, tool.min.z});
      const double length = std::hypot(way.x(), way.y());
      const QPointF step = way * (std::min(length, 10.0) / std::max(length, 1.0));
      constexpr double kNearEdge = 0.004;  // m
      if (now().stylus.device_edge_m < kNearEdge) {
        hold(Qt::Key_Space);
        drag(-20.0 * step.x(), -20.0 * step.y());  // Most of the way to the other edge.
        letGo(Qt::Key_Space);
      }
      drag(step.x(), step.y());
      until(is_there, 60);
    }
  }
  /// Forces on, the robot taken by its TCP and led down onto the part while it is recorded.
  void feelAndRecord() {
    clickText("treeWorkcell", QString::fromStdString(document().find(robot)->name));
    press(Qt::Key_Space, Qt::ControlModifier);
    ASSERT_TRUE(until([this] { return now().stylus.forces_on; }, kPatience));
    pointInto(0.5, 0.5);
    press(Qt::Key_1, Qt::KeypadModifier);  // From the front: robot and part stand side by side.
    press(Qt::Key_1);                      // Rough.
    press(Qt::Key_H);
    press(Qt::Key_B);
    ASSERT_TRUE(until([this] { return now().stylus.held == robot; }, kPatience));
    press(Qt::Key_R);
    ASSERT_TRUE(until([this] { return window().recording().isRecording(); }, kPatience));
    const auto touches = [this] { return gripperTouches(); };
    lead(touches);
    EXPECT_TRUE(until(touches, kPatience)) << "the gripper meets the part";
    picture("engineer-5-contact");
    drag(0, -60);
    until([] { return false; }, 400);
    press(Qt::Key_R);
    ASSERT_TRUE(until([this] { return state().trajectories.size() == 1u; }, kPatience));
    press(Qt::Key_B);
    press(Qt::Key_Escape);  // Forces off.
    EXPECT_TRUE(until([this] { return !now().stylus.forces_on && now().stylus.held == 0; }, kPatience));
  }
  void editCheckAndExport() {
    clickTab("dockTrajectory");
    clickOn("buttonSmooth");
    clickOn("buttonSmoothMotion");
    ASSERT_TRUE(until([this] { return state().trajectories.size() == 2u && isIdle(); }, kPatience));
    picture("engineer-6-smoothed");
    clickOn("buttonCheck");
    ASSERT_TRUE(until([this] { return isIdle() && !find<QLabel>("labelMotionLine")->text().isEmpty(); }, kPatience));
    clickOn("buttonExportMotion");
    const QString exported = folder.filePath("path.src");
    withFile(exported, [this] { clickOn("buttonExport"); });
    ASSERT_TRUE(until([&] { return QFileInfo(exported).size() > 0; }, kPatience));
    picture("engineer-7-exported");
  }
  bool isIdle() {
    const auto* cancel = window().findChild<QAbstractButton*>("buttonCancelMotionWork");
    return !window().files().isBusy() && (!cancel || !cancel->isVisibleTo(cancel->parentWidget()));
  }
  workcell::EntityId robot = 0, gripper = 0;
  QTemporaryDir folder;
};

TEST(EngineerWalk, FromTheFirstPageToTheSavedPathAndBack) {
  EngineerWalk walk;
  walk.buildCell();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  walk.makeSet();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  walk.feelAndRecord();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  walk.editCheckAndExport();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  const QString cell = walk.folder.filePath("cell.hcell");
  walk.withFile(cell, [&] { walk.clickTool("actionSave"); });
  ASSERT_TRUE(WalkPage::until([&] { return QFileInfo::exists(cell) && walk.isIdle(); }, WalkPage::kPatience));
  const std::size_t parts = walk.entities(), steps = walk.document().undoTexts().size();
  EXPECT_GE(steps, 5u);
  walk.clickTab("dockHistory");
  walk.clickRow("listHistory", 0);
  EXPECT_TRUE(walk.state().entities.empty()) << "all is taken back at one click";
  walk.picture("engineer-8-taken-back");
  walk.withFile(cell, [&] { walk.clickTool("actionOpen"); });
  ASSERT_TRUE(WalkPage::until([&] { return walk.entities() == parts; }, WalkPage::kPatience));
  EXPECT_EQ(walk.state().trajectories.size(), 2u);
  EXPECT_TRUE(walk.now().stylus.held == 0 && !walk.now().stylus.forces_on);
  walk.picture("engineer-9-opened-again");
  std::puts(walk.counted().c_str());
  EXPECT_LE(walk.clicks(), 30) << walk.counted();
  EXPECT_LE(walk.keys(), 15) << walk.counted();
}

}  // namespace
}  // namespace hapticell::app
