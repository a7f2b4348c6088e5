// SPDX-License-Identifier: Apache-2.0
// Frames of motions in the window: in the tree with what a check found, in the scene under the mouse; and what is made
// of whole motions.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QMenu>
#include <QMimeData>

#include "app/panels/cell/workcell_panel.h"
#include "tests/app/pages/motion_page.h"

namespace hapticell::app {
namespace {

using trajectory::Trajectory;
using Role = WorkcellTreeModel::Role;

class FramesPage : public MotionPage {
 public:
  FramesPage() { showDock("dockWorkcell"); }
  /// The row of a motion in the tree; not valid where there is none.
  QModelIndex motionRow(const QString& name) { return motionBelow(QModelIndex(), name); }
  void clickRow(const QModelIndex& index) {
    QTreeView& view = tree();
    for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) view.expand(above);
    view.scrollTo(index);
    settle();
    click(view.viewport(), view.visualRect(index).center());
  }
  QTreeView& tree() { return *find<QTreeView>("treeWorkcell"); }

 private:
  QModelIndex motionBelow(const QModelIndex& parent, const QString& name) {
    const QAbstractItemModel& model = *tree().model();
    for (int row = 0; row < model.rowCount(parent); ++row) {
      const QModelIndex index = model.index(row, 0, parent);
      if (index.data(Role::kMotionRole).toString() == name) return index;
      if (const QModelIndex found = motionBelow(index, name); found.isValid()) return found;
    }
    return {};
  }
};

TEST(MotionFrames, StandInTheTreeWithWhatTheCheckFound) {
  FramesPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.3, 0, 0}}, {2, {0.5, 0, 0}}, {3, {0.5, 0.6, 0}}}, "into the wall"));
  QModelIndex motion = page.motionRow("into the wall");
  ASSERT_TRUE(motion.isValid());
  const auto frame = [&](int row) { return motion.model()->index(row, 0, motion); };
  ASSERT_EQ(motion.model()->rowCount(motion), 4);
  EXPECT_FALSE(page.tree().isExpanded(motion)) << "opened by whom it interests";
  EXPECT_FALSE(frame(0).data(Role::kCheckedRole).toBool());
  page.press("buttonCheckMotion");
  ASSERT_TRUE(MotionPage::until([&] { return page.isIdle() && !page.rows()[0].spans.empty(); }, MotionPage::kPatience));
  motion = page.motionRow("into the wall");
  const auto mark = [&](const QModelIndex& row, int role) { return static_cast<Mark>(row.data(role).toInt()); };
  // It meets the wall between the second frame and the third: the second's row stands for the way on.
  EXPECT_EQ(mark(frame(0), Role::kMarkRole), Mark::kNone);
  EXPECT_TRUE(frame(0).data(Role::kCheckedRole).toBool());
  EXPECT_EQ(mark(frame(1), Role::kMarkRole), Mark::kContact);
  EXPECT_EQ(mark(frame(2), Role::kMarkRole), Mark::kContact);
  EXPECT_EQ(mark(motion, Role::kInnerMarkRole), Mark::kContact) << "seen while it is folded";
  EXPECT_TRUE(frame(1).data(Role::kSuffixRole).toString().contains("wall"));
  EXPECT_TRUE(frame(1).data(Qt::AccessibleTextRole).toString().contains("wall"));
  // A click takes hold of the frame and shows it.
  page.clickRow(frame(1));
  EXPECT_TRUE(page.words("labelFrame").contains("Frame 2 of 4")) << page.words("labelFrame").toStdString();
  EXPECT_NEAR(page.shownBox().p.x, 0.3, 1e-9);
}

TEST(MotionFrames, AreDraggedInTheSceneWithTheirNeighbours) {
  FramesPage page;
  std::vector<std::pair<double, dvec3>> way;
  for (int i = 0; i <= 20; ++i) way.push_back({0.1 * i, {0.0, -0.2 + 0.02 * i, 0.3}});
  ASSERT_TRUE(page.import(way, "straight"));
  const std::string before = trajectory::toJsonText(page.newest());
  page.lookAt({0, 0, 0.3}, 0.4);
  page.type("fieldReach", "0.5");
  page.clickDot(1.0);
  ASSERT_TRUE(page.words("labelFrame").contains("Frame 11 of 21")) << page.words("labelFrame").toStdString();
  const auto arrow = [&page](const dvec3& p_W) {
    const ViewportWidget& viewport = page.window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    return 60.0 * viewport.camera().metresPerPixel(p_W, size);  // Well within an arrow of 84 pixels.
  };
  const dvec3 p = way[10].second, grip = p + dvec3(0, 0, arrow(p));
  // Escape takes a drag back.
  ASSERT_TRUE(page.dragScene(grip, grip + dvec3(0, 0, 0.05), false));
  page.key(Qt::Key_Escape);
  EXPECT_EQ(page.motions(), 1u);
  const std::size_t motions = page.motions();
  ASSERT_TRUE(page.dragScene(grip, grip + dvec3(0, 0, 0.1)));
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == motions + 1 && page.isIdle(); }, MotionPage::kPatience));
  const Trajectory& made = page.newest();
  ASSERT_EQ(made.size(), 21u);
  EXPECT_NEAR(made[10].X_WT.p.z, 0.4, 0.01);
  EXPECT_NEAR(made[10].X_WT.p.x, 0.0, 1e-9);
  EXPECT_NEAR(made[10].X_WT.p.y, 0.0, 1e-9) << "along its arrow only";
  EXPECT_TRUE(made[10].by_hand);
  EXPECT_GT(made[12].X_WT.p.z, 0.31);
  EXPECT_LT(made[12].X_WT.p.z, made[10].X_WT.p.z);
  EXPECT_EQ(made[4].X_WT.p, way[4].second) << "out of reach";
  EXPECT_EQ(trajectory::toJsonText(*page.state().trajectories.front().motion), before) << "a copy";
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), 1u);
}

TEST(MotionFrames, AreInsertedAtTheCursorAndDeleted) {
  FramesPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.2, 0, 0}}, {2, {0.2, 0.2, 0}}}, "three"));
  page.scrub(0.5);
  ASSERT_TRUE(page.pressForMotion("buttonInsertFrame"));
  ASSERT_EQ(page.newest().size(), 4u);
  EXPECT_NEAR(page.newest()[1].t, 0.5, 5e-3);
  EXPECT_NEAR(page.newest()[1].X_WT.p.x, 0.1, 1e-3);
  EXPECT_TRUE(page.newest()[1].by_hand);
  page.clickDot(1.0, 1);
  ASSERT_TRUE(page.words("labelFrame").contains("Frame 3 of 4")) << page.words("labelFrame").toStdString();
  ASSERT_TRUE(page.pressForMotion("buttonDeleteFrame"));
  ASSERT_EQ(page.newest().size(), 3u);
  EXPECT_NEAR(page.newest()[1].t, 0.5, 5e-3);
  EXPECT_EQ(page.newest()[2].X_WT.p, dvec3(0.2, 0.2, 0));
}

TEST(MotionFrames, AreInsertedDeletedAndTheirMotionRenamedInTheTree) {
  FramesPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.2, 0, 0}}, {2, {0.2, 0.2, 0}}}, "three"));
  auto* panel = page.window().findChild<WorkcellPanel*>();
  ASSERT_NE(panel, nullptr);
  const auto choose = [&](const QModelIndex& index, const QString& text) {
    QMenu menu;
    panel->fillMenu(menu, index);
    for (QAction* action : menu.actions())
      if (action->text() == text && action->isEnabled()) return action->trigger(), true;
    return false;
  };
  const auto becomesMotions = [&](std::size_t count) {
    return MotionPage::until([&] { return page.motions() == count && page.isIdle(); }, MotionPage::kPatience);
  };
  QModelIndex motion = page.motionRow("three");
  const QAbstractItemModel& rows = *page.tree().model();
  EXPECT_FALSE(choose(rows.index(2, 0, motion), "Insert a frame after this one")) << "nothing comes after the last";
  ASSERT_TRUE(choose(rows.index(0, 0, motion), "Insert a frame after this one"));
  ASSERT_TRUE(becomesMotions(2));
  ASSERT_EQ(page.newest().size(), 4u);
  EXPECT_NEAR(page.newest()[1].t, 0.5, 1e-9);
  EXPECT_NEAR(page.newest()[1].X_WT.p.x, 0.1, 1e-9);
  motion = page.motionRow("three");
  ASSERT_TRUE(choose(rows.index(1, 0, motion), "Delete this frame"));
  ASSERT_TRUE(becomesMotions(3));
  ASSERT_EQ(page.newest().size(), 2u);
  EXPECT_EQ(page.newest()[1].X_WT.p, dvec3(0.2, 0.2, 0));
  ASSERT_TRUE(page.tree().model()->setData(page.motionRow("three"), "first try", Qt::EditRole));
  EXPECT_TRUE(page.motionRow("first try").isValid());
  EXPECT_FALSE(page.motionRow("three").isValid());
  page.trigger("actionUndo");
  EXPECT_TRUE(page.motionRow("three").isValid());
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), 1u);
}

/// Three points of the box, set by hand.
void importProgram(FramesPage& page) {
  trajectory::Trajectory program;
  program.entity = "box";
  for (int i = 0; i < 3; ++i) program.addFrame({1.0 * i, Pose::translation({0.1 * i, 0, 0.3}), true});
  ASSERT_TRUE(page.importMotion(program, "program"));
}

TEST(Program, StandsBelowWhatItMovesAndIsEditedInItsPlace) {
  FramesPage page;
  importProgram(page);
  const QModelIndex row = page.motionRow("program");
  ASSERT_TRUE(row.isValid());
  EXPECT_EQ(row.parent().data().toString(), "box") << "not in a list aside";
  auto* panel = page.window().findChild<WorkcellPanel*>();
  QAbstractItemModel& rows = *page.tree().model();
  const auto point = [&](int k) { return rows.index(k, 0, page.motionRow("program")); };
  const auto x = [&](std::size_t k) { return page.newest()[k].X_WT.p.x; };
  // A name, typed in the row; it goes with the point.
  ASSERT_TRUE(rows.setData(point(2), "drop", Qt::EditRole));
  page.settle();
  EXPECT_EQ(page.motions(), 1u) << "no copy";
  EXPECT_EQ(point(2).data().toString(), "drop · 2.00 s");
  EXPECT_EQ(point(2).data(Qt::EditRole).toString(), "drop");
  // Up by the keys: Alt and an arrow, twice, on the row that stays the current one.
  page.clickRow(point(2));
  ASSERT_EQ(page.tree().currentIndex(), point(2));
  for (int k = 0; k < 2; ++k) {
    QTest::keyClick(&page.tree(), Qt::Key_Up, Qt::AltModifier);
    page.settle();
  }
  EXPECT_EQ(page.newest()[0].nameText(), "drop");
  EXPECT_NEAR(x(0), 0.2, 1e-12);
  EXPECT_NEAR(x(1), 0.0, 1e-12);
  EXPECT_EQ(page.tree().currentIndex(), point(0));
  EXPECT_EQ(page.motions(), 1u);
  // Down again by a drag onto the last row.
  const std::unique_ptr<QMimeData> dragged(rows.mimeData({point(0)}));
  ASSERT_TRUE(rows.canDropMimeData(dragged.get(), Qt::MoveAction, -1, -1, point(2)));
  rows.dropMimeData(dragged.get(), Qt::MoveAction, -1, -1, point(2));
  page.settle();
  EXPECT_EQ(page.newest()[2].nameText(), "drop");
  // Insert and delete in place as well.
  QMenu menu;
  panel->fillMenu(menu, point(0));
  for (QAction* action : menu.actions())
    if (action->text() == "Insert a frame after this one") action->trigger();
  ASSERT_TRUE(MotionPage::until([&] { return page.newest().size() == 4 && page.isIdle(); }, MotionPage::kPatience));
  EXPECT_NEAR(x(1), 0.05, 1e-12);
  page.clickRow(point(1));
  QTest::keyClick(&page.tree(), Qt::Key_Delete);
  page.settle();
  EXPECT_EQ(page.newest().size(), 3u);
  EXPECT_EQ(page.motions(), 1u);
  // Each was one step of undo.
  for (int k = 0; k < 6; ++k) page.trigger("actionUndo");
  ASSERT_EQ(page.motions(), 1u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(x(k), 0.1 * static_cast<double>(k), 1e-12);
    EXPECT_EQ(page.newest()[k].nameText(), "");
  }
  // Delete on the motion itself takes it out.
  page.clickRow(page.motionRow("program"));
  QTest::keyClick(&page.tree(), Qt::Key_Delete);
  page.settle();
  EXPECT_EQ(page.motions(), 0u);
  EXPECT_NE(page.document().find(page.box()), nullptr) << "what it moves stays";
}

TEST(Program, APointNamedTwiceIsRefusedInASentence) {
  FramesPage page;
  importProgram(page);
  QAbstractItemModel& rows = *page.tree().model();
  ASSERT_TRUE(rows.setData(rows.index(0, 0, page.motionRow("program")), "pick", Qt::EditRole));
  page.settle();
  rows.setData(rows.index(1, 0, page.motionRow("program")), "pick", Qt::EditRole);
  page.settle();
  EXPECT_EQ(page.newest()[1].nameText(), "");
  EXPECT_TRUE(page.words("labelMotionLine").contains("pick")) << page.words("labelMotionLine").toStdString();
}

TEST(Program, ARecordingIsNamedInItsPlaceAndReorderedAsACopy) {
  FramesPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.2, 0, 0}}, {2, {0.2, 0.2, 0}}}, "three"));
  QAbstractItemModel& rows = *page.tree().model();
  ASSERT_TRUE(rows.setData(rows.index(1, 0, page.motionRow("three")), "corner", Qt::EditRole));
  page.settle();
  EXPECT_EQ(page.motions(), 1u);
  EXPECT_EQ(page.newest()[1].nameText(), "corner");
  EXPECT_FALSE(page.newest()[1].by_hand) << "its way is as it was recorded";
  page.clickRow(rows.index(1, 0, page.motionRow("three")));
  QTest::keyClick(&page.tree(), Qt::Key_Up, Qt::AltModifier);
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 2 && page.isIdle(); }, MotionPage::kPatience));
  EXPECT_EQ(page.newest()[0].nameText(), "corner");
  EXPECT_EQ(page.state().trajectories.front().motion->frames()[1].nameText(), "corner");
}

TEST(MotionShapes, SplitJoinMirrorReverseApproachAndRetract) {
  FramesPage page;
  ASSERT_TRUE(page.import({{0, {0, 0.1, 0.2}}, {1, {0.2, 0.1, 0.2}}, {2, {0.4, 0.1, 0.2}}}, "way"));
  page.scrub(1.0);
  const double at = page.bar().axis().t(std::floor(page.bar().axis().x(1.0)));
  page.press("buttonSplit");
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 3 && page.isIdle(); }, MotionPage::kPatience));
  EXPECT_NEAR(page.newest().duration(), 2.0 - at, 0.02);
  // The first half is the row above the second.
  page.click(&page.bar(), QPoint(80, TimeBar::kRuler + TimeBar::kRow + TimeBar::kRow / 2));
  ASSERT_TRUE(page.pressForMotion("buttonJoin"));
  EXPECT_NEAR(page.newest().duration(), 2.0, 0.01) << "at most the millisecond between the halves";
  EXPECT_NEAR(page.newest().frames().back().X_WT.p.x, 0.4, 1e-12);
  page.find<QComboBox>("comboMirror")->setCurrentIndex(0);
  ASSERT_TRUE(page.pressForMotion("buttonMirrorMotion"));
  EXPECT_NEAR(page.newest().frames().back().X_WT.p.x, -0.4, 1e-12);
  ASSERT_TRUE(page.pressForMotion("buttonReverseMotion"));
  EXPECT_NEAR(page.newest()[0].X_WT.p.x, -0.4, 1e-12);
  page.type("fieldWay", "50");
  const auto ends = [&page] { return std::pair(page.newest()[0].X_WT, page.newest().frames().back().X_WT); };
  const auto [first, last] = ends();
  ASSERT_TRUE(page.pressForMotion("buttonApproach"));
  ASSERT_TRUE(page.pressForMotion("buttonRetract"));
  EXPECT_NEAR(glm::distance(ends().first.p, first.p), 0.05, 1e-9);
  EXPECT_NEAR(glm::distance(ends().second.p, last.p), 0.05, 1e-9);
  EXPECT_NEAR(glm::dot(ends().first.p - first.p, first.rotate(dvec3(0, 0, 1))), -0.05, 1e-9) << "along its own axis";
}

}  // namespace
}  // namespace hapticell::app
