// SPDX-License-Identifier: Apache-2.0
// The dock Training in the whole window: teaching, and every shipped exercise from its beginning to its end.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>

#include "app/host/document_model.h"
#include "app/host/recording_hub.h"
#include "app/trajectory/training/progress_plot.h"
#include "app/trajectory/training/training_panel.h"
#include "app/trajectory/training/training_report.h"
#include "config/configuration.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/engine/take_recorder.h"
#include "tests/app/pages/motion_page.h"

namespace hapticell::app {
namespace {

TEST(TrainingDock, AMotionIsTaughtRunAndScored) {
  MotionPage page;
  std::vector<std::pair<double, dvec3>> way;
  for (int i = 0; i <= 50; ++i) way.push_back({0.04 * i, {0.004 * i, 0, 0}});
  ASSERT_TRUE(page.import(way, "lesson"));
  page.trigger("actionTraining");
  auto* panel = page.window().findChild<TrainingPanel*>();
  ASSERT_NE(panel, nullptr);
  panel->setResults(page.folder().filePath("ana.htrain"));
  EXPECT_FALSE(page.find<QAbstractButton>("buttonStartRun")->isEnabled());
  page.press("buttonTeachMotion");
  EXPECT_TRUE(page.find<QAbstractButton>("buttonStartRun")->isEnabled());
  page.press("buttonStartRun");
  ASSERT_TRUE(panel->isRunning());
  ASSERT_TRUE(page.window().recording().guide().has_value()) << "the guide is handed to who moves";
  EXPECT_EQ(page.window().recording().guide()->entity, "box");
  EXPECT_GT(page.window().recording().guide()->help, 0.0);
  for (int i = 0; i <= 50 && panel->isRunning(); ++i) {
    page.window().documentModel().execute(workcell::SetPlacement{page.box(), Pose::translation({0.004 * i, 0.001, 0})});
    QTest::qWait(40);
  }
  ASSERT_TRUE(MotionPage::until([&] { return !panel->isRunning(); }, MotionPage::kPatience)) << "the end ends the run";
  ASSERT_EQ(panel->session().attempts.size(), 1u);
  const auto& attempt = panel->session().attempts.front();
  EXPECT_EQ(attempt.score.completed, 1.0);
  EXPECT_LT(attempt.score.max_deviation, 0.005);
  EXPECT_FALSE(page.window().recording().guide().has_value());
  EXPECT_TRUE(QFile::exists(page.folder().filePath("ana.htrain")));
  if (attempt.success) {
    EXPECT_NEAR(panel->session().nextHelp(), 0.8, 1e-9);
  }
  for (const char* name : {"results.pdf", "results.csv"}) {
    const QString path = page.folder().filePath(name);
    ASSERT_TRUE(writeTrainingReport(path, panel->session(), 60.0).has_value());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().startsWith(QString(name).endsWith("pdf") ? "%PDF" : "attempt,"));
  }
  EXPECT_FALSE(writeTrainingReport("/nowhere/at/all.pdf", panel->session(), 60.0).has_value());
}

TEST(TrainingDock, AnExerciseThatIsNotThereIsRefused) {
  MotionPage page;
  auto* panel = page.window().findChild<TrainingPanel*>();
  ASSERT_NE(panel, nullptr);
  EXPECT_FALSE(panel->openExercise("/nowhere.hexercise"));
}

/// A motion of the box along x, taught; the cell is saved.
struct LessonPage : MotionPage {
  LessonPage() {
    std::vector<std::pair<double, dvec3>> way;
    for (int i = 0; i <= 50; ++i) way.push_back({0.04 * i, {0.1 + 0.004 * i, 0, 0}});
    EXPECT_TRUE(import(way, "lesson"));
    EXPECT_TRUE(model().save(folder().filePath("cell.hcell")).has_value());
    trigger("actionTraining");
    panel = window().findChild<TrainingPanel*>();
    panel->setResults(folder().filePath("ana.htrain"));
    press("buttonTeachMotion");
  }
  DocumentModel& model() { return window().documentModel(); }
  double boxAt() { return document().find(box())->X_WE.p.x; }
  void put(double x) { model().execute(workcell::SetPlacement{box(), Pose::translation({x, 0, 0})}); }
  /// The whole way, to its end.
  bool run() {
    for (int i = 0; i <= 50 && panel->isRunning(); ++i) {
      put(0.1 + 0.004 * i);
      QTest::qWait(40);
    }
    return until([&] { return !panel->isRunning(); }, kPatience);
  }
  TrainingPanel* panel = nullptr;
};

TEST(TrainingDock, ARunLeavesNoTraceInTheCell) {
  LessonPage page;
  const auto steps = page.document().undoTexts();
  ASSERT_FALSE(page.model().isDirty());
  page.press("buttonStartRun");
  ASSERT_TRUE(page.panel->isRunning());
  EXPECT_NEAR(page.boxAt(), 0.1, 1e-12) << "where the expert began";
  page.put(0.15);
  EXPECT_FALSE(page.model().isDirty());
  EXPECT_FALSE(page.window().windowTitle().contains('*')) << page.window().windowTitle().toStdString();
  EXPECT_FALSE(page.enabled("actionUndo"));
  ASSERT_TRUE(page.run());
  EXPECT_EQ(page.boxAt(), 0.0) << "back in its place";
  EXPECT_FALSE(page.model().isDirty());
  EXPECT_EQ(page.document().undoTexts(), steps);
  EXPECT_EQ(page.panel->session().attempts.size(), 1u);
  page.put(0.3);
  EXPECT_TRUE(page.model().isDirty()) << "after it, moving is a change again";
}

TEST(TrainingDock, AChangeOfTheCellEndsTheRunFirst) {
  LessonPage page;
  page.press("buttonStartRun");
  page.put(0.15);
  ASSERT_TRUE(page.model().execute(workcell::RenameEntity{page.box(), "crate"}));
  EXPECT_FALSE(page.panel->isRunning());
  EXPECT_TRUE(page.panel->session().attempts.empty());
  EXPECT_EQ(page.document().find(page.box())->name, "crate");
  EXPECT_EQ(page.boxAt(), 0.0);
  page.model().undo();
  EXPECT_EQ(page.document().find(page.box())->name, "box");
  EXPECT_FALSE(page.model().isDirty());
  EXPECT_FALSE(page.window().recording().isRecording());
}

TEST(TrainingDock, ADragThatIsCancelledInARunTakesBackItsOwnMovesAlone) {
  LessonPage page;
  DocumentModel& model = page.model();
  const auto steps = page.document().undoTexts();
  model.beginTrial();
  page.put(0.1);
  model.beginStep("drag");
  model.executeWithin({workcell::SetPlacement{page.box(), Pose::translation({0.2, 0, 0})}});
  model.cancelStep();
  EXPECT_EQ(page.boxAt(), 0.1);
  model.beginStep("drag");
  model.executeWithin({workcell::SetPlacement{page.box(), Pose::translation({0.3, 0, 0})}});
  model.endTrial();
  EXPECT_EQ(page.boxAt(), 0.0);
  // The hand is still on it.
  model.executeWithin({workcell::SetPlacement{page.box(), Pose::translation({0.4, 0, 0})}});
  model.endStep();
  EXPECT_EQ(page.boxAt(), 0.0);
  EXPECT_EQ(page.document().undoTexts(), steps);
  EXPECT_FALSE(model.isDirty());
}

TEST(TrainingDock, ForcesAreAskedForAtTheStart) {
  LessonPage page;
  EXPECT_FALSE(page.find<QAbstractButton>("buttonStartWithoutForces")->isEnabled()) << "no stylus, no forces";
  QAction forces;
  forces.setObjectName("actionForcesOn");
  forces.setParent(&page.window());
  QSignalSpy switched(&forces, &QAction::triggered);
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.connected = true;
  page.window().setSnapshot(snapshot);
  const auto* start = page.find<QAbstractButton>("buttonStartRun");
  const QString plain = start->text();
  ASSERT_TRUE(MotionPage::until([&] { return start->text() != plain; }, MotionPage::kPatience));
  page.press("buttonStartRun");
  EXPECT_EQ(switched.count(), 1);
  EXPECT_TRUE(page.panel->isRunning());
  page.press("buttonStartRun");
  ASSERT_TRUE(MotionPage::until([&] { return !page.panel->isRunning(); }, MotionPage::kPatience));
  page.press("buttonStartWithoutForces");
  EXPECT_EQ(switched.count(), 1);
  EXPECT_TRUE(page.panel->isRunning());
  page.window().setSnapshot(std::nullopt);
}

/// What is missing is told below its field, and nothing is saved; then it is saved, found, opened and changed again.
TEST(TrainingDock, AnExerciseIsMadeInTheWindowAndChangedLater) {
  LessonPage page;
  const QString folder = page.folder().filePath("own");
  page.panel->setExercises(folder);
  auto* choice = page.find<QComboBox>("comboExercise");
  const int before = choice->count();
  page.put(0.05);
  page.press("buttonNewExercise");
  EXPECT_EQ(page.find<QComboBox>("comboExpertMotion")->currentText(), "lesson");
  EXPECT_EQ(page.words("labelHeldPart"), "box");
  page.press("buttonSaveExercise");
  EXPECT_FALSE(page.words("problemName").isEmpty());
  EXPECT_FALSE(page.words("problemText").isEmpty());
  EXPECT_FALSE(page.words("problemCell").isEmpty()) << "the cell differs from its file";
  EXPECT_TRUE(page.words("problemMotion").isEmpty());
  EXPECT_FALSE(QDir(folder).exists());
  page.find<QLineEdit>("editExerciseName")->setText("Crate over");
  page.find<QPlainTextEdit>("editExerciseText")->setPlainText("Bring the box to the wall.");
  EXPECT_TRUE(page.words("problemText").isEmpty());
  page.find<ValueField>("fieldExerciseTube")->setValue(12.5);
  page.find<ValueField>("fieldExercisePass")->setValue(70);
  page.model().undo();
  EXPECT_TRUE(page.words("problemCell").isEmpty()) << "told anew when the cell is as its file";
  page.press("buttonSaveExercise");
  QTest::qWait(1);
  for (const char* name : {"problemName", "problemText", "problemMotion", "problemCell", "problemFile"}) {
    const auto* label = page.window().findChild<QLabel*>(name);
    EXPECT_EQ(label ? label->text() : QString(), "") << name;
  }
  const QString file = QDir(folder).filePath("Crate-over.hexercise");
  const auto saved = manipulation::readExercise(file.toStdString());
  ASSERT_TRUE(saved.has_value()) << saved.error().message();
  EXPECT_EQ(saved->text, "Bring the box to the wall.");
  EXPECT_NEAR(saved->tube_radius, 0.0125, 1e-12);
  EXPECT_EQ(saved->pass, 70.0);
  EXPECT_EQ(saved->workcell, page.document().path());
  const auto expert = trajectory::readTrajectory(saved->recording);
  ASSERT_TRUE(expert.has_value());
  EXPECT_EQ(expert->size(), 51u);
  EXPECT_EQ(choice->count(), before + 1);
  EXPECT_EQ(choice->currentText(), "Crate over") << "chosen at once";
  EXPECT_EQ(page.words("labelExercise"), "Bring the box to the wall.");
  // Again: the same file, another name refused that is taken, numbers kept that were not touched.
  page.press("buttonNewExercise");
  page.find<QLineEdit>("editExerciseName")->setText("Crate over");
  page.press("buttonSaveExercise");
  EXPECT_FALSE(page.words("problemName").isEmpty()) << "there is one of this name";
  page.window().findChild<QDialog*>("exerciseEditor")->close();
  QTest::qWait(1);
  page.settle();
  page.press("buttonEditExercise");
  EXPECT_EQ(page.find<QLineEdit>("editExerciseName")->text(), "Crate over");
  page.find<QPlainTextEdit>("editExerciseText")->setPlainText("Slowly.");
  page.press("buttonSaveExercise");
  page.settle();
  const auto again = manipulation::readExercise(file.toStdString());
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->text, "Slowly.");
  EXPECT_EQ(again->tube_radius, saved->tube_radius);
  EXPECT_EQ(again->recording, saved->recording);
  EXPECT_EQ(choice->count(), before + 1);
}

TEST(TrainingDock, TheExpertIsShownAndTheRunBesideIt) {
  LessonPage page;
  const auto steps = page.document().undoTexts();
  page.press("buttonShowMe");
  EXPECT_TRUE(MotionPage::until([&] { return page.shownBox().p.x > 0.12; }, MotionPage::kPatience)) << "it goes";
  EXPECT_EQ(page.boxAt(), 0.0);
  page.press("buttonShowMe");
  EXPECT_EQ(page.shownBox().p.x, 0.0) << "stopped: the cell as it is";
  EXPECT_FALSE(page.find<QAbstractButton>("buttonReplayRun")->isEnabled()) << "no run yet";
  page.press("buttonStartRun");
  ASSERT_TRUE(page.run());
  ASSERT_TRUE(page.find<QAbstractButton>("buttonReplayRun")->isEnabled());
  page.press("buttonReplayRun");
  const auto ghosts = [&] { return page.window().viewport().scene().ghosts(); };
  EXPECT_TRUE(MotionPage::until([&] { return page.shownBox().p.x > 0.12; }, MotionPage::kPatience));
  ASSERT_EQ(ghosts().size(), 1u) << "the expert beside the run";
  EXPECT_EQ(ghosts().front().entity, page.box());
  EXPECT_TRUE(MotionPage::until([&] { return ghosts().empty(); }, MotionPage::kPatience)) << "it ends by itself";
  EXPECT_EQ(page.shownBox().p.x, 0.0);
  EXPECT_EQ(page.document().undoTexts(), steps);
  EXPECT_FALSE(page.model().isDirty());
}

TEST(TrainingDock, RunsWithoutGuidanceAreScoredApart) {
  LessonPage page;
  auto* kind = page.find<QComboBox>("comboRunKind");
  kind->setCurrentIndex(1);
  page.press("buttonStartRun");
  EXPECT_FALSE(page.panel->isRunning()) << "nothing was practised that could be retained";
  EXPECT_FALSE(page.words("labelRun").isEmpty());
  kind->setCurrentIndex(0);
  page.press("buttonStartRun");
  ASSERT_TRUE(page.run());
  const double help = page.panel->session().nextHelp();
  kind->setCurrentIndex(2);
  page.press("buttonStartRun");
  EXPECT_FALSE(page.panel->isRunning()) << "what was practised shows no transfer";
  kind->setCurrentIndex(1);
  page.press("buttonStartRun");
  ASSERT_TRUE(page.panel->isRunning());
  EXPECT_FALSE(page.panel->isLed());
  ASSERT_TRUE(page.window().recording().guide().has_value());
  EXPECT_FALSE(page.window().recording().guide()->enabled) << "no guidance";
  ASSERT_TRUE(page.run());
  const auto kept = trajectory::readTraining(page.folder().filePath("ana.htrain").toStdString());
  ASSERT_TRUE(kept.has_value());
  ASSERT_EQ(kept->attempts.size(), 2u);
  EXPECT_EQ(kept->attempts[0].kind, trajectory::RunKind::kPractice);
  EXPECT_EQ(kept->attempts[1].kind, trajectory::RunKind::kRetention);
  EXPECT_EQ(kept->attempts[1].help, 0.0);
  EXPECT_EQ(kept->nextHelp(), help);
  EXPECT_TRUE(page.words("labelUnaided").contains("Retention")) << page.words("labelUnaided").toStdString();
  EXPECT_TRUE(page.find<QComboBox>("comboRuns")->itemText(0).contains("Retention"));
  const QString table = page.folder().filePath("apart.csv");
  ASSERT_TRUE(writeTrainingReport(table, page.panel->session(), 60.0).has_value());
  QFile file(table);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains(",retention,"));
}

class ShippedExercise : public testing::TestWithParam<const char*> {};

/// Chosen in the list, its cell opened, run, ended by its end, scored, kept, plotted, written as CSV and PDF.
TEST_P(ShippedExercise, IsPlayedToItsEnd) {
  MotionPage page;
  page.window().documentModel().clear();
  page.trigger("actionTraining");
  auto* panel = page.window().findChild<TrainingPanel*>();
  auto* choice = page.find<QComboBox>("comboExercise");
  const auto folder = config::findShippedFile("exercises");
  ASSERT_TRUE(folder.has_value());
  const auto exercise = manipulation::readExercise(std::filesystem::path(*folder) / GetParam());
  ASSERT_TRUE(exercise.has_value());
  const int index = choice->findText(QString::fromStdString(exercise->name));
  ASSERT_GT(index, 0);
  choice->setCurrentIndex(index);
  emit choice->activated(index);
  const auto expert = trajectory::readTrajectory(exercise->recording);
  ASSERT_TRUE(expert.has_value());
  ASSERT_TRUE(
      MotionPage::until([&] { return page.document().findByName(expert->entity) != nullptr; }, MotionPage::kPatience));
  EXPECT_EQ(page.words("labelExercise"), QString::fromStdString(exercise->text));
  const QString results = page.folder().filePath("ben.htrain");
  panel->setResults(results);
  const auto replay = manipulation::MotionReplay::create(page.state().entities, expert->entity,
                                                         std::make_shared<const trajectory::Trajectory>(*expert));
  ASSERT_TRUE(replay.has_value()) << replay.error().message();
  page.press("buttonStartRun");
  ASSERT_TRUE(panel->isRunning());
  EXPECT_EQ(page.window().selection().current(), replay->entity()) << "the stylus takes it";
  EXPECT_EQ(manipulation::wordOf(page.window().holdChoice().movedBy(), false), expert->moved);
  // The trainee goes on only when the window has seen where the part is.
  QSignalSpy looks(panel, &TrainingPanel::guideChanged);
  double before = -1.0;
  constexpr int kSteps = 40;
  for (int i = 1; i <= kSteps && panel->isRunning(); ++i) {
    const auto at = replay->at((*expert)[0].t + expert->duration() * i / kSteps);
    page.window().documentModel().execute(workcell::SetConfiguration{replay->entity(), at.X_WE, at.joints});
    const auto seen = looks.count();
    ASSERT_TRUE(MotionPage::until([&] { return looks.count() > seen || !panel->isRunning(); }, MotionPage::kPatience));
    if (!panel->isRunning()) break;
    EXPECT_GE(panel->expertTime(), before - 1e-9) << i;
    before = panel->expertTime();
  }
  ASSERT_TRUE(MotionPage::until([&] { return !panel->isRunning(); }, MotionPage::kPatience)) << "its end ends the run";
  ASSERT_EQ(panel->session().attempts.size(), 1u);
  const auto& attempt = panel->session().attempts.front();
  EXPECT_EQ(attempt.score.completed, 1.0);
  EXPECT_LT(attempt.score.mean_deviation, 0.002);
  EXPECT_EQ(attempt.help, 1.0);
  const auto kept = trajectory::readTraining(results.toStdString());
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->exercise, exercise->name);
  EXPECT_EQ(kept->attempts.size(), 1u);
  EXPECT_TRUE(page.find<ProgressPlot>("progressPlot")->accessibleDescription().contains('1'));
  for (const char* name : {"results.csv", "results.pdf"}) {
    const QString path = page.folder().filePath(name);
    page.answerFileDialog(path);
    page.press("buttonExportResults");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << name;
    EXPECT_TRUE(file.readAll().startsWith(QString(name).endsWith("pdf") ? "%PDF" : "attempt,")) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedExercise,
                         testing::Values("peg_in_hole.hexercise", "door.hexercise", "screw.hexercise",
                                         "extraction.hexercise"));

}  // namespace
}  // namespace hapticell::app
