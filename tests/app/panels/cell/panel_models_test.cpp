// SPDX-License-Identifier: Apache-2.0
// What the panels show, without a window: tree, pairs, history, strip, poses.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QCoreApplication>
#include <QSignalSpy>
#include <cmath>

#include "app/panels/cell/history_panel.h"
#include "app/panels/collisions/pair_table_model.h"
#include "app/controls/pose_text.h"
#include "app/controls/strip_history.h"
#include "app/panels/tree/workcell_tree_model.h"

namespace hapticell::app {
namespace {

workcell::Entity makeSolid(const std::string& name, const std::string& parent = {}) {
  workcell::Entity entity;
  entity.name = name;
  entity.parent = parent;
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  entity.body = workcell::Solid{mesh};
  entity.source.path = "box:0.1,0.1,0.1";
  return entity;
}

/// Two solids in a folder, one at the top: ids 1, 2, 3.
void fill(DocumentModel& document) {
  for (const auto& entity : {makeSolid("tower A", "fixture"), makeSolid("tower B", "fixture"), makeSolid("housing")})
    ASSERT_TRUE(document.execute(workcell::AddEntity{entity}));
}

manipulation::SceneSnapshot nearTo(workcell::EntityId other, double distance, bool contact) {
  manipulation::SceneSnapshot now;
  now.stylus.held = 3;
  manipulation::PairState pair;
  pair.moved = 3, pair.other = other;
  pair.distance = distance;
  pair.contact = contact, pair.near_miss = distance < 0.010;
  now.pairs.push_back(pair);
  now.free_gap_m = distance;
  return now;
}

TEST(WorkcellTree, FoldersHoldTheirEntities) {
  DocumentModel document;
  fill(document);
  WorkcellTreeModel model(document);
  const QModelIndex cell = model.index(0, 0, {});
  ASSERT_EQ(model.rowCount(cell), 2);
  const QModelIndex folder = model.index(0, 0, cell);
  EXPECT_EQ(folder.data().toString(), "fixture");
  ASSERT_EQ(model.rowCount(folder), 2);
  EXPECT_EQ(model.index(1, 0, folder).data().toString(), "tower B");
  EXPECT_EQ(model.parent(model.index(1, 0, folder)), folder);
  EXPECT_EQ(model.index(1, 0, cell).data(WorkcellTreeModel::kEntityRole).toULongLong(), 3u);
}

TEST(WorkcellTree, MarksFollowTheSnapshotAndAreWordsToo) {
  DocumentModel document;
  fill(document);
  WorkcellTreeModel model(document);
  QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  model.setSnapshot(nearTo(2, 0.0064, false));
  const QModelIndex tower = model.indexOf(2);
  EXPECT_EQ(tower.data(WorkcellTreeModel::kMarkRole).toInt(), static_cast<int>(Mark::kNearMiss));
  EXPECT_EQ(model.indexOf(1).data(WorkcellTreeModel::kMarkRole).toInt(), static_cast<int>(Mark::kNone));
  EXPECT_EQ(tower.parent().data(WorkcellTreeModel::kInnerMarkRole).toInt(), static_cast<int>(Mark::kNearMiss));
  EXPECT_EQ(tower.data(Qt::AccessibleTextRole).toString(), "tower B, near miss, 6.4 mm");
  EXPECT_EQ(model.indexOf(3).data(WorkcellTreeModel::kSuffixRole).toString(), "held");
  EXPECT_TRUE(tower.data(WorkcellTreeModel::kFilterRole).toString().contains("near miss"));
  EXPECT_GT(changes.count(), 0);
  manipulation::SceneSnapshot both = nearTo(2, 0.0064, false);
  both.second.emplace().held = 1;
  model.setSnapshot(both);
  EXPECT_EQ(model.indexOf(1).data(WorkcellTreeModel::kSuffixRole).toString(), "held") << "by the second stylus";
  EXPECT_EQ(model.indexOf(3).data(WorkcellTreeModel::kSuffixRole).toString(), "held");
  EXPECT_EQ(tower.data(WorkcellTreeModel::kSuffixRole).toString(), "");
  model.setSnapshot(std::nullopt);
  EXPECT_EQ(model.indexOf(2).data(WorkcellTreeModel::kMarkRole).toInt(), static_cast<int>(Mark::kNone));
}

TEST(WorkcellTree, HidingAFolderIsOneStep) {
  DocumentModel document;
  fill(document);
  WorkcellTreeModel model(document);
  const QModelIndex folder = model.index(0, 0, model.index(0, 0, {}));
  const std::size_t before = document.document().undoTexts().size();
  ASSERT_TRUE(model.setShown(folder, false));
  EXPECT_FALSE(document.document().find(1)->visible);
  EXPECT_FALSE(document.document().find(2)->visible);
  EXPECT_TRUE(document.document().find(3)->visible);
  EXPECT_EQ(document.document().undoTexts().size(), before + 1);
  document.undo();
  EXPECT_TRUE(document.document().find(1)->visible);
}

TEST(WorkcellTree, RenamesInPlaceAndRefusesATakenName) {
  DocumentModel document;
  fill(document);
  WorkcellTreeModel model(document);
  EXPECT_TRUE(model.setData(model.indexOf(3), "part", Qt::EditRole));
  EXPECT_EQ(document.document().find(3)->name, "part");
  EXPECT_FALSE(model.setData(model.indexOf(3), "tower A", Qt::EditRole));
  EXPECT_EQ(document.document().find(3)->name, "part");
  const QModelIndex folder = model.index(0, 0, model.index(0, 0, {}));
  EXPECT_TRUE(model.setData(folder, "clamps", Qt::EditRole));
  EXPECT_EQ(document.document().find(1)->parent, "clamps");
  EXPECT_EQ(document.document().find(2)->parent, "clamps");
}

TEST(PairRows, MeasuredOnesFirstThenTheRest) {
  DocumentModel document;
  fill(document);
  const auto now = nearTo(2, 0.0, true);
  const auto rows = pairRows(document.document().state(), {&now, nullptr}, 3, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].other_name, "tower B");
  EXPECT_EQ(rows[0].mark, Mark::kContact);
  EXPECT_EQ(rows[1].other_name, "tower A");
  EXPECT_FALSE(rows[1].distance.has_value());
  EXPECT_TRUE(pairRows(document.document().state(), {}, 0, {}).empty());
}

TEST(PairRows, TheTableCountsFiltersAndFormats) {
  DocumentModel document;
  fill(document);
  PairTableModel table;
  const auto now = nearTo(2, 0.0064, false);
  table.setRows(pairRows(document.document().state(), {&now, nullptr}, 3, {}));
  EXPECT_EQ(table.count(PairTableModel::Show::kAll), 2);
  EXPECT_EQ(table.count(PairTableModel::Show::kNearMiss), 1);
  EXPECT_EQ(table.index(0, PairTableModel::kDistance).data().toString(), "6.4 mm");
  EXPECT_EQ(table.index(0, PairTableModel::kState).data().toString(), "Near miss");
  EXPECT_NEAR(table.index(0, 0).data(PairTableModel::kShareRole).toDouble(), 0.128, 1e-9);
  table.setShow(PairTableModel::Show::kAll, "TOWER a");
  ASSERT_EQ(table.rowCount(), 1);
  EXPECT_EQ(table.index(0, PairTableModel::kDistance).data().toString(), "far");
  table.setShow(PairTableModel::Show::kContact, {});
  EXPECT_EQ(table.rowCount(), 0);
}

TEST(PairRows, AtRestTheMeasuredDistancesStandThere) {
  DocumentModel document;
  fill(document);
  std::vector<manipulation::PairState> rest(1);
  rest[0].moved = 3, rest[0].other = 1, rest[0].distance = 0.0742, rest[0].p_WA = {1, 2, 3};
  const auto rows = pairRows(document.document().state(), {nullptr, &rest}, 3, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].other_name, "tower A");
  EXPECT_EQ(rows[0].distance, 0.0742);
  EXPECT_EQ(rows[0].p_W[0], dvec3(1, 2, 3)) << "what a click zooms to";
}

TEST(PairRows, APairThatIsLeftOutStandsLastAndSaysSo) {
  DocumentModel document;
  fill(document);
  const std::string moved = document.document().find(3)->name;
  ASSERT_TRUE(document.execute(workcell::SetPairRules{{{.first = "tower B", .second = moved, .checked = false}}}));
  ASSERT_TRUE(document.execute(
      workcell::SetPairRules{{{.first = moved, .second = "tower A", .on_contact = workcell::OnContact::kPass}}}));
  PairTableModel table;
  const auto now = nearTo(2, 0.0064, false);
  table.setRows(pairRows(document.document().state(), {&now, nullptr}, 3, {}));
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.count(PairTableModel::Show::kAll), 1);
  EXPECT_EQ(table.row(0).on_contact, workcell::OnContact::kPass);
  EXPECT_TRUE(table.index(0, 0).data(PairTableModel::kOwnRole).toBool());
  EXPECT_EQ(table.index(1, PairTableModel::kState).data().toString(), "Off");
  EXPECT_EQ(table.index(1, PairTableModel::kDistance).data().toString(), "not checked");
  EXPECT_FALSE(table.index(1, 0).data(PairTableModel::kCheckedRole).toBool());
  EXPECT_EQ(table.index(1, PairTableModel::kCheck).data(Qt::AccessibleTextRole).toString(), "excluded");
}

TEST(PairRows, WhatIsCarriedHasItsOwnRowsAndSaysWhatItIsAttachedTo) {
  DocumentModel document;
  fill(document);
  const std::string moved = document.document().find(3)->name;
  ASSERT_TRUE(document.execute(workcell::Attach{2, 3, ""}));
  manipulation::SceneSnapshot now = nearTo(1, 0.0, true);
  now.pairs[0].moved = 2;  // The carried one touches; the list must say so.
  PairTableModel table;
  table.setRows(pairRows(document.document().state(), {&now, nullptr}, 3, {}));
  EXPECT_EQ(table.count(PairTableModel::Show::kContact), 1);
  EXPECT_EQ(table.row(0).moved_name, "tower B");
  EXPECT_EQ(table.row(0).other_name, "tower A");
  const int last = table.rowCount() - 1;
  EXPECT_EQ(table.index(last, PairTableModel::kState).data().toString(), "Attached");
  EXPECT_EQ(table.row(last).moved_name, "tower B");
  EXPECT_EQ(table.row(last).other_name, QString::fromStdString(moved));
  EXPECT_TRUE(table.index(last, 0).data(PairTableModel::kOneBodyRole).toBool());
}

TEST(PairRows, TheSetThatCountsIsTheLastOneThatJoinsThem) {
  DocumentModel document;
  fill(document);
  const std::string moved = document.document().find(3)->name;
  document.execute(workcell::AddPairSet{{.name = "all"}});
  document.execute(workcell::AddPairSet{{.name = "one", .first = {moved}, .second = {"tower A"}, .near_miss = 0.05}});
  for (const PairRow& row : pairRows(document.document().state(), {}, 3, {}))
    EXPECT_EQ(row.set, row.other_name == "tower A" ? "one" : "all");
}

TEST(History, GoesToAnyStepAndBack) {
  DocumentModel document;
  fill(document);
  HistoryModel model(document);
  ASSERT_EQ(model.rowCount(), 4);
  document.goTo(1);
  EXPECT_EQ(document.document().state().entities.size(), 1u);
  EXPECT_EQ(model.rowCount(), 4);
  EXPECT_TRUE(model.index(2, 0).data(HistoryModel::kUndoneRole).toBool());
  EXPECT_TRUE(model.index(1, 0).data(HistoryModel::kCurrentRole).toBool());
  const QString second = model.index(2, 0).data().toString();
  document.goTo(3);
  EXPECT_EQ(document.document().state().entities.size(), 3u);
  EXPECT_EQ(model.index(2, 0).data().toString(), second) << "the list keeps its order";
}

TEST(History, ADragIsOneStepAndCanBeTakenBack) {
  DocumentModel document;
  fill(document);
  document.beginStep("drag");
  for (int i = 1; i <= 5; ++i) document.execute(workcell::SetPlacement{3, Pose::translation(dvec3(0.1 * i, 0, 0))});
  document.endStep();
  EXPECT_EQ(document.document().undoTexts().size(), 4u);
  EXPECT_EQ(document.document().undoText(), "drag");
  document.beginStep("drag");
  document.execute(workcell::SetPlacement{3, Pose::identity()});
  document.cancelStep();
  EXPECT_DOUBLE_EQ(document.document().find(3)->X_WE.p.x, 0.5);
}

TEST(StripHistory, KeepsTheLastSecondsAndTheExtremes) {
  StripHistory history(20.0, 0.025);
  auto now = nearTo(2, 0.050, false);
  for (int i = 0; i < 30000; ++i) {
    now.time_s = 0.001 * i;
    now.stylus.force_n = i == 25003 ? 5.0 : 0.0;
    now.free_gap_m = i == 25003 ? 0.001 : 0.050;
    history.add(now);
  }
  EXPECT_LE(history.samples().size(), 20.0 / 0.025 + 2);
  EXPECT_NEAR(history.now() - history.samples().front().time_s, 20.0, 0.05);
  const StripSample* peak = history.at(25.003);
  ASSERT_NE(peak, nullptr);
  double force = 0.0, gap = 1.0;
  for (const auto& sample : history.samples())
    force = std::max(force, sample.force_n), gap = std::min(gap, sample.gap_m);
  EXPECT_DOUBLE_EQ(force, 5.0);
  EXPECT_DOUBLE_EQ(gap, 0.001);
  now.time_s = 0.0;
  history.add(now);
  EXPECT_EQ(history.samples().size(), 1u) << "another loop begins anew";
}

TEST(StripHistory, AxesEndAtRoundNumbers) {
  EXPECT_DOUBLE_EQ(axisTop(0.0, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(axisTop(3.1, 2.0), 5.0);
  EXPECT_DOUBLE_EQ(axisTop(0.061, 0.05), 0.1);
  EXPECT_DOUBLE_EQ(axisTop(10.0, 1.0), 10.0);
}

TEST(PoseText, KnownAngles) {
  const auto abc = abcDegrees(fromAbcDegrees({30.0, 20.0, 10.0}));
  EXPECT_NEAR(abc[0], 30.0, 1e-9);
  EXPECT_NEAR(abc[1], 20.0, 1e-9);
  EXPECT_NEAR(abc[2], 10.0, 1e-9);
  // A quarter turn about z takes x to y.
  const dvec3 turned = fromAbcDegrees({90.0, 0.0, 0.0}) * dvec3(1, 0, 0);
  EXPECT_NEAR(turned.y, 1.0, 1e-12);
}

RC_GTEST_PROP(PoseText, ReadsBackEveryRotation, ()) {
  const auto angle = [] { return static_cast<double>(*rc::gen::inRange(-1800, 1801)) / 10.0; };
  const dquat q = fromAbcDegrees({angle(), angle(), angle()});
  const dquat back = fromAbcDegrees(abcDegrees(q));
  RC_ASSERT(std::abs(std::abs(glm::dot(q, back)) - 1.0) < 1e-9);
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
