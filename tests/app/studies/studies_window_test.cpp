// SPDX-License-Identifier: Apache-2.0
// Studies in the whole window under a virtual display: real clicks, through StudiesPage.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>

#include "app/shell/file_opening.h"
#include "app/style/segmented.h"
#include "tests/app/pages/studies_page.h"

namespace hapticell::app {
namespace {

TEST(StudiesDock, TheWorkplaceSearchIsSavedAsAStudyAndOpened) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.trigger("actionWorkplace");
  const auto save = [&] { return page.find<QAbstractButton>("buttonSaveWorkplaceStudy"); };
  page.find<QListWidget>("listStation")->item(0)->setCheckState(Qt::Checked);
  EXPECT_FALSE(save()->isEnabled());
  EXPECT_TRUE(page.words("labelMoves").contains("no mannequin")) << page.words("labelMoves").toStdString();
  const auto bench = config::findShippedFile("workcells/workbench.hcell");
  ASSERT_TRUE(bench.has_value());
  // A shipped cell opens as a copy that is not saved yet; a file of the user has a name.
  ASSERT_TRUE(QFile::copy(QString::fromStdString(*bench), page.file("workbench.hcell")));
  ASSERT_TRUE(page.open(page.file("workbench.hcell")));
  auto* stations = page.find<QListWidget>("listStation");
  ASSERT_GT(stations->count(), 0);
  stations->item(0)->setCheckState(Qt::Checked);
  ASSERT_TRUE(save()->isEnabled());
  page.answerFile(page.file("workplace.hstudy"));
  page.click("buttonSaveWorkplaceStudy");
  ASSERT_TRUE(page.until([&] { return QFile::exists(page.file("workplace.hstudy")); }, 10000)) << page.words("labelSearch").toStdString();
  EXPECT_TRUE(page.find<QDockWidget>("dockStudy")->isVisible());
  EXPECT_EQ(page.words("labelStudyFault"), "") << "it can be run as it is";
  EXPECT_TRUE(page.find<QAbstractButton>("buttonRunStudy")->isEnabled());
  const std::string text = StudiesPage::contentOf(page.file("workplace.hstudy"));
  EXPECT_NE(text.find("cell = \"workbench.hcell\""), std::string::npos) << text;
  EXPECT_NE(text.find(stations->item(0)->text().toStdString()), std::string::npos) << text;
}

TEST(StudiesDock, AStudyIsSetUpByPointingAndRuns) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.trigger("actionStudy");
  EXPECT_FALSE(page.find<QAbstractButton>("buttonRunStudy")->isEnabled()) << "there is no study";
  page.click("buttonNewStudy");
  EXPECT_TRUE(page.words("labelStudyFault").contains("nothing varies")) << page.words("labelStudyFault").toStdString();
  page.select("robot");
  page.click("buttonFloorArea");
  ASSERT_EQ(page.lines(0), 2);
  EXPECT_TRUE(page.line(0, 0).contains("pedestal")) << "what carries the robot: " << page.line(0, 0).toStdString();
  // The corner at the right and far end goes to another place of the floor.
  page.window().viewport().setStandardView(StandardView::kTop);
  StudiesPage::settle();
  page.drag(page.pixelOfPoint({0.5, 0.5, 0.0}), page.pixelOfPoint({0.25, 0.125, 0.0}));
  page.chooseLine(0, 0);
  EXPECT_NEAR(page.find<ValueField>("fieldTo")->value(), 250.0, 8.0);
  page.type("fieldTo", "300");
  page.type("fieldSteps", "2");
  page.chooseLine(0, 1);
  EXPECT_NEAR(page.find<ValueField>("fieldTo")->value(), 125.0, 8.0);
  page.type("fieldSteps", "2");
  EXPECT_TRUE(page.words("labelVariants").startsWith("4 "));
  page.find<QAction>("add_ask_reach")->trigger();
  page.settle();
  EXPECT_TRUE(page.line(1, 0).contains("robot")) << "the only robot is meant: " << page.line(1, 0).toStdString();
  page.typeText("editSection_targets", "car-door-welds.csv");
  page.chooseText("choiceSection_frame", "door");
  page.find<QAction>("add_require")->trigger();
  page.settle();
  page.typeText("editSection_at_least", "0.2");
  page.find<QAction>("add_objective")->trigger();
  page.settle();
  page.chooseText("choiceSection_value", "reach.reached");
  page.chooseText("choiceGoal", "Large");
  EXPECT_EQ(page.words("labelStudyFault"), "");
  page.answerFile(page.file("mine.hstudy"));
  ASSERT_TRUE(page.runToTheEnd()) << page.words("labelStudyRun").toStdString();
  EXPECT_EQ(page.resultRows(), 4);
  EXPECT_TRUE(QFile::exists(page.file("mine.hresults")));
  const std::string text = StudiesPage::contentOf(page.file("mine.hstudy"));
  EXPECT_NE(text.find("cell = \"car-door.hcell\""), std::string::npos) << text;
  EXPECT_NE(text.find("to = 0.3\n"), std::string::npos) << text;
}

TEST(StudiesDock, AHandWrittenStudyKeepsWhatItSays) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.openStudy("small.hstudy");
  const std::string before = StudiesPage::contentOf(page.file("small.hstudy"));
  EXPECT_EQ(page.lines(0), 2);
  EXPECT_EQ(page.lines(1), 3);
  EXPECT_FALSE(page.find<QAbstractButton>("buttonSaveStudy")->isEnabled());
  page.chooseLine(0, 0);
  page.type("fieldFrom", "-500");
  page.click("buttonSaveStudy");
  std::string expected = before;
  expected.replace(expected.find("from = -0.6"), 11, "from = -0.5");
  EXPECT_EQ(StudiesPage::contentOf(page.file("small.hstudy")), expected) << "comments and all other lines stay";
}

TEST(StudiesDock, ResultsAreSeenChosenAndUsed) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.openStudy("small.hstudy");
  ASSERT_TRUE(page.runToTheEnd()) << page.words("labelStudyRun").toStdString();
  ASSERT_EQ(page.resultRows(), 6);
  EXPECT_EQ(page.window().viewport().scene().items({}).size() > 6, true);
  // The table, in reverse.
  auto* table = page.find<QTableView>("tableResults");
  table->sortByColumn(0, Qt::DescendingOrder);
  page.settle();
  EXPECT_EQ(page.variantIn(0), 5);
  const dvec3 given = page.document().document().findByName("pedestal")->X_WE.p;
  page.clickRow(0);
  EXPECT_TRUE(page.isShowingAVariant());
  EXPECT_TRUE(page.words("labelResults").contains("Variant 5")) << page.words("labelResults").toStdString();
  EXPECT_EQ(page.document().document().findByName("pedestal")->X_WE.p, given) << "only shown";
  const auto& scene = page.window().viewport().scene();
  const dvec3 shown = scene.placement_W(*scene.find(page.document().document().findByName("pedestal")->id)).p;
  EXPECT_NEAR(shown.x - given.x, 0.6, 1e-9);
  EXPECT_NEAR(shown.y - given.y, 0.1, 1e-9);
  page.click("buttonHideVariant");
  EXPECT_FALSE(page.isShowingAVariant());
  // The scatter chart: a click on a point.
  page.find<Segmented>("segmentsResults")->button(1)->click();
  page.settle();
  auto* scatter = page.window().findChild<ScatterChart*>();
  page.chooseText("choiceAcross", "sideways");
  page.chooseText("choiceUp", "towards_door");
  const auto place = scatter->placeOf(2);
  ASSERT_TRUE(place.has_value());
  QTest::mouseClick(scatter, Qt::LeftButton, {}, place->toPoint());
  page.settle();
  EXPECT_TRUE(page.words("labelResults").contains("Variant 2")) << page.words("labelResults").toStdString();
  QTest::keyClick(scatter, Qt::Key_Right);
  page.settle();
  EXPECT_TRUE(page.words("labelResults").contains("Variant 5")) << page.words("labelResults").toStdString();
  // Parallel coordinates: a click on a line at the first axis but one.
  page.find<Segmented>("segmentsResults")->button(2)->click();
  page.settle();
  auto* parallel = page.window().findChild<ParallelChart*>();
  ASSERT_GE(parallel->axes().size(), 4U);
  QTest::keyClick(parallel, Qt::Key_Left);
  page.settle();
  EXPECT_TRUE(page.words("labelResults").contains("Variant 4"));
  const QPointF middle = 0.5 * (parallel->placeOf(3, 0) + parallel->placeOf(3, 1));
  QTest::mouseClick(parallel, Qt::LeftButton, {}, middle.toPoint());
  page.settle();
  EXPECT_TRUE(page.words("labelResults").contains("Variant 3")) << page.words("labelResults").toStdString();
  // The document's: one step, and back.
  ASSERT_TRUE(page.clickForStep("buttonUseVariant"));
  EXPECT_FALSE(page.isShowingAVariant());
  const dvec3 used = page.document().document().findByName("pedestal")->X_WE.p;
  EXPECT_NEAR(used.x - given.x, 0.6, 1e-9);
  EXPECT_NEAR(used.y - given.y, -0.5, 1e-9);
  QThreadPool::globalInstance()->waitForDone();
  page.settle();
  for (const Message& message : page.window().messages().messages())
    EXPECT_NE(message.severity, Severity::kProblem) << message.title.toStdString();
  page.trigger("actionUndo");
  EXPECT_EQ(page.document().document().findByName("pedestal")->X_WE.p, given);
}

TEST(StudiesDock, AStoppedRunContinues) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.openStudy("small.hstudy");
  page.chooseLine(0, 0);
  page.type("fieldSteps", "60");
  page.click("buttonRunStudy");
  EXPECT_FALSE(page.find<QAbstractButton>("buttonRunStudy")->isEnabled()) << page.words("labelStudyRun").toStdString();
  ASSERT_TRUE(
      StudiesPage::until([&] { return page.words("labelStudyRun").contains(" left"); }, StudiesPage::kRunPatience));
  page.click("buttonStopStudy");
  ASSERT_TRUE(
      StudiesPage::until([&] { return page.words("labelStudyRun").contains("Stopped"); }, StudiesPage::kRunPatience))
      << page.words("labelStudyRun").toStdString();
  const int before = page.resultRows();
  EXPECT_LT(before, 180);
  ASSERT_TRUE(page.runToTheEnd()) << page.words("labelStudyRun").toStdString();
  EXPECT_EQ(page.resultRows(), 180);
}

TEST(StudiesDock, ResultsFromElsewhereAreOpenedAndSayWhatIsMissing) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.openStudy("small.hstudy");
  page.chooseLine(0, 1);
  page.type("fieldSteps", "2");
  ASSERT_TRUE(page.runToTheEnd()) << page.words("labelStudyRun").toStdString();
  const QString results = page.file("small.hresults");

  // The same folder, opened later: a click reads the study first.
  page.openResults(results);
  ASSERT_EQ(page.resultRows(), 4);
  page.clickRow(1);
  EXPECT_TRUE(StudiesPage::until([&] { return page.isShowingAVariant(); }, StudiesPage::kRunPatience));

  // Another workcell is open: charts only, and the words say why.
  page.window().documentModel().clear();
  page.settle();
  EXPECT_FALSE(page.isShowingAVariant());
  page.clickRow(2);
  EXPECT_FALSE(page.find<QAbstractButton>("buttonUseVariant")->isEnabled());
  EXPECT_TRUE(page.words("labelResults").contains("car-door.hcell")) << page.words("labelResults").toStdString();

  // A changed cell is not the one that was measured.
  ASSERT_TRUE(page.openCell());
  std::ofstream(page.file("car-door-welds.csv").toStdString(), std::ios::app) << "0,0,1,1,0,0,0\n";
  page.openResults(results);
  page.clickRow(1);
  EXPECT_TRUE(StudiesPage::until([&] { return page.words("labelResults").contains("changed since"); },
                                 StudiesPage::kRunPatience))
      << page.words("labelResults").toStdString();
  EXPECT_FALSE(page.isShowingAVariant());

  // No results at all.
  page.openResults(page.file("small.hstudy"));
  EXPECT_EQ(page.window().messages().messages().back().severity, Severity::kProblem);
}

TEST(StudiesDock, ADoubleClickOpensAStudyWithItsCell) {
  StudiesPage page;
  openAny(page.window(), page.file("small.hstudy"));
  auto* const dock = page.window().findChild<QDockWidget*>("dockStudy");
  ASSERT_NE(dock, nullptr);
  const auto hasCell = [&] { return page.document().document().path().filename() == "car-door.hcell"; };
  ASSERT_TRUE(QTest::qWaitFor(hasCell, 30000));
  page.settle();
  // Shown after the cell, whose layout would put it away.
  EXPECT_TRUE(dock->toggleViewAction()->isChecked());
  EXPECT_TRUE(page.window().findChild<StudyPanel*>()->cell().endsWith("car-door.hcell"));
}

TEST(StudiesDock, TheScriptIsShownBeforeItIsSubmitted) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.openStudy("small.hstudy");
  page.click("buttonCluster");
  EXPECT_FALSE(page.find<QAbstractButton>("buttonSubmit")->isEnabled()) << "nobody has seen it";
  page.type("fieldChunks", "3");
  page.click("buttonScript");
  const QString script = page.find<QPlainTextEdit>("textScript")->toPlainText();
  EXPECT_TRUE(script.contains("--chunk \"$SLURM_ARRAY_TASK_ID\"/3")) << script.toStdString();
  EXPECT_TRUE(page.find<QAbstractButton>("buttonSubmit")->isEnabled());
  page.type("fieldChunks", "4");
  EXPECT_FALSE(page.find<QAbstractButton>("buttonSubmit")->isEnabled()) << "the script is another one now";
}

TEST(StudiesDock, WhatIsAddedWithoutAStudySaysWhatIsNeeded) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.trigger("actionStudy");
  page.select("door");
  for (const char* entry : {"add_workplace", "add_vary_position", "add_require"}) {
    const std::size_t before = page.window().messages().messages().size();
    page.find<QAction>(entry)->trigger();
    page.settle();
    ASSERT_EQ(page.window().messages().messages().size(), before + 1) << entry;
    EXPECT_EQ(page.window().messages().messages().back().title, "No study is open");
    EXPECT_EQ(page.lines(0), 0) << entry;
  }
  EXPECT_TRUE(page.words("labelStudy").contains("Press New")) << page.words("labelStudy").toStdString();
}

TEST(StudiesDock, AWorkplaceIsOneStudy) {
  StudiesPage page;
  ASSERT_TRUE(page.openCell());
  page.trigger("actionStudy");
  page.click("buttonNewStudy");
  page.find<QAction>("add_workplace")->trigger();
  page.settle();
  EXPECT_EQ(page.lines(0), 0) << "nothing is selected";
  Diagnostics notes;
  auto worker = workcell::EntityLoader(".").load("mannequin:female:50", 1.0, notes);
  ASSERT_TRUE(worker.has_value());
  worker->name = "worker";
  ASSERT_TRUE(page.document().execute(workcell::AddEntity{*worker}));
  page.select("door");
  page.find<QAction>("add_workplace")->trigger();
  page.settle();
  EXPECT_EQ(page.lines(0), 2);
  EXPECT_EQ(page.lines(1), 1);
  EXPECT_EQ(page.words("labelStudyFault"), "");
  EXPECT_TRUE(page.words("labelVariants").startsWith("99 "));
  // The workcell has a new mannequin that its file does not have.
  page.answerFile(page.file("place.hstudy"));
  page.click("buttonRunStudy");
  EXPECT_TRUE(StudiesPage::until([&] { return page.words("labelStudyRun").contains("Save the workcell first"); },
                                 StudiesPage::kPatience))
      << page.words("labelStudyRun").toStdString();
}

}  // namespace
}  // namespace hapticell::app
