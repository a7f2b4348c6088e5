// SPDX-License-Identifier: Apache-2.0
// The collision panel in the window, driven as a user drives it.
#include <gtest/gtest.h>

#include <QDropEvent>
#include <QFile>
#include <QFrame>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QTemporaryDir>

#include "app/panels/collisions/collisions_panel.h"
#include "app/kit/switch_list.h"
#include "app/panels/tree/workcell_tree_model.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

/// A table, a box on it, a box 30 mm above it.
struct CollisionsPage : CellPage {
  CollisionsPage() {
    table = addSolid("table", geometry::makeBox({0.6, 0.6, 0.1}), Pose::translation({0, 0, -0.05}));
    standing = addSolid("standing", geometry::makeBox(dvec3(0.06)), Pose::translation({-0.1, 0, 0.03}));
    hovering = addSolid("hovering", geometry::makeBox(dvec3(0.06)), Pose::translation({0.15, 0, 0.06}));
    lookAt({0, 0, 0}, 0.4);
    // With room for all columns.
    for (QDockWidget* dock : window().findChildren<QDockWidget*>())
      if (window().dockWidgetArea(dock) != Qt::BottomDockWidgetArea) dock->hide();
    window().resize(1380, 860);
    showDock("dockCollisions");
  }
  QTableView* pairs() { return find<QTableView>("tablePairs"); }
  QString cell(int row, PairTableModel::Column column) {
    return pairs()->model()->index(row, column).data().toString();
  }
  void clickCell(int row, PairTableModel::Column column) {
    click(pairs()->viewport(), pairs()->visualRect(pairs()->model()->index(row, column)).center());
  }
  /// A click on the switch, which stands at the right of its column.
  void clickSwitch(int row) {
    const QRect box = pairs()->visualRect(pairs()->model()->index(row, PairTableModel::kCheck));
    click(pairs()->viewport(), QPoint(box.right() - 30, box.center().y()));
  }
  void measureAtRest() {
    prepareScene();
    select(0);
    select(hovering);
    until([this] { return pairs()->model()->rowCount() > 0 && cell(0, PairTableModel::kDistance).endsWith("mm"); },
          5000);
  }
  workcell::EntityId table = 0, standing = 0, hovering = 0;
};

TEST(CollisionsPanel, ListsWhatTheSelectedEntityIsNearAndAClickZoomsThere) {
  CollisionsPage page;
  page.measureAtRest();
  ASSERT_EQ(page.pairs()->model()->rowCount(), 2);
  EXPECT_EQ(page.cell(0, PairTableModel::kAgainst), "table");
  EXPECT_EQ(page.cell(0, PairTableModel::kDistance), "30.0 mm");
  EXPECT_EQ(page.cell(0, PairTableModel::kState), "Free");
  const double before = page.window().viewport().camera().distance;
  page.clickCell(0, PairTableModel::kMoved);
  const Camera& camera = page.window().viewport().camera();
  EXPECT_LT(camera.distance, 0.7 * before);
  EXPECT_NEAR(camera.target_W.z, 0.015, 0.04) << "between the two";
}

TEST(CollisionsPanel, ThePairsSwitchLeavesItOutAndUndoBringsItBack) {
  CollisionsPage page;
  page.measureAtRest();
  page.clickSwitch(0);
  ASSERT_EQ(page.state().pair_rules.size(), 1u);
  EXPECT_FALSE(page.state().pair_rules[0].checked);
  EXPECT_EQ(page.cell(1, PairTableModel::kState), "Off") << "it stands last now";
  page.trigger("actionUndo");
  EXPECT_TRUE(page.state().pair_rules.empty());
  EXPECT_EQ(page.cell(0, PairTableModel::kState), "Free");
}

TEST(CollisionsPanel, ANarrowTableKeepsTheNames) {
  CollisionsPage page;
  page.measureAtRest();
  QTableView& table = *page.pairs();
  EXPECT_FALSE(table.isColumnHidden(PairTableModel::kNearMissWithin));
  table.resize(660, table.height());
  EXPECT_TRUE(table.isColumnHidden(PairTableModel::kNearMissWithin));
  EXPECT_FALSE(table.isColumnHidden(PairTableModel::kOnContact));
  table.resize(480, table.height());
  EXPECT_TRUE(table.isColumnHidden(PairTableModel::kOnContact));
  EXPECT_FALSE(table.isColumnHidden(PairTableModel::kMoved));
  EXPECT_FALSE(table.isColumnHidden(PairTableModel::kAgainst));
}

TEST(CollisionsPanel, OnContactIsChosenForOnePair) {
  CollisionsPage page;
  page.measureAtRest();
  page.clickCell(0, PairTableModel::kOnContact);
  auto* menu = page.find<QMenu>("menuOnContact");
  ASSERT_NE(menu, nullptr);
  ASSERT_TRUE(menu->isVisible());
  menu->actions().back()->trigger();
  menu->close();
  WindowPage::settle();
  ASSERT_EQ(page.state().pair_rules.size(), 1u);
  EXPECT_EQ(page.state().pair_rules[0].on_contact, workcell::OnContact::kPass);
  EXPECT_EQ(page.cell(0, PairTableModel::kOnContact), "Pass");
}

TEST(CollisionsPanel, WhatTouchesAtRestIsAskedShownAndUndoable) {
  CollisionsPage page;
  auto* question = page.find<QFrame>("questionAtRest");
  EXPECT_FALSE(question->isVisible());
  page.prepareScene();
  ASSERT_TRUE(WindowPage::until(
      [&] {
        page.select(page.hovering), page.select(0);
        return question->isVisible();
      },
      5000));
  QString words;
  for (const QLabel* label : question->findChildren<QLabel*>()) words += label->text();
  EXPECT_TRUE(words.contains("table – standing")) << words.toStdString();
  EXPECT_TRUE(page.state().pair_rules.empty()) << "asked first";
  page.press("buttonLeaveOut");
  EXPECT_FALSE(question->isVisible());
  ASSERT_EQ(page.state().pair_rules.size(), 1u);
  page.select(page.standing);
  EXPECT_EQ(page.cell(page.pairs()->model()->rowCount() - 1, PairTableModel::kState), "Off");
  EXPECT_EQ(page.document().undoText(), "Exclude a pair that touches at rest");
  page.trigger("actionUndo");
  EXPECT_TRUE(page.state().pair_rules.empty());
}

/// A robot arm 184 mm deep in a box was offered as a pair that touches.
TEST(CollisionsPanel, WhatOverlapsDeeplyIsAQuestionOfItsOwn) {
  CollisionsPage page;
  auto* question = page.find<QFrame>("questionAtRest");
  const Pose X_WS = page.window().documentModel().document().find(page.standing)->X_WE;
  ASSERT_TRUE(page.window().documentModel().execute(
      workcell::SetPlacement{page.hovering, Pose::translation(X_WS.p + dvec3(0.02, 0.0, 0.005))}));
  page.prepareScene();
  const auto words = [&] {
    QString all;
    for (const QLabel* label : question->findChildren<QLabel*>()) all += label->text();
    return all;
  };
  const auto look = [&] { page.select(page.hovering), page.select(0); };
  ASSERT_TRUE(WindowPage::until([&] { return look(), question->isVisible(); }, 5000));
  EXPECT_TRUE(words().contains("table – standing")) << words().toStdString();
  EXPECT_FALSE(words().contains("hovering")) << words().toStdString();
  page.press("buttonKeepChecked");
  ASSERT_TRUE(question->isVisible());
  EXPECT_TRUE(words().contains("hovering")) << words().toStdString();
  EXPECT_TRUE(words().contains("mm)")) << words().toStdString();
  EXPECT_TRUE(page.state().pair_rules.empty());
  page.press("buttonLeaveOut");
  EXPECT_FALSE(question->isVisible());
  ASSERT_EQ(page.state().pair_rules.size(), 1u);
  EXPECT_EQ(page.state().pair_rules[0].second, "hovering");
  EXPECT_EQ(page.document().undoText(), "Exclude a pair that overlaps");
  // What the user kept is not asked about again.
  ASSERT_TRUE(page.window().documentModel().execute(workcell::SetPlacement{page.hovering, Pose::translation({0.0, 0.0, 1.5})}));
  page.prepareScene();
  EXPECT_FALSE(WindowPage::until([&] { return look(), question->isVisible(); }, 500));
}

TEST(CollisionsPanel, TheQuestionFollowsAPartThatIsMovedAway) {
  CollisionsPage page;
  auto* question = page.find<QFrame>("questionAtRest");
  page.prepareScene();
  const auto look = [&] { page.select(page.hovering), page.select(0); };
  ASSERT_TRUE(WindowPage::until([&] { return look(), question->isVisible(); }, 5000));
  ASSERT_TRUE(page.window().documentModel().execute(
      workcell::SetPlacement{page.standing, Pose::translation({0.0, 0.0, 1.5})}));
  page.prepareScene();
  EXPECT_TRUE(WindowPage::until([&] { return look(), !question->isVisible(); }, 5000)) << "nothing touches any more";
}

TEST(PairSets, TheFirstOneIsEverythingAndItsFieldsAreCommands) {
  CollisionsPage page;
  page.select(page.hovering);
  page.press("buttonAddSet");
  ASSERT_EQ(page.state().pair_sets.size(), 1u);
  EXPECT_EQ(page.state().pair_sets[0].name, "Everything");
  EXPECT_TRUE(page.state().pair_sets[0].first.empty());
  page.type("fieldNearMiss", "25");
  EXPECT_NEAR(page.state().pair_sets[0].near_miss, 0.025, 1e-12);
  page.type("fieldSafety", "2.5");
  EXPECT_NEAR(page.state().pair_sets[0].safety_distance, 0.0025, 1e-12);
  auto* list = page.find<SwitchList>("pairSets");
  page.click(list, QPoint(24, 12));
  EXPECT_FALSE(page.state().pair_sets[0].enabled);
  page.press("buttonAddSet");
  ASSERT_EQ(page.state().pair_sets.size(), 2u);
  EXPECT_EQ(page.state().pair_sets[1].first, std::vector<std::string>{"hovering"}) << "the selected one";
  page.press("buttonRemoveSet");
  EXPECT_EQ(page.state().pair_sets.size(), 1u);
  for (int i = 0; i < 6; ++i) page.trigger("actionUndo");
  EXPECT_TRUE(page.state().pair_sets.empty());
}

TEST(PairSets, ColumnsTakeWhatIsPickedAddedAndDropped) {
  CollisionsPage page;
  page.press("buttonAddSet");
  page.chooseSegment("segmentsCollisions", 1);
  page.press("buttonPickFirst");
  ASSERT_TRUE(page.window().viewport().isPicking());
  page.clickPoint({0.15, 0, 0.09});
  EXPECT_EQ(page.state().pair_sets[0].first, std::vector<std::string>{"hovering"});
  EXPECT_TRUE(page.window().viewport().isPicking()) << "more can be picked";
  page.key(Qt::Key_Escape);
  EXPECT_FALSE(page.window().viewport().isPicking());

  page.select(page.standing);
  page.press("buttonAddSecond");
  auto* second = page.find<QListWidget>("listSecond");
  QMimeData dragged;
  dragged.setData(WorkcellTreeModel::kNamesFormat, "table\nstanding");
  QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(second->viewport(), &enter);
  QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(second->viewport(), &drop);
  EXPECT_EQ(page.state().pair_sets[0].second, (std::vector<std::string>{"standing", "table"})) << "each once";
  ASSERT_EQ(second->count(), 2);
  page.click(second->viewport(), second->visualItemRect(second->item(0)).center());
  QTest::keyClick(second, Qt::Key_Delete);
  EXPECT_EQ(page.state().pair_sets[0].second, std::vector<std::string>{"table"});
}

TEST(ContactLogPage, FillsFromTheLoopAndIsSaved) {
  CollisionsPage page;
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.held = page.hovering;
  for (int i = 0; i < 10; ++i) {
    snapshot.time_s = 0.1 * i;
    snapshot.stylus.force_n = i > 5 ? 1.5 : 0.0;
    manipulation::PairState pair;
    pair.moved = page.hovering, pair.other = page.table;
    pair.distance = i > 5 ? 0.0 : 0.02 - 0.003 * i;
    pair.contact = i > 5;
    pair.near_miss = pair.distance < 0.010;
    snapshot.pairs = {pair};
    page.window().setSnapshot(snapshot);
    page.select(i % 2 ? page.hovering : page.table);
  }
  auto* log = page.find<QTableView>("tableLog");
  page.chooseSegment("segmentsCollisions", 2);
  ASSERT_EQ(log->model()->rowCount(), 2);
  EXPECT_EQ(log->model()->index(0, ContactLogModel::kEvent).data().toString(), "Contact began");
  EXPECT_EQ(log->model()->index(0, ContactLogModel::kForce).data().toString(), "1.5 N");
  QTemporaryDir folder;
  auto* panel = page.window().findChild<CollisionsPanel*>();
  ASSERT_TRUE(panel->saveLog(folder.filePath("log.csv")));
  QFile file(folder.filePath("log.csv"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("contact_began,hovering,table"));
  EXPECT_FALSE(panel->saveLog(folder.filePath("missing/log.csv")));
  EXPECT_EQ(page.window().messages().messages().back().severity, Severity::kProblem);
}

}  // namespace
}  // namespace hapticell::app
