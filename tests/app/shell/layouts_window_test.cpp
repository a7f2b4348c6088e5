// SPDX-License-Identifier: Apache-2.0
// Layouts, docks and tabs by real events.
#include <gtest/gtest.h>

#include "app/kit/dock_front.h"
#include "tests/app/pages/cell_page.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

TEST(LayoutsInTheWindow, EachIsAsItWasLeft) {
  CellPage page;
  page.showDock("dockMove");
  page.window().layouts().choose("ergonomics");
  CellPage::settle();
  EXPECT_FALSE(page.find<QDockWidget>("dockWorkcell")->isVisible());
  page.window().layouts().choose("move");
  CellPage::settle();
  EXPECT_TRUE(page.find<QDockWidget>("dockWorkcell")->isVisible());
  EXPECT_FALSE(page.find<QDockWidget>("dockMove")->isHidden()) << "as it was left";
  page.trigger("actionResetLayout");
  EXPECT_TRUE(page.find<QDockWidget>("dockMove")->isHidden()) << "as it is drawn";
}

TEST(LayoutsInTheWindow, ADockThatWasMadeLaterStaysOutOfTheLayoutsBefore) {
  CellPage page;
  page.window().layouts().choose("teach");
  page.window().layouts().choose("move");
  auto* late = new QDockWidget("late", &page.window());
  late->setObjectName("dockLate");
  page.window().addDockWidget(Qt::RightDockWidgetArea, late);
  late->show();
  page.window().layouts().choose("teach");
  CellPage::settle();
  EXPECT_TRUE(late->isHidden());
  EXPECT_TRUE(page.find<QDockWidget>("dockRobot")->toggleViewAction()->isChecked()) << "what it had is there";
  page.window().layouts().choose("move");
  CellPage::settle();
  EXPECT_FALSE(late->isHidden());
}

TEST(LayoutsInTheWindow, ADockThatAKeptLayoutDoesNotKnowIsATabOfTheOthers) {
  CellPage page;
  page.window().layouts().choose("teach");  // Keeps "move" as the program before the update had it.
  auto* added = new QDockWidget("added", &page.window());
  added->setObjectName("dockOfTheUpdate");
  page.window().addDockWidget(Qt::RightDockWidgetArea, added);
  page.window().layouts().choose("move");
  added->show();
  CellPage::settle();
  const auto* robot = page.find<QDockWidget>("dockRobot");
  EXPECT_TRUE(page.window().tabifiedDockWidgets(added).contains(const_cast<QDockWidget*>(robot)));
}

bool comesToFront(MainWindow& window, const char* name) {
  const auto* dock = window.findChild<QDockWidget*>(name);
  return dock && CellPage::until([dock] { return isInFront(*dock); }, 30000);
}

QStringList shownDocks(MainWindow& window) {
  QStringList shown;
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
    if (!dock->isHidden()) shown << dock->objectName();
  shown.sort();
  return shown;
}

TEST(LayoutsInTheWindow, ErgonomicsShowsTheScoresAndThePageBesideThemWhereThereIsRoom) {
  CellPage page;
  for (const bool wide : {false, true}) {
    page.window().resize(wide ? 1560 : 1000, 800);
    CellPage::settle();
    page.window().layouts().choose("move");
    page.window().layouts().choose("ergonomics");
    page.window().layouts().reset();
    EXPECT_TRUE(comesToFront(page.window(), "dockErgonomics"));
    EXPECT_TRUE(comesToFront(page.window(), "dockErgonomicsTime"));
    const auto* report = page.find<QDockWidget>("dockReport");
    EXPECT_FALSE(report->isHidden());
    if (wide) {
      EXPECT_TRUE(comesToFront(page.window(), "dockReport"));
      EXPECT_FALSE(report->geometry().intersects(page.find<QDockWidget>("dockErgonomics")->geometry()));
    }
    const auto beside = page.window().tabifiedDockWidgets(page.find<QDockWidget>("dockErgonomics"));
    EXPECT_EQ(beside.contains(report), !wide);
  }
  page.window().layouts().choose("teach");
  page.showDock("dockReport");
  EXPECT_TRUE(page.window()
                  .tabifiedDockWidgets(page.find<QDockWidget>("dockReport"))
                  .contains(page.find<QDockWidget>("dockRobot")))
      << "other layouts have it among the tabs";
}

TEST(LayoutsInTheWindow, WhatLayInFrontLiesThereAtTheNextStart) {
  const hapticell::test::TemporaryFolder place;
  const QString file = QString::fromStdString((place.path() / "window.ini").string());
  const char* const fronts[] = {"dockErgonomics", "dockMannequin", "dockReport"};
  for (int start = 0; start <= 3; ++start) {
    MainWindow window({}, file);
    window.resize(1000, 800);
    window.show();
    window.restoreLayout();
    if (start == 0)
      window.layouts().choose("ergonomics");
    else
      EXPECT_TRUE(comesToFront(window, fronts[start - 1])) << fronts[start - 1];
    EXPECT_EQ(window.layouts().current(), "ergonomics");
    if (start == 3) break;
    CellPage::settle();
    window.findChild<QDockWidget*>(fronts[start])->raise();
    EXPECT_TRUE(comesToFront(window, fronts[start]));
    window.layouts().store();
  }
}

TEST(LayoutsInTheWindow, TheSideDocksGoAndComeBackAsTheyWere) {
  CellPage page;
  page.window().layouts().choose("ergonomics");
  EXPECT_TRUE(comesToFront(page.window(), "dockErgonomics"));
  page.find<QDockWidget>("dockReport")->raise();
  EXPECT_TRUE(comesToFront(page.window(), "dockReport"));
  const QStringList before = shownDocks(page.window());
  page.trigger("actionSideDocks");
  EXPECT_TRUE(page.find<QDockWidget>("dockReport")->isHidden());
  page.trigger("actionSideDocks");
  EXPECT_EQ(shownDocks(page.window()), before);
  EXPECT_TRUE(comesToFront(page.window(), "dockReport"));
}

TEST(LayoutsInTheWindow, ASmallWindowHasASceneAndTheForcesSwitch) {
  CellPage page;
  page.window().loadModules(ModuleLoader::defaultFolders());
  ASSERT_TRUE(page.window().startModule("Virtual Desktop"));
  page.window().resize(1366, 768);
  for (const QString& name : Layouts::names()) {
    page.window().layouts().choose(name == "move" ? "teach" : "move");
    page.window().layouts().choose(name);
    page.window().layouts().reset();
    for (int i = 0; i < 4; ++i) CellPage::settle();
    EXPECT_EQ(page.window().width(), 1366) << name.toStdString();
    const QSize scene = page.window().viewport().size();
    EXPECT_GT(scene.width() * scene.height(), 3 * 1366 * 768 / 10) << name.toStdString();
    auto* pill = page.find<QAbstractButton>("pillForces");
    EXPECT_TRUE(pill->isVisible() && !pill->visibleRegion().isEmpty()) << name.toStdString();
  }
  page.window().resize(1100, 700);
  for (int i = 0; i < 4; ++i) CellPage::settle();
  EXPECT_FALSE(page.find<QAbstractButton>("pillForces")->visibleRegion().isEmpty());
}

TEST(LayoutsInTheWindow, ASmallWindowLeavesNoNarrowColumnBehind) {
  CellPage page;
  page.window().resize(1590, 900);
  page.window().layouts().choose("ergonomics");
  page.window().layouts().reset();
  for (int i = 0; i < 4; ++i) CellPage::settle();
  auto* report = page.find<QDockWidget>("dockReport");
  const int wide = report->width();
  EXPECT_GT(wide, 300);
  page.window().resize(1100, 700);
  for (int i = 0; i < 4; ++i) CellPage::settle();
  EXPECT_TRUE(page.window().tabifiedDockWidgets(report).contains(page.find<QDockWidget>("dockErgonomics")))
      << "no column of its own where there is no room";
  page.window().resize(1590, 900);
  for (int i = 0; i < 4; ++i) CellPage::settle();
  EXPECT_NEAR(report->width(), wide, 4);
}

TEST(Tabs, ManyOnTheRightLeaveRoomForTheButtonsAtTheEnd) {
  CellPage page;
  page.window().resize(1366, 768);
  page.window().layouts().reset();
  for (const char* opens : {"actionMechanism", "actionTools", "actionMeasure", "actionMoveBy", "actionMotionPanel"})
    page.trigger(opens);
  page.showDock("dockMechanism");
  for (int i = 0; i < 6; ++i) CellPage::settle();
  const auto* mechanism = page.find<QDockWidget>("dockMechanism");
  int bars = 0;
  for (QTabBar* bar : page.window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (bar->currentIndex() < 0 || bar->tabText(bar->currentIndex()) != mechanism->windowTitle()) continue;
    ++bars;
    EXPECT_GE(bar->count(), 7);
    constexpr int kButtons = 46;  // Float and close.
    EXPECT_LE(bar->tabRect(bar->count() - 1).right(), bar->width() - kButtons);
  }
  EXPECT_EQ(bars, 1);
}

}  // namespace
}  // namespace hapticell::app
